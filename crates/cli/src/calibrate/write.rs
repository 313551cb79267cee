//! Writes measurements into files and to the boards.

use std::path::{Path, PathBuf};

use boards::calibrate::record;
use boards::calibration::{KeyCalibration, file};
use boards::keybed::{Armed, Keybed};
use boards::refusal::Refusal;
use documents::shown;
use firmware_protocol::Nothing;
use firmware_protocol::acyclic::{Operation, Status};
use firmware_protocol::key::{KeyIndex, PerKey};
use serde::Serialize;
use time::OffsetDateTime;
use time::format_description::BorrowedFormatItem;
use time::macros::format_description;

use super::bring_up::MeasuredBoard;

const MADE: &[BorrowedFormatItem<'_>] =
    format_description!("[year]-[month]-[day] [hour]:[minute] UTC");

#[derive(Debug, Serialize)]
pub(super) struct Written {
    pub(super) link: String,
    pub(super) number: u8,
    pub(super) uid: String,
    pub(super) file: PathBuf,
    pub(super) keys: Vec<MeasuredKeyRow>,
}

#[derive(Debug, Serialize)]
pub(super) struct MeasuredKeyRow {
    pub(super) key: String,
    pub(super) rest: i32,
    pub(super) bottom: i32,
    pub(super) travel_mm: f64,
    pub(super) friction_n: f64,
    pub(super) gain: f64,
}

#[derive(Debug, Default)]
pub(super) struct MeasureOutcome {
    /// All keys, in the order of slots; `None` for one that was not measured.
    pub(super) keys: Vec<(KeyIndex, Option<KeyCalibration>)>,
    pub(super) refusals: Vec<Refusal>,
    pub(super) is_stopped: bool,
}

#[derive(Debug, Default)]
pub(super) struct CalibrationRecord {
    pub(super) written: Vec<Written>,
    pub(super) wrong: Vec<String>,
    /// Records to send to boards.
    untold: Vec<(MeasuredBoard, Vec<KeyCalibration>)>,
}

impl CalibrationRecord {
    /// Writes a board's measurements into its file, or beside it, with reasons, if keys lack.
    pub(super) fn keep(&mut self, board: &MeasuredBoard, outcome: MeasureOutcome) {
        let MeasureOutcome { keys, refusals, is_stopped } = outcome;
        self.wrong.extend(refusals.iter().map(ToString::to_string));
        let name = &board.name;
        if is_stopped {
            self.wrong.push(format!(
                "stopped at {name}: calibrate it again, and the boards behind it, with --board"
            ));
        }
        let measured: Vec<_> = keys.iter().filter_map(|(key, it)| Some((*key, (*it)?))).collect();
        let (n, of) = (measured.len(), keys.len());
        if n == 0 {
            self.wrong.push(format!("{name}: none of its {of} keys was measured, no file written"));
            return;
        }
        let merged: Vec<_> =
            keys.iter().zip(before(board, of)).map(|((_, now), then)| now.or(then)).collect();
        let Some(all) = merged.iter().copied().collect::<Option<Vec<_>>>() else {
            let file = file::partial(&board.file);
            self.write(board, &file, &measured, &merged);
            self.wrong.push(format!(
                "{name}: {n} of {of} keys were measured, and are kept in {} for the next time; its \
                 file, which holds all keys or none, was not written: see to the others and \
                 calibrate it again",
                shown(&file)
            ));
            return;
        };
        if n < of {
            self.wrong.push(format!(
                "{name}: {n} of {of} keys were measured; its file has of the others what was \
                 measured before"
            ));
        }
        if self.write(board, &board.file, &measured, &merged) {
            // The file is complete now; a remaining partial file is overwritten the next time.
            let _gone = std::fs::remove_file(file::partial(&board.file));
            self.untold.push((board.clone(), all));
        }
    }

    /// Writes the known keys of a board into `path`; returns `true` on success.
    fn write(
        &mut self,
        board: &MeasuredBoard,
        path: &Path,
        measured: &[(KeyIndex, KeyCalibration)],
        known: &[Option<KeyCalibration>],
    ) -> bool {
        if let Err(error) = file::write(path, &sheet(board, known)) {
            self.wrong.push(error.to_string());
            return false;
        }
        self.written.push(Written {
            link: board.name.line.clone(),
            number: board.name.number,
            uid: board.found.uid().to_string(),
            keys: measured.iter().map(MeasuredKeyRow::from).collect(),
            file: path.to_owned(),
        });
        true
    }

    /// Sends the boards their records, after all measurements.
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

/// Returns the earlier measurements of the `n` keys, from the board's file or the partial one.
fn before(board: &MeasuredBoard, n: usize) -> Vec<Option<KeyCalibration>> {
    let (uid, path) = (board.found.uid(), &board.file);
    // An unreadable file is replaced; the old file is kept as .bak.
    let whole = file::load(path, uid, n).ok().flatten();
    let known = whole.or_else(|| file::load_partial(&file::partial(path), uid, n).ok().flatten());
    known.map_or_else(|| vec![None; n], |sheet| sheet.keys.as_slice().to_vec())
}

fn sheet(board: &MeasuredBoard, keys: &[Option<KeyCalibration>]) -> file::CalibrationSheet {
    file::CalibrationSheet {
        uid: board.found.uid(),
        made: OffsetDateTime::now_utc().format(MADE).unwrap_or_default(),
        by: format!("letoff calibrate {}", env!("CARGO_PKG_VERSION")),
        keys: PerKey::collect(keys.iter().copied()),
    }
}

/// Sends a board its keys' calibration; some boards store nothing of it.
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
