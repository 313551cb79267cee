//! Checks of two recordings: one cut short by a full disk, and one begun after it.

use telemetry::recording::{Recording, recover};

use crate::actions::RecordingPaths;

pub(crate) fn look_at(paths: &RecordingPaths) -> Vec<String> {
    let mut wrong = Vec::new();
    let whole = paths.cut_short.with_file_name("full-recovered.mcap");
    let _before = std::fs::remove_file(&whole);
    match recover(&paths.cut_short, &whole) {
        Ok(recovered) if recovered.messages == 0 => {
            wrong.push(format!("nothing is saved of {}", paths.cut_short.display()));
        }
        Ok(_recovered) => {}
        Err(error) => wrong.push(error.to_string()),
    }
    match Recording::open(&paths.second) {
        Ok(recording) => wrong.extend(recording.tear().map(ToString::to_string)),
        Err(error) => wrong.push(error.to_string()),
    }
    wrong
}
