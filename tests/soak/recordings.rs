//! What became of the recordings: one that a full disk cut short, and one that was begun after it.

use telemetry::recording::{Recording, recover};

use crate::actions::RecordingPaths;

/// Returns what is wrong with the recordings, a sentence each.
pub(crate) fn look_at(paths: &RecordingPaths) -> Vec<String> {
    let mut wrong = Vec::new();
    let whole = paths.cut_short.with_file_name("full-recovered.mcap");
    // What an earlier trial left there.
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
