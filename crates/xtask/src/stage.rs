//! Runs stages one after the other, times them, and prints a summary.

use std::time::{Duration, Instant};
use std::{fmt, process::Command};

use crate::{command, error::Error};

#[derive(Debug)]
pub(crate) struct Stage {
    pub name: &'static str,
    pub work: StageWork,
    pub skipped: Option<&'static str>,
}

#[derive(Debug)]
pub(crate) enum StageWork {
    Command(Command),
    Chore(fn() -> Result<Done, Error>),
}

/// Outcome of a chore without failure.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Done {
    All,
    Skipped(String),
}

#[derive(Clone, PartialEq, Eq, Debug)]
enum StageOutcome {
    Passed,
    Failed,
    Skipped(String),
}

impl fmt::Display for StageOutcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Passed => f.write_str("passed"),
            Self::Failed => f.write_str("FAILED"),
            Self::Skipped(reason) => write!(f, "skipped: {reason}"),
        }
    }
}

struct SummaryLine {
    name: &'static str,
    outcome: StageOutcome,
    took: Duration,
}

/// Runs the stages up to the first failure, and prints a summary in any case.
pub(crate) fn run_all(stages: Vec<Stage>) -> Result<(), Error> {
    let mut lines = Vec::new();
    let mut result = Ok(());
    for mut stage in stages {
        let start = Instant::now();
        let outcome = match (stage.skipped, &result) {
            (_, Err(_)) => StageOutcome::Skipped("an earlier stage failed".into()),
            (Some(reason), Ok(())) => StageOutcome::Skipped(reason.into()),
            (None, Ok(())) => match run(&mut stage) {
                Ok(Done::All) => StageOutcome::Passed,
                Ok(Done::Skipped(reason)) => StageOutcome::Skipped(reason),
                Err(error) => {
                    result = Err(error);
                    StageOutcome::Failed
                }
            },
        };
        lines.push(SummaryLine { name: stage.name, outcome, took: start.elapsed() });
    }
    print!("\n{}", summary(&lines));
    result
}

fn run(stage: &mut Stage) -> Result<Done, Error> {
    println!("\n== {}", stage.name);
    let start = Instant::now();
    let result = match &mut stage.work {
        StageWork::Command(command) => command::run_tests(command).map(|()| Done::All),
        StageWork::Chore(chore) => chore(),
    };
    println!("== {}: {:.1} s", stage.name, start.elapsed().as_secs_f64());
    result
}

fn summary(lines: &[SummaryLine]) -> String {
    let width = lines.iter().map(|line| line.name.chars().count()).max().unwrap_or_default();
    let row = |line: &SummaryLine| {
        format!("{:8.1} s  {:width$}  {}\n", line.took.as_secs_f64(), line.name, line.outcome)
    };
    lines.iter().map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(name: &'static str, outcome: StageOutcome, seconds: f64) -> SummaryLine {
        SummaryLine { name, outcome, took: Duration::from_secs_f64(seconds) }
    }

    #[test]
    fn the_summary_shows_what_was_skipped_and_why() {
        let lines = [
            line("tests", StageOutcome::Passed, 61.25),
            line("no_std", StageOutcome::Skipped("no target".into()), 0.0),
            line("doc tests", StageOutcome::Failed, 2.0),
        ];
        let expected = "    61.2 s  tests      passed\n     \
                        0.0 s  no_std     skipped: no target\n     \
                        2.0 s  doc tests  FAILED\n";
        assert_eq!(summary(&lines), expected);
    }
    #[test]
    fn a_chore_that_cannot_be_done_here_fails_nothing() {
        let stage = |work| Stage { name: "a chore", work: StageWork::Chore(work), skipped: None };
        assert!(run_all(vec![stage(|| Ok(Done::Skipped("no kernel".into())))]).is_ok());
        let failing = || Err(Error::Guest("no sound".into()));
        assert!(run_all(vec![stage(failing), stage(|| unreachable!())]).is_err());
    }
}
