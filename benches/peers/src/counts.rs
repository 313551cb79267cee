//! Counts of evaluations beside those of a committed report: equal on every machine.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::cases::Case;
use crate::entry::Entry;

/// Runs every row of this program once.
///
/// # Errors
/// A line for each count that differs from that in the file `results`, or is not there.
pub(crate) fn compare(cases: &[Case], results: &Path) -> Result<(), String> {
    let at = |error: &dyn std::fmt::Display| format!("{}: {error}", results.display());
    let text = fs::read_to_string(results).map_err(|error| at(&error))?;
    let report: Value = serde_json::from_str(&text).map_err(|error| at(&error))?;
    let rows = report["rows"].as_array().ok_or_else(|| at(&"it has no rows"))?;
    let all: Vec<_> = cases.iter().flat_map(|it| it.entries.iter().map(move |e| (it, e))).collect();
    let differ: Vec<_> =
        all.iter().filter_map(|(case, entry)| difference(case.name, entry, rows)).collect();
    if differ.is_empty() {
        println!("{} counts of evaluations are those of {}", all.len(), results.display());
        return Ok(());
    }
    let (count, lines) = (differ.len(), differ.join("\n"));
    Err(format!("{lines}\n{count} of {} counts differ from {}", all.len(), results.display()))
}

fn difference(problem: &str, entry: &Entry, rows: &[Value]) -> Option<String> {
    let (setting, knob) = (entry.setting.to_string(), entry.knob);
    let is_its = |row: &&Value| {
        let words = [("problem", problem), ("code", entry.code), ("method", entry.method)];
        words.iter().all(|(name, word)| row[name] == *word)
            && row["setting"] == *setting
            && row["tolerance_or_step"] == knob
    };
    let known = rows.iter().find(is_its).map(|row| row["rhs"].clone());
    let found = Value::from(entry.evaluations());
    (known.as_ref() != Some(&found)).then(|| {
        let known = known.unwrap_or_default();
        format!(
            "{problem}, {} {}, {setting} {knob:e}: {found}, not {known}",
            entry.code, entry.method
        )
    })
}
