//! Speed against error: every scenario with every method and step.
//!
//! In the order of a run: `choice` what is asked for, `method` who there is, `job` one run,
//! `stepped` the step that is studied as the step that is taken, `observe` what happened,
//! `judge` how right it was, `time` how long it took, `row` the figures of one run.
//!
//! Two errors, never mixed: the time of events, and the state away from them. The sequence of
//! events comes first: a run in which it is wrong has no error, it has failed.

mod choice;
mod job;
mod judge;
mod method;
mod observe;
mod row;
mod stepped;
mod study;
mod time;

use std::time::Duration;

pub use choice::{StudyChoice, Unknown};
pub use judge::{EventMismatch, RunVerdict, SequenceVerdict};
pub use method::{METHODS, MethodKind, NamedMethod};
pub use row::{EvaluationCounts, StudyRow, Times};
pub use study::{Series, Setting, Study};

use crate::scenario::{BadFile, ScenarioEntry};

/// How much time is spent on timing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Effort {
    /// Fewest repeats of a run.
    pub repeats: u32,
    /// Repeats go on until this much has been spent on one run.
    pub budget: Duration,
    /// Only every second step of a series is taken.
    pub is_quick: bool,
}

impl Effort {
    /// For a report: short runs are repeated a thousand times, long ones need fewer.
    pub const FULL: Self = Self { repeats: 3, budget: Duration::from_millis(200), is_quick: false };
    /// For a look.
    pub const QUICK: Self = Self { repeats: 2, budget: Duration::from_millis(5), is_quick: true };
}

/// A scenario with all its runs.
#[derive(Clone, Debug)]
pub struct MeasuredScenario {
    pub entry: ScenarioEntry,
    /// Its end (s).
    pub until: f64,
    /// Its runs, series by series, the longest step first.
    pub rows: Vec<StudyRow>,
}

/// Measures a scenario with the methods chosen; `after` hears of each run that is done.
///
/// # Errors
/// When the scenario's reference cannot be read.
pub fn measure(
    entry: &ScenarioEntry,
    choice: &StudyChoice,
    after: &mut dyn FnMut(&StudyRow),
) -> Result<MeasuredScenario, BadFile> {
    let study = entry.build()?;
    let mut rows = Vec::new();
    for (series, setting) in choice.runs(study.as_ref()) {
        let row = study.run(entry.name, series, setting, choice.effort);
        if let Some(row) = row {
            after(&row);
            rows.push(row);
        }
    }
    Ok(MeasuredScenario { entry: *entry, until: study.until(), rows })
}
