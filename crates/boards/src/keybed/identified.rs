//! The stage of boards with known names: check of their keys and calibration.

use firmware_protocol::frame::hello::{Hello, feature};
use firmware_protocol::frame::key_forces::{ForceLayout, ForcePacking};
use firmware_protocol::frame::key_samples::{SampleLayout, SamplePacking};
use firmware_protocol::key::{BoardId, PerKey};
use keyboard::{KeyIndex, KeyRange};

use super::{Calibrated, Keybed, NamedLink};
use crate::calibration::KeyCalibration;
use crate::hello_values::impossible_values;
use crate::identity::{ClaimedKeys, Uid};
use crate::refusal::{BoardName, Refusal, Refusals};
use crate::rt::board::BoardTerms;
use crate::topology::BoardPlace;

/// A board that answered.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct FoundBoard {
    pub line: usize,
    pub board: BoardId,
    pub hello: Hello,
}

impl FoundBoard {
    pub(super) fn name(&self, lines: &[NamedLink]) -> BoardName {
        let line = lines.get(self.line).map_or_else(String::new, |line| line.name.clone());
        BoardName { line, number: self.board.number() }
    }

    pub const fn uid(&self) -> Uid {
        Uid(self.hello.uid)
    }

    pub const fn keys(&self) -> ClaimedKeys {
        ClaimedKeys { first: self.hello.first_key, n: self.hello.n_keys }
    }

    /// Returns the calibration of its keys before any measurement.
    pub fn nominal(&self) -> KeyCalibration {
        KeyCalibration::nominal(f64::from(self.hello.quantum_nm) * 1e-9)
    }

    fn place(&self) -> Option<BoardPlace> {
        let first_key = KeyIndex::new(self.hello.first_key)?;
        let n_keys = self.hello.n_keys.into();
        let place = BoardPlace { line: self.line, board: self.board, first_key, n_keys };
        place.is_possible().then_some(place)
    }
}

/// Boards that are known by name.
#[derive(Clone, PartialEq, Debug)]
pub struct Identified {
    pub(super) found: Vec<FoundBoard>,
}

/// A scene's requirements of boards.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct WantedBoards {
    pub samples: SamplePacking,
    pub forces: ForcePacking,
    /// Required boards, by line and number, with their keys.
    pub boards: Vec<(usize, u8, KeyRange)>,
    pub hz: u32,
}

impl Keybed<Identified> {
    pub fn boards(&self) -> &[FoundBoard] {
        &self.stage.found
    }

    pub fn keep(&mut self, are_wanted: impl FnMut(&FoundBoard) -> bool) {
        self.stage.found.retain(are_wanted);
    }

    pub fn name(&self, found: &FoundBoard) -> BoardName {
        found.name(&self.lines)
    }

    /// Checks the boards' keys and abilities, and sets their calibration. `calibration` returns it
    /// for a board, or the reason why it is unknown.
    ///
    /// # Errors
    /// All faults of all boards.
    pub fn calibrate(
        self,
        wanted: &WantedBoards,
        calibration: impl Fn(&FoundBoard, &BoardName) -> Result<PerKey<KeyCalibration>, Refusal>,
    ) -> Result<Keybed<Calibrated>, Refusals> {
        let Self { lines, stage, clock } = self;
        let mut refusals = Vec::new();
        let mut boards = Vec::new();
        for found in &stage.found {
            let name = found.name(&lines);
            let values = impossible_values(&found.hello);
            if !values.is_empty() {
                let refusal = |value| Refusal::Value { board: name.clone(), value };
                refusals.extend(values.into_iter().map(refusal));
                continue;
            }
            refuse_unable(found, &name, wanted, &mut refusals);
            let Some(place) = found.place() else {
                refusals.push(Refusal::Keys { board: name, keys: found.keys() });
                continue;
            };
            match calibration(found, &name) {
                Ok(calibration) => {
                    boards.push(terms(place, wanted, &calibration, found.hello.max_force_mn));
                }
                Err(refusal) => refusals.push(refusal),
            }
        }
        refuse_shared_keys(&stage.found, &lines, &mut refusals);
        refuse_other_boards(&stage.found, wanted, &lines, &mut refusals);
        if refusals.is_empty() {
            let uids = stage.found.iter().map(|found| found.hello.uid).collect();
            let features = stage.found.iter().map(|found| found.hello.features).collect();
            let stage = Calibrated { boards, uids, features };
            Ok(Keybed { lines, stage, clock })
        } else {
            Err(Refusals(refusals))
        }
    }
}

const fn terms(
    place: BoardPlace,
    wanted: &WantedBoards,
    calibration: &PerKey<KeyCalibration>,
    max_force_mn: u16,
) -> BoardTerms {
    BoardTerms {
        place,
        samples: SampleLayout { packing: wanted.samples, n_keys: place.n_keys },
        forces: ForceLayout { packing: wanted.forces, n_keys: place.n_keys },
        calibration: *calibration,
        max_force_mn,
    }
}

fn refuse_unable(
    found: &FoundBoard,
    name: &BoardName,
    wanted: &WantedBoards,
    refusals: &mut Vec<Refusal>,
) {
    let mut unable = |what, instead: String| {
        refusals.push(Refusal::Unable { board: name.clone(), what, instead });
    };
    let Hello { features, max_sample_hz, max_force_hz, .. } = found.hello;
    if wanted.samples.has_velocity() && features & feature::VELOCITY == 0 {
        unable("measure velocities", "give `samples = \"position24\"` in [links]".into());
    }
    if wanted.forces == ForcePacking::Force16Slope && features & feature::SLOPES == 0 {
        unable("render slopes", "give `forces = \"force16\"` in [links]".into());
    }
    if wanted.forces == ForcePacking::Force16Slope && !wanted.samples.has_velocity() {
        let instead = "give `samples = \"position24-velocity\"` in [links]";
        unable("render slopes without velocities in its samples", instead.into());
    }
    if wanted.forces == ForcePacking::Multicast16 && features & feature::MULTICAST == 0 {
        unable("take forces for all boards", "give `forces = \"force16\"` in [links]".into());
    }
    let fastest = max_sample_hz.min(max_force_hz);
    if u32::from(fastest) < wanted.hz {
        let instead = format!("give `tick_hz = {fastest}` or less");
        unable("keep the scene's rate", instead);
    }
}

fn refuse_shared_keys(found: &[FoundBoard], lines: &[NamedLink], refusals: &mut Vec<Refusal>) {
    for (n, one) in found.iter().enumerate() {
        for other in &found[n + 1..] {
            let keys = |it: &FoundBoard| {
                it.hello.first_key..it.hello.first_key.saturating_add(it.hello.n_keys)
            };
            let shared = keys(one).find(|key| keys(other).contains(key)).and_then(KeyIndex::new);
            if let Some(key) = shared {
                let (one, other) = (one.name(lines), other.name(lines));
                refusals.push(Refusal::KeyTwice { one, other, key });
            }
        }
    }
}

fn refuse_other_boards(
    found: &[FoundBoard],
    wanted: &WantedBoards,
    lines: &[NamedLink],
    refusals: &mut Vec<Refusal>,
) {
    for (line, number, scene) in &wanted.boards {
        let board = BoardName {
            line: lines.get(*line).map_or_else(String::new, |line| line.name.clone()),
            number: *number,
        };
        let it = found.iter().find(|it| it.line == *line && it.board.number() == *number);
        match it.map(FoundBoard::keys) {
            None => refusals.push(Refusal::Missing { board }),
            Some(says) if says.range() != Some(*scene) => {
                refusals.push(Refusal::OtherKeys { board, says, scene: *scene });
            }
            Some(_) => {}
        }
    }
}
