//! Finds boards on links, and arms them with nominal calibrations.

use std::path::PathBuf;

use firmware_protocol::frame::key_forces::ForcePacking;
use firmware_protocol::frame::key_samples::SamplePacking;
use hardware::calibrate::Bench;
use hardware::calibration::file;
use hardware::keybed::{Calibrated, FoundBoard, Keybed, Offline, Terms, WantedBoards};
use hardware::refusal::{BoardName, Refusals};

use super::Endings;
use super::operator::Operator;
use crate::Failure;
use crate::target::SceneTarget;
use host::boards::{PATIENCE_US, folder, now_us, open_all, unmeasured};

/// Exchanges a second: more would load slow buses, and say no more.
const HZ: u32 = 500;
/// Forces are valid for as long as they can be: the system may be late (ms).
const VALID_MS: u8 = firmware_protocol::acyclic::arm::LONGEST_VALID_MS;

/// A board that is measured, and its file.
#[derive(Clone, Debug)]
pub(super) struct MeasuredBoard {
    pub(super) found: FoundBoard,
    pub(super) name: BoardName,
    pub(super) file: PathBuf,
}

/// Boards that are meant, and not armed yet.
pub(super) struct Ready {
    pub(super) boards: Vec<MeasuredBoard>,
    pub(super) keybed: Keybed<Calibrated>,
}

/// Finds the boards that are meant, until the operator has agreed to the files.
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
    let lines = open_all(&asked.buses).map_err(Failure::Running)?;
    let mut keybed =
        Keybed::<Offline>::new(lines, now_us).identify(PATIENCE_US).map_err(refused)?;
    keybed.keep(|found| only.is_none_or(|number| found.board.number() == number));
    let boards: Vec<_> = keybed
        .boards()
        .iter()
        .map(|found| MeasuredBoard {
            found: *found,
            name: keybed.name(found),
            file: file::path(&folder, found.uid()),
        })
        .collect();
    if let (true, Some(number)) = (boards.is_empty(), only) {
        let links: Vec<_> =
            asked.buses.iter().map(|bus| format!("--link {}", bus.address)).collect();
        return Err(Failure::Usage(format!(
            "no board has the number {number}; `letoff devices --boards {}` lists those there are",
            links.join(" ")
        )));
    }
    let there: Vec<_> = boards.iter().map(|it| it.file.clone()).filter(|it| it.exists()).collect();
    operator.may_overwrite(&there)?;
    let wanted = WantedBoards { hz: HZ, ..WantedBoards::default() };
    let keybed =
        keybed.calibrate(&wanted, |found, _name| Ok(unmeasured(found))).map_err(refused)?;
    Ok(Ready { boards, keybed })
}

/// Arms `keybed`, whose measurements end as `endings` say.
pub(super) fn arm(keybed: Keybed<Calibrated>, endings: &Endings) -> Result<Box<Bench>, Failure> {
    let terms = Terms {
        period_us: u16::try_from(1_000_000 / HZ).unwrap_or(u16::MAX),
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
