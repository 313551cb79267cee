//! Writes measurements into files and to the boards.

use std::path::PathBuf;

use firmware_protocol::Nothing;
use firmware_protocol::acyclic::{Operation, Status};
use firmware_protocol::key::{KeyIndex, PerKey};
use hardware::calibrate::record;
use hardware::calibration::{KeyCalibration, file};
use hardware::keybed::{Armed, Keybed};
use hardware::refusal::Refusal;
use serde::Serialize;
use time::OffsetDateTime;
use time::format_description::BorrowedFormatItem;
use time::macros::format_description;

use super::bring_up::MeasuredBoard;

/// How a file says when it was made.
const MADE: &[BorrowedFormatItem<'_>] =
    format_description!("[year]-[month]-[day] [hour]:[minute] UTC");

/// A board whose file was written.
#[derive(Debug, Serialize)]
pub(super) struct Written {
    pub(super) link: String,
    pub(super) number: u8,
    pub(super) uid: String,
    pub(super) file: PathBuf,
    pub(super) keys: Vec<MeasuredKeyRow>,
}

/// The measurements of one key.
#[derive(Debug, Serialize)]
pub(super) struct MeasuredKeyRow {
    pub(super) key: String,
    pub(super) rest: i32,
    pub(super) bottom: i32,
    pub(super) travel_mm: f64,
    pub(super) friction_n: f64,
    pub(super) gain: f64,
}

/// The outcome for the keys of one board.
#[derive(Debug)]
pub(super) enum MeasureOutcome {
    /// All of them, in the order of slots.
    All(Vec<(KeyIndex, KeyCalibration)>),
    /// The faults of keys that could not be measured, and the number of all keys.
    Faults(Vec<Refusal>, usize),
    /// The measurements were stopped.
    Stopped,
}

/// The files that were written, and the mistakes.
#[derive(Debug, Default)]
pub(super) struct CalibrationRecord {
    pub(super) written: Vec<Written>,
    pub(super) wrong: Vec<String>,
    /// The records that boards have to be sent.
    untold: Vec<(MeasuredBoard, Vec<KeyCalibration>)>,
}

impl CalibrationRecord {
    /// Writes the measurements of a board into its file, or records why there are none.
    pub(super) fn keep(&mut self, board: &MeasuredBoard, outcome: MeasureOutcome) {
        let name = &board.name;
        match outcome {
            MeasureOutcome::All(keys) => self.write(board, &keys),
            MeasureOutcome::Faults(refusals, of) => {
                self.wrong.extend(refusals.iter().map(ToString::to_string));
                self.wrong.push(format!(
                    "{name}: its file was left as it was, since it holds all {of} keys or none, \
                     and {} could not be measured; see to them and calibrate it again",
                    refusals.len()
                ));
            }
            MeasureOutcome::Stopped => self.wrong.push(format!(
                "stopped at {name}: its file was left as it was, and so were those of boards \
                 behind it; calibrate them with --board"
            )),
        }
    }

    fn write(&mut self, board: &MeasuredBoard, keys: &[(KeyIndex, KeyCalibration)]) {
        let calibrations: Vec<_> = keys.iter().map(|(_, it)| *it).collect();
        if let Err(error) = file::write(&board.file, &sheet(board, &calibrations)) {
            self.wrong.push(error.to_string());
            return;
        }
        self.written.push(Written {
            link: board.name.line.clone(),
            number: board.name.number,
            uid: board.found.uid().to_string(),
            keys: keys.iter().map(MeasuredKeyRow::from).collect(),
            file: board.file.clone(),
        });
        self.untold.push((board.clone(), calibrations));
    }

    /// Tells the boards what they keep themselves, once nothing is measured any more.
    pub(super) fn tell(&mut self, mut keybed: Keybed<Armed>) {
        for (board, keys) in std::mem::take(&mut self.untold) {
            if let Err(refusal) = tell(&board, &keys, &mut keybed) {
                self.wrong.push(format!("its file was written, but {refusal}"));
            }
        }
    }
}

impl From<&(KeyIndex, KeyCalibration)> for MeasuredKeyRow {
    fn from((key, it): &(KeyIndex, KeyCalibration)) -> Self {
        Self {
            key: key.to_string(),
            rest: it.rest.get(),
            bottom: it.bottom.get(),
            travel_mm: 1e3 * it.travel(),
            friction_n: it.friction,
            gain: it.gain,
        }
    }
}

/// Returns the file of a board.
fn sheet(board: &MeasuredBoard, keys: &[KeyCalibration]) -> file::CalibrationSheet {
    file::CalibrationSheet {
        uid: board.found.uid(),
        made: OffsetDateTime::now_utc().format(MADE).unwrap_or_default(),
        by: format!("letoff calibrate {}", env!("CARGO_PKG_VERSION")),
        keys: PerKey::collect(keys.iter().copied()),
    }
}

/// Tells a board what it keeps of its keys' calibration; one may keep nothing of it.
fn tell(
    board: &MeasuredBoard,
    keys: &[KeyCalibration],
    keybed: &mut Keybed<Armed>,
) -> Result<(), Refusal> {
    let mut asker = keybed.asker(board.found.line, board.found.board);
    for (slot, key) in (0..).zip(keys) {
        let record = record(slot, key);
        let told: Result<Nothing, _> = keybed.ask(&mut asker, Operation::WriteCalibration, &record);
        match told {
            Ok(Nothing) => {}
            Err(Refusal::Declined { status: Status::Unknown | Status::Impossible, .. }) => break,
            Err(refusal) => return Err(refusal),
        }
    }
    Ok(())
}
