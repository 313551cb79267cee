//! What was measured into files, and to the boards.

use std::path::PathBuf;
use std::time::SystemTime;

use firmware_protocol::Nothing;
use firmware_protocol::acyclic::Operation;
use firmware_protocol::key::PerKey;
use hardware::calibrate::record;
use hardware::calibration::{KeyCalibration, file};
use hardware::keybed::{Armed, Keybed};
use hardware::refusal::{KeyName, Refusal};
use serde::Serialize;

use super::bring_up::Board;
use super::measure::Measured;

/// A board whose file was written.
#[derive(Debug, Serialize)]
pub(super) struct Written {
    pub(super) link: String,
    pub(super) number: u8,
    pub(super) uid: String,
    pub(super) file: PathBuf,
    pub(super) keys: Vec<Row>,
}

/// What was measured of one key.
#[derive(Debug, Serialize)]
pub(super) struct Row {
    pub(super) key: String,
    pub(super) rest: i32,
    pub(super) bottom: i32,
    pub(super) travel_mm: f64,
    pub(super) friction_n: f64,
    pub(super) gain: f64,
}

/// Writes what was measured; returns what was written, and what is wrong, in sentences.
pub(super) fn all(
    measured: Vec<Measured>,
    mut keybed: Keybed<Armed>,
) -> (Vec<Written>, Vec<String>) {
    let (mut written, mut wrong) = (Vec::new(), Vec::new());
    for Measured { board, keys } in measured {
        let keys = match keys {
            Ok(keys) => keys,
            Err(refusals) => {
                wrong.extend(refusals.iter().map(ToString::to_string));
                wrong.push(format!("{}: its file was left as it was", board.name));
                continue;
            }
        };
        let calibrations: Vec<_> = keys.iter().map(|(_, it)| *it).collect();
        if let Err(error) = file::write(&board.file, &sheet(&board, &calibrations)) {
            wrong.push(error.to_string());
            continue;
        }
        if let Err(refusal) = tell(&board, &calibrations, &mut keybed) {
            wrong.push(format!("its file was written, but {refusal}"));
        }
        let rows = keys.iter().map(|(key, it)| Row {
            key: KeyName(*key).to_string(),
            rest: it.rest.get(),
            bottom: it.bottom.get(),
            travel_mm: 1e3 * it.travel(),
            friction_n: it.friction,
            gain: it.gain,
        });
        written.push(Written {
            link: board.name.line.clone(),
            number: board.name.number,
            uid: board.found.uid().to_string(),
            keys: rows.collect(),
            file: board.file,
        });
    }
    (written, wrong)
}

/// The file of a board.
fn sheet(board: &Board, keys: &[KeyCalibration]) -> file::Sheet {
    file::Sheet {
        uid: board.found.uid(),
        made: lab::report::utc(SystemTime::now()),
        by: format!("letoff calibrate {}", env!("CARGO_PKG_VERSION")),
        keys: PerKey::collect(keys.iter().copied()),
    }
}

/// Tells a board what it keeps of its keys' calibration.
fn tell(board: &Board, keys: &[KeyCalibration], keybed: &mut Keybed<Armed>) -> Result<(), Refusal> {
    let mut asker = keybed.asker(board.found.line, board.found.board);
    for (slot, key) in (0..).zip(keys) {
        let record = record(slot, key);
        let _done: Nothing = keybed.ask(&mut asker, Operation::WriteCalibration, &record)?;
    }
    Ok(())
}
