//! Stages: what is run in groups, one group after the other, timed, and summed up at the end.

use std::fmt;
use std::panic::resume_unwind;
use std::process::Command;
use std::thread;
use std::time::{Duration, Instant};

use crate::command;
use crate::error::Error;

/// One part of a chore.
#[derive(Debug)]
pub(crate) struct Stage {
    /// What it shows, in a few words.
    pub name: &'static str,
    pub work: StageWork,
    /// Why it is not to be run here, if that is known before.
    pub skipped: Option<&'static str>,
}

/// What a stage runs.
#[derive(Debug)]
pub(crate) enum StageWork {
    Command(Command),
    /// Something of ours, which may find out that it cannot be done here.
    Chore(fn() -> Result<Done, Error>),
}

/// What a chore came to that did not fail.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Done {
    All,
    /// Nothing was, for this reason.
    Skipped(String),
}

/// How a stage ended.
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

/// A line of the summary.
struct SummaryLine {
    name: &'static str,
    outcome: StageOutcome,
    took: Duration,
}

/// Runs each group's stages side by side, up to the first group in which one fails, and prints a
/// summary in any case.
///
/// # Errors
/// Names the first command that failed.
pub(crate) fn run_all(groups: Vec<Vec<Stage>>) -> Result<(), Error> {
    let mut lines = Vec::new();
    let mut result = Ok(());
    for mut group in groups {
        if result.is_err() {
            for stage in &mut group {
                stage.skipped = Some("an earlier stage failed");
            }
        }
        let ended: Vec<_> = thread::scope(|scope| {
            let stages = group.into_iter().map(|stage| scope.spawn(|| end(stage)));
            let running: Vec<_> = stages.collect();
            running.into_iter().map(|it| it.join().unwrap_or_else(|it| resume_unwind(it))).collect()
        });
        for (line, outcome) in ended {
            lines.push(line);
            result = result.and(outcome);
        }
    }
    print!("\n{}", summary(&lines));
    result
}

/// Runs a stage to its end unless it is skipped; returns its line of the summary, and what failed.
fn end(mut stage: Stage) -> (SummaryLine, Result<(), Error>) {
    let start = Instant::now();
    let (outcome, result) = match stage.skipped {
        Some(reason) => (StageOutcome::Skipped(reason.into()), Ok(())),
        None => match run(&mut stage) {
            Ok(Done::All) => (StageOutcome::Passed, Ok(())),
            Ok(Done::Skipped(reason)) => (StageOutcome::Skipped(reason), Ok(())),
            Err(error) => (StageOutcome::Failed, Err(error)),
        },
    };
    (SummaryLine { name: stage.name, outcome, took: start.elapsed() }, result)
}

/// Runs one stage, and says how long it took.
fn run(stage: &mut Stage) -> Result<Done, Error> {
    println!("\n== {}", stage.name);
    let start = Instant::now();
    let result = match &mut stage.work {
        StageWork::Command(command) => command::run(command).map(|()| Done::All),
        StageWork::Chore(chore) => chore(),
    };
    println!("== {}: {:.1} s", stage.name, start.elapsed().as_secs_f64());
    result
}

/// One line a stage: time, name, outcome.
fn summary(lines: &[SummaryLine]) -> String {
    let width = lines.iter().map(|line| line.name.chars().count()).max().unwrap_or_default();
    let row = |line: &SummaryLine| {
        format!("{:8.1} s  {:width$}  {}\n", line.took.as_secs_f64(), line.name, line.outcome)
    };
    lines.iter().map(row).collect()
}

#[cfg(test)]
mod tests {
    use std::sync::Barrier;
    use std::sync::atomic::{AtomicUsize, Ordering};

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
    fn stages_of_a_group_are_all_run_to_their_ends_side_by_side() {
        static BOTH: Barrier = Barrier::new(2);
        static ENDED: AtomicUsize = AtomicUsize::new(0);
        let ends = || {
            BOTH.wait();
            ENDED.fetch_add(1, Ordering::Relaxed);
            Ok(Done::All)
        };
        let fails = || {
            BOTH.wait();
            Err(Error::Guest("no sound".into()))
        };
        let stage = |work| Stage { name: "a chore", work: StageWork::Chore(work), skipped: None };
        assert!(run_all(vec![vec![stage(fails), stage(ends)]]).is_err());
        assert_eq!(ENDED.load(Ordering::Relaxed), 1);
    }

    #[test]
    fn a_chore_that_cannot_be_done_here_fails_nothing() {
        let stage = |work| Stage { name: "a chore", work: StageWork::Chore(work), skipped: None };
        assert!(run_all(vec![vec![stage(|| Ok(Done::Skipped("no kernel".into())))]]).is_ok());
        let failing = || Err(Error::Guest("no sound".into()));
        let groups = vec![vec![stage(failing)], vec![stage(|| unreachable!())]];
        assert!(run_all(groups).is_err());
    }
}
