//! Speed against error: every scenario with every method and step.
//!
//! In the order of a run: `choice`, `method`, `job` (one run), `stepped` (the studied step is
//! taken), `observe`, `judge`, `time`, `row` (the figures of one run). Errors of event times and of
//! states are never mixed. A run with a wrong sequence of events has failed and has no error.

mod choice;
mod drift;
mod job;
mod judge;
mod method;
mod observe;
mod order;
mod row;
mod stepped;
mod study;
mod time;

use std::time::Duration;

pub use choice::{LONG_RUN, StudyChoice, StudyNames, UnknownName};
pub(crate) use choice::{is_asked_for, unknown_names};
pub use drift::EnergyDrift;
pub use judge::{EventMismatch, RunVerdict, SequenceVerdict};
pub use method::{METHODS, MethodGroup, MethodKind, NamedMethod, Setting};
pub use order::{ObservedOrder, observed_orders};
pub use row::{EvaluationCounts, StudyRow, Times};

use self::drift::DriftRun;
use self::method::OTHER_METHOD;
use self::study::Study;
use crate::scenario::{BadFile, Plan, SCENARIOS, ScenarioEntry};

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
    /// For a quick impression, not for a claim: each run is timed once.
    pub const QUICK: Self = Self { repeats: 0, budget: Duration::ZERO, is_quick: true };
}

/// A scenario with its runs.
#[derive(Clone, Debug)]
pub struct MeasuredScenario {
    pub entry: ScenarioEntry,
    pub plan: Plan,
    /// Number of its runs in all shares.
    pub runs: usize,
    pub rows: Vec<StudyRow>,
}

/// Measures the runs of a scenario that are in the share chosen; calls `after` with each.
///
/// # Errors
/// If the reference of the scenario cannot be read.
pub fn measure(
    entry: &ScenarioEntry,
    choice: &StudyChoice,
    after: &(dyn Fn(&StudyRow) + Sync),
) -> Result<MeasuredScenario, BadFile> {
    let study = study::build(entry)?;
    let plan = study.plan();
    let runs = choice.runs(&plan);
    let taken: Vec<_> = (0..runs.len()).filter(|number| choice.part.takes(*number)).collect();
    let is_limited = plan.is_computed && !taken.is_empty();
    let least = if is_limited { least_errors(&*study, &plan) } else { [0.0; 2] };
    let run = |number: usize| {
        let (method, setting) = runs[number];
        let row = study.run(method, setting, choice.effort);
        let verdict = row.verdict.at_least(least);
        let row = StudyRow { number, scenario: entry.name.to_owned(), verdict, ..row };
        after(&row);
        row
    };
    let rows = taken.into_iter().map(run).collect();
    Ok(MeasuredScenario { entry: *entry, plan, runs: runs.len(), rows })
}

/// Returns the least errors of event times (s), and of states and force, that a computed reference
/// can show: 100 times those of another method.
fn least_errors(study: &dyn Study, plan: &Plan) -> [f64; 2] {
    const MARGIN: f64 = 100.0;
    let setting = Setting { tick: plan.offline_tick, tolerance: Some(1e-13) };
    let verdict = study.run(&OTHER_METHOD, setting, Effort::QUICK).verdict;
    if !verdict.sequence.is_right() {
        return [f64::MAX; 2];
    }
    let states = verdict.state_error.unwrap_or(0.0).max(verdict.force_error.unwrap_or(0.0));
    [MARGIN * verdict.event_error.unwrap_or(0.0), MARGIN * states]
}

/// Runs the methods in the share chosen for long on a lossless motion; calls `after` with each.
///
/// # Errors
/// If the scenario of long runs cannot be read.
pub fn measure_drifts(
    choice: &StudyChoice,
    after: &dyn Fn(&EnergyDrift),
) -> Result<Vec<EnergyDrift>, BadFile> {
    /// A head that bounces five times a second.
    const BOUNCES: &str = "head-1e3";
    /// End (s): after 1e5 bounces, or 1e3 in a quick study.
    const UNTIL: [f64; 2] = [21_400.0, 214.0];
    let until = UNTIL[usize::from(choice.effort.is_quick)];
    let entry = SCENARIOS.iter().find(|entry| entry.name == BOUNCES);
    let entry = entry.ok_or_else(|| BadFile::missing(BOUNCES, "the scenario"))?;
    let run = |number: usize| {
        let method = choice.methods[number];
        let points = entry.visit(DriftRun { method, until })?;
        let drift = EnergyDrift { number, method, points };
        after(&drift);
        Ok(drift)
    };
    (0..choice.long_runs()).filter(|number| choice.part.takes(*number)).map(run).collect()
}
