//! Speed against error: every scenario with every method and step.
//!
//! In the order of a run: `choice` what is asked for, `method` the methods, `job` one run,
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

pub use choice::{StudyChoice, UnknownName};
pub use judge::{EventMismatch, RunVerdict, SequenceVerdict};
pub use method::{METHODS, MethodKind, NamedMethod, Setting};
pub use row::{EvaluationCounts, StudyRow, Times};

use crate::scenario::{BadFile, ScenarioEntry};

/// How much time a study spends on timing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Effort {
    /// Smallest number of repeats of a run.
    pub repeats: u32,
    /// Time that is spent on the repeats of one run at least.
    pub budget: Duration,
    /// Whether only every second step of a series is taken.
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
    /// End of the scenario (s).
    pub until: f64,
    /// The runs, method by method, the longest step first.
    pub rows: Vec<StudyRow>,
}

/// Measures a scenario with the methods chosen, and hands each run that is done to `after`.
///
/// # Errors
/// When the scenario's reference cannot be read.
pub fn measure(
    entry: &ScenarioEntry,
    choice: &StudyChoice,
    after: &mut dyn FnMut(&StudyRow),
) -> Result<MeasuredScenario, BadFile> {
    let study = study::build(entry)?;
    let plan = study.plan();
    let mut rows = Vec::new();
    for (method, setting) in choice.runs(&plan) {
        let row = study.run(entry.name, method, setting, choice.effort);
        after(&row);
        rows.push(row);
    }
    Ok(MeasuredScenario { entry: *entry, until: plan.until, rows })
}
