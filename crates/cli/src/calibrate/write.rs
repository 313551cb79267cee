//! What was measured into files, and to the boards.

use std::path::PathBuf;

use firmware_protocol::Nothing;
use firmware_protocol::acyclic::Operation;
use firmware_protocol::key::{KeyIndex, PerKey};
use hardware::calibrate::record;
use hardware::calibration::{KeyCalibration, file};
use hardware::keybed::{Armed, Keybed};
use hardware::refusal::{KeyName, Refusal};
use serde::Serialize;
use time::OffsetDateTime;
use time::format_description::BorrowedFormatItem;
use time::macros::format_description;

use super::bring_up::MeasuredBoard;
use super::measure::MeasureOutcome;

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

/// What was measured of one key.
#[derive(Debug, Serialize)]
pub(super) struct MeasuredKeyRow {
    pub(super) key: String,
    pub(super) rest: i32,
    pub(super) bottom: i32,
    pub(super) travel_mm: f64,
    pub(super) friction_n: f64,
    pub(super) gain: f64,
}

/// What was written, and what is wrong.
#[derive(Debug, Default)]
pub(super) struct CalibrationRecord {
    pub(super) written: Vec<Written>,
    pub(super) wrong: Vec<String>,
    /// What boards have to be told.
    untold: Vec<(MeasuredBoard, Vec<KeyCalibration>)>,
}

impl CalibrationRecord {
    /// Writes what was measured of a board into its file, or says why there is nothing to write.
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
            key: KeyName(*key).to_string(),
            rest: it.rest.get(),
            bottom: it.bottom.get(),
            travel_mm: 1e3 * it.travel(),
            friction_n: it.friction,
            gain: it.gain,
        }
    }
}

/// The file of a board.
fn sheet(board: &MeasuredBoard, keys: &[KeyCalibration]) -> file::CalibrationSheet {
    file::CalibrationSheet {
        uid: board.found.uid(),
        made: OffsetDateTime::now_utc().format(MADE).unwrap_or_default(),
        by: format!("letoff calibrate {}", env!("CARGO_PKG_VERSION")),
        keys: PerKey::collect(keys.iter().copied()),
    }
}

/// Tells a board what it keeps of its keys' calibration.
fn tell(
    board: &MeasuredBoard,
    keys: &[KeyCalibration],
    keybed: &mut Keybed<Armed>,
) -> Result<(), Refusal> {
    let mut asker = keybed.asker(board.found.line, board.found.board);
    for (slot, key) in (0..).zip(keys) {
        let record = record(slot, key);
        let _done: Nothing = keybed.ask(&mut asker, Operation::WriteCalibration, &record)?;
    }
    Ok(())
}
