//! Speed against error: every scenario with every method and step.
//!
//! In the order of a run: `choice`, `method`, `job` (one run), `stepped` (the studied step is
//! taken), `observe`, `judge`, `time`, `row` (the figures of one run). Errors of event times and of
//! states are never mixed. A run with a wrong sequence of events has failed and has no error.

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

pub(crate) use choice::unknown_names;
pub use choice::{StudyChoice, UnknownName};
pub use judge::{EventMismatch, RunVerdict, SequenceVerdict};
pub use method::{METHODS, MethodKind, NamedMethod, Setting};
pub use row::{EvaluationCounts, StudyRow, Times};

use crate::scenario::{BadFile, ScenarioEntry};

/// Time that a study spends on timing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Effort {
    pub repeats: u32,
    pub budget: Duration,
    /// `true` if only every second step of a series is run.
    pub is_quick: bool,
}

impl Effort {
    /// For a report: short runs are repeated a thousand times, long ones less often.
    pub const FULL: Self = Self { repeats: 3, budget: Duration::from_millis(200), is_quick: false };
    /// For a quick impression, not for a claim.
    pub const QUICK: Self = Self { repeats: 2, budget: Duration::from_millis(5), is_quick: true };
}

/// A scenario with all its runs.
#[derive(Clone, Debug)]
pub struct MeasuredScenario {
    pub entry: ScenarioEntry,
    /// End of the scenario (s).
    pub until: f64,
    pub rows: Vec<StudyRow>,
}

/// Measures a scenario with the methods chosen; calls `after` with each finished run.
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
