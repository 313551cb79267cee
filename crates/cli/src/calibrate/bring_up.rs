//! Finds boards on links, and arms them with nominal calibrations.

use std::path::PathBuf;

use boards::calibrate::Bench;
use boards::calibration::file;
use boards::keybed::{Calibrated, FoundBoard, Identified, Keybed, Offline, Terms, WantedBoards};
use boards::refusal::{BoardName, Refusals};
use firmware_protocol::frame::key_forces::ForcePacking;
use firmware_protocol::frame::key_samples::SamplePacking;
use firmware_protocol::key::KeyIndex;

use super::Endings;
use super::operator::Operator;
use crate::Failure;
use crate::target::SceneTarget;
use host::connected_boards::{PATIENCE_US, calibration, clock, folder, open_all, unmeasured};
use scene::{Boards, Scene};

/// Exchange rate (Hz): more would load slow buses without more information.
pub(super) const HZ: u32 = 500;
/// Longest validity of forces (ms), since the system may be late.
const VALID_MS: u8 = firmware_protocol::acyclic::arm::LONGEST_VALID_MS;

/// A board under measurement, with its file.
#[derive(Clone, Debug)]
pub(super) struct MeasuredBoard {
    pub(super) found: FoundBoard,
    pub(super) name: BoardName,
    pub(super) file: PathBuf,
}

pub(super) struct Ready {
    pub(super) boards: Vec<MeasuredBoard>,
    pub(super) keybed: Keybed<Calibrated>,
}

/// A selected key whose board is not armed yet.
pub(super) struct ReadyKey {
    pub(super) scene: Scene,
    pub(super) found: FoundBoard,
    pub(super) name: BoardName,
    pub(super) key: KeyIndex,
    pub(super) keybed: Keybed<Calibrated>,
}

/// Finds the selected boards, and asks the operator about their files.
pub(super) fn find(
    target: &SceneTarget,
    only: Option<u8>,
    chosen: Option<PathBuf>,
    operator: &Operator,
) -> Result<Ready, Failure> {
    let (_scene, asked) = target.boards()?;
    let folder = chosen.or_else(|| folder(&asked)).ok_or_else(|| {
        Failure::Usage("there is no home for calibration files; give --folder".into())
    })?;
    let keybed = identified(&asked, only)?;
    let boards: Vec<_> = keybed
        .boards()
        .iter()
        .map(|found| MeasuredBoard {
            found: *found,
            name: keybed.name(found),
            file: file::path(&folder, found.uid()),
        })
        .collect();
    let there: Vec<_> = boards.iter().map(|it| it.file.clone()).filter(|it| it.exists()).collect();
    operator.may_overwrite(&there)?;
    let wanted = WantedBoards { hz: HZ, ..WantedBoards::default() };
    let keybed =
        keybed.calibrate(&wanted, |found, _name| Ok(unmeasured(found))).map_err(refused)?;
    Ok(Ready { boards, keybed })
}

/// Finds the first selected board, or the one that has `key`, and reads how its keys are encoded.
pub(super) fn find_key(
    target: &SceneTarget,
    only: Option<u8>,
    chosen: Option<PathBuf>,
    key: Option<KeyIndex>,
) -> Result<ReadyKey, Failure> {
    let (scene, mut asked) = target.boards()?;
    asked.calibration = chosen.or(asked.calibration);
    let mut keybed = identified(&asked, only)?;
    let has = |found: &FoundBoard, key: KeyIndex| {
        let keys = found.keys();
        (keys.first..keys.first.saturating_add(keys.n)).contains(&key.number())
    };
    let found = keybed.boards().iter().find(|found| key.is_none_or(|key| has(found, key)));
    let Some(found) = found.copied() else {
        return Err(nobody(&asked, &key.map_or_else(String::new, |key| format!("key {key}"))));
    };
    let key = key.or_else(|| KeyIndex::new(found.keys().first));
    let key = key.ok_or_else(|| nobody(&asked, "key"))?;
    let name = keybed.name(&found);
    keybed.keep(|it| it.uid() == found.uid());
    let wanted = WantedBoards { hz: scene.tick_hz, ..WantedBoards::default() };
    let keybed = keybed
        .calibrate(&wanted, |found, name| calibration(found, name, &asked))
        .map_err(refused)?;
    Ok(ReadyKey { scene, found, name, key, keybed })
}

/// Opens the links, and identifies the boards on them; with `only`, the board of this number.
fn identified(asked: &Boards, only: Option<u8>) -> Result<Keybed<Identified>, Failure> {
    let clock = clock(&asked.buses);
    let lines = open_all(&asked.buses, &clock).map_err(Failure::Running)?;
    let mut keybed = Keybed::<Offline>::new(lines, clock).identify(PATIENCE_US).map_err(refused)?;
    keybed.keep(|found| only.is_none_or(|number| found.board.number() == number));
    match only {
        Some(number) if keybed.boards().is_empty() => {
            Err(nobody(asked, &format!("number {number}")))
        }
        Some(_) | None => Ok(keybed),
    }
}

fn nobody(asked: &Boards, what: &str) -> Failure {
    let links: Vec<_> =
        asked.buses.iter().map(|bus| format!("--link {}", bus.address.typed())).collect();
    Failure::Usage(format!(
        "no board has the {what}; `letoff devices --boards {}` lists those there are",
        links.join(" ")
    ))
}

/// Arms `keybed` with an exchange rate of `hz`; `endings` stop its measurements.
pub(super) fn arm(
    keybed: Keybed<Calibrated>,
    hz: u32,
    endings: &Endings,
) -> Result<Box<Bench>, Failure> {
    let terms = Terms {
        period_us: u16::try_from(1_000_000 / hz).unwrap_or(u16::MAX),
        samples: SamplePacking::default(),
        forces: ForcePacking::default(),
        valid_ms: VALID_MS,
    };
    let armed = endings.emergency.while_arming(|| keybed.arm(terms, PATIENCE_US));
    let endings = endings.clone();
    let bench = Bench::watched(armed.map_err(refused)?, move |keybed| endings.look(keybed));
    Ok(Box::new(bench))
}

#[expect(clippy::needless_pass_by_value, reason = "fits map_err")]
fn refused(refusals: Refusals) -> Failure {
    Failure::Running(refusals.to_string())
}
