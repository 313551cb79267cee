//! Stages: commands that are run one after the other, timed, and summed up at the end.

use std::fmt;
use std::process::Command;
use std::time::{Duration, Instant};

use crate::command;
use crate::error::Error;

/// One command of a chore.
#[derive(Debug)]
pub(crate) struct Stage {
    /// What it shows, in a few words.
    pub name: &'static str,
    /// What is run.
    pub command: Command,
    /// Why it cannot be run here, if it cannot.
    pub skipped: Option<&'static str>,
}

/// How a stage ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Outcome {
    Passed,
    Failed,
    Skipped(&'static str),
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Passed => f.write_str("passed"),
            Self::Failed => f.write_str("FAILED"),
            Self::Skipped(reason) => write!(f, "skipped: {reason}"),
        }
    }
}

/// A line of the summary.
struct Line {
    name: &'static str,
    outcome: Outcome,
    took: Duration,
}

/// Runs the stages up to the first that fails, and prints a summary in any case.
///
/// # Errors
/// Names the command that failed.
pub(crate) fn run_all(stages: Vec<Stage>) -> Result<(), Error> {
    let mut lines = Vec::new();
    let mut result = Ok(());
    for mut stage in stages {
        let start = Instant::now();
        let outcome = match (stage.skipped, &result) {
            (_, Err(_)) => Outcome::Skipped("an earlier stage failed"),
            (Some(reason), Ok(())) => Outcome::Skipped(reason),
            (None, Ok(())) => {
                result = run(&mut stage);
                if result.is_ok() { Outcome::Passed } else { Outcome::Failed }
            }
        };
        lines.push(Line { name: stage.name, outcome, took: start.elapsed() });
    }
    print!("\n{}", summary(&lines));
    result
}

/// Runs one stage, and says how long it took.
fn run(stage: &mut Stage) -> Result<(), Error> {
    println!("\n== {}", stage.name);
    let start = Instant::now();
    let result = command::run(&mut stage.command);
    println!("== {}: {:.1} s", stage.name, start.elapsed().as_secs_f64());
    result
}

/// One line a stage: time, name, outcome.
fn summary(lines: &[Line]) -> String {
    let width = lines.iter().map(|line| line.name.chars().count()).max().unwrap_or_default();
    let row = |line: &Line| {
        format!("{:8.1} s  {:width$}  {}\n", line.took.as_secs_f64(), line.name, line.outcome)
    };
    lines.iter().map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(name: &'static str, outcome: Outcome, seconds: f64) -> Line {
        Line { name, outcome, took: Duration::from_secs_f64(seconds) }
    }

    #[test]
    fn the_summary_shows_what_was_skipped_and_why() {
        let lines = [
            line("tests", Outcome::Passed, 61.25),
            line("no_std", Outcome::Skipped("no target"), 0.0),
            line("doc tests", Outcome::Failed, 2.0),
        ];
        let expected = "    61.2 s  tests      passed\n     \
                        0.0 s  no_std     skipped: no target\n     \
                        2.0 s  doc tests  FAILED\n";
        assert_eq!(summary(&lines), expected);
    }
}
