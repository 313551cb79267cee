//! Programs that are not Rust: each reads the case from a file, runs and times all its rows,
//! and prints one line of JSON per row.

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use serde::Deserialize;

use crate::cases::Case;
use crate::entry::tolerances;
use crate::judge::{judge, judge_states};
use crate::row::Row;

#[derive(Clone, Debug)]
pub(crate) struct External {
    pub(crate) code: &'static str,
    pub(crate) command: Vec<PathBuf>,
    /// Maximum number of rounds: a run of soft contacts may take seconds.
    pub(crate) rounds: u32,
    /// Problems that fit the program; empty for all.
    pub(crate) only: &'static [&'static str],
}

#[derive(Debug, Deserialize)]
struct Line {
    version: String,
    method: String,
    setting: String,
    knob: f64,
    note: String,
    /// `null` if the code reports no events.
    events: Option<Vec<(f64, String)>>,
    states: Vec<f64>,
    rhs: Option<u64>,
    ns: Vec<f64>,
    error: Option<String>,
}

impl External {
    /// Runs all rows of this program on `case`, each for about `budget`; the error is the reason.
    pub(crate) fn run(
        &self,
        case: &Case,
        budget: Duration,
        folder: &Path,
        last: i32,
    ) -> Result<Vec<Row>, String> {
        if !self.only.is_empty() && !self.only.contains(&case.name) {
            return Ok(Vec::new());
        }
        let file = folder.join(format!("{}.txt", case.name));
        let told = fs::write(&file, parameters(case, budget, last));
        told.map_err(|error| format!("{}: {error}", file.display()))?;
        let Some((program, arguments)) = self.command.split_first() else {
            return Err("no program".to_owned());
        };
        let mut command = Command::new(program);
        // Python must leave nothing in the source tree.
        command.args(arguments).arg(&file).env("PYTHONDONTWRITEBYTECODE", "1");
        let output = command.output();
        let output = output.map_err(|error| format!("{}: {error}", program.display()))?;
        let text = String::from_utf8_lossy(&output.stdout);
        if !output.status.success() {
            let why = String::from_utf8_lossy(&output.stderr);
            let last = why.lines().last().unwrap_or("no message").to_owned();
            return Err(format!("ended with {}: {last}", output.status));
        }
        text.lines().map(|line| self.row(case, line)).collect()
    }

    fn row(&self, case: &Case, line: &str) -> Result<Row, String> {
        let line: Line =
            serde_json::from_str(line).map_err(|error| format!("{}: {error}", self.code))?;
        let ended = line.error.map_or(Ok(()), Err);
        let verdict = if let Some(events) = line.events {
            let events: Vec<_> = events.iter().map(|(t, guard)| (*t, guard.as_str())).collect();
            judge(&case.reference, &events, &line.states, ended)
        } else {
            judge_states(&case.reference, &line.states, ended)
        };
        let row = Row {
            problem: case.name.to_owned(),
            code: self.code.to_owned(),
            version: line.version,
            method: line.method,
            setting: line.setting,
            tolerance_or_step: line.knob,
            events: 0,
            sequence_ok: false,
            event_error_s: None,
            state_error: None,
            rhs: line.rhs,
            ns_per_ms_min: None,
            ns_per_ms_median: None,
            note: line.note,
            failure: None,
            times: line.ns,
        };
        Ok(row.judged(verdict))
    }
}

fn parameters(case: &Case, budget: Duration, last: i32) -> String {
    let mut text = case.parameters.clone();
    let mut line = |name: &str, value: f64| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{name} {value:?}");
    };
    line("budget_ms", budget.as_secs_f64() * 1e3);
    tolerances(last).for_each(|tolerance| line("tolerance", tolerance));
    case.reference.times.iter().for_each(|t| line("sample", *t));
    text
}
