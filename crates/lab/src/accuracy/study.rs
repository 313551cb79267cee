//! A scenario whose model's type is known by name only, and the runs it can do.

use pode::stepper::Any;
use pode::{Limits, Stepper};

use super::Effort;
use super::job::RunJob;
use super::judge::judge;
use super::method::{MethodKind, NamedMethod, Visit, visit};
use super::observe::observe;
use super::row::{EvaluationCounts, StudyRow};
use super::stepped::Stepping;
use super::time::time;
use crate::scenario::{Plan, Scenario};

/// A method as one line of a plot.
pub type Series = NamedMethod;

/// One point of a series.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Setting {
    /// Length of a tick (s).
    pub tick: f64,
    /// Tolerance or error budget, for methods that choose their steps.
    pub tolerance: Option<f64>,
}

/// A scenario that can be run with every method.
pub trait Study {
    /// End (s).
    fn until(&self) -> f64;

    /// The points of the series of `method`, the coarsest first.
    fn settings(&self, method: &NamedMethod) -> Vec<Setting>;

    /// One run, judged and timed; nothing if there is no such method.
    fn run(
        &self,
        scenario: &'static str,
        method: &'static NamedMethod,
        setting: Setting,
        effort: Effort,
    ) -> Option<StudyRow>;

    /// What is wrong with the ticks: each must divide the run and the times of samples.
    fn misfits(&self) -> Option<String>;
}

/// Tolerances, relative and absolute, of methods that choose their steps.
const TOLERANCES: [f64; 7] = [1e-4, 1e-5, 1e-6, 1e-8, 1e-10, 1e-12, 1e-13];

/// Errors per radian of a mode's fastest motion, of methods that have a budget.
const BUDGETS: [f64; 7] = [1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

/// The longest tick in which they are studied, that of a keyboard (s).
const LONGEST_BUDGETED: f64 = 1e-3;

impl<S: Scenario> Study for S {
    fn until(&self) -> f64 {
        self.plan().until
    }

    fn settings(&self, method: &NamedMethod) -> Vec<Setting> {
        let Plan { ticks, offline_tick, .. } = self.plan();
        match method.kind {
            MethodKind::Fixed | MethodKind::Played => {
                ticks.iter().map(|tick| Setting { tick: *tick, tolerance: None }).collect()
            }
            MethodKind::Budgeted => {
                let tick = ticks.iter().copied().find(|tick| *tick <= LONGEST_BUDGETED);
                let setting = |budget| Some(Setting { tick: tick?, tolerance: Some(budget) });
                BUDGETS.into_iter().filter_map(setting).collect()
            }
            MethodKind::Controlled => {
                let setting =
                    |tolerance| Setting { tick: offline_tick, tolerance: Some(tolerance) };
                TOLERANCES.map(setting).to_vec()
            }
        }
    }

    fn run(
        &self,
        scenario: &'static str,
        method: &'static NamedMethod,
        setting: Setting,
        effort: Effort,
    ) -> Option<StudyRow> {
        let run = PlannedRun { scenario: self, name: scenario, method, setting, effort };
        visit(method.name, &setting, run)
    }

    fn misfits(&self) -> Option<String> {
        let Plan { until, ticks, offline_tick, .. } = self.plan();
        let is_whole = |parts: f64| (parts - parts.round()).abs() < 1e-6 && parts > 0.5;
        let odd = ticks.iter().chain([&offline_tick]).find(|tick| !is_whole(until / **tick));
        if let Some(odd) = odd {
            return Some(format!("{odd} s does not divide {until} s"));
        }
        let samples = &self.reference().samples;
        let odd = ticks.iter().find_map(|tick| {
            let sample = samples.iter().find(|sample| !is_whole(sample.t / tick))?;
            Some(format!("{tick} s does not divide {} s", sample.t))
        });
        let nothing = samples.is_empty().then(|| "there are no samples".to_owned());
        odd.or(nothing)
    }
}

/// Limits of a run that has no deadline.
fn offline() -> Limits {
    Limits { events: 1_000, guards: 1_000_000, pieces: 100_000, ..Limits::default() }
}

/// One run, still without a method's type.
struct PlannedRun<'a, S> {
    scenario: &'a S,
    name: &'static str,
    method: &'static NamedMethod,
    setting: Setting,
    effort: Effort,
}

impl<S: Scenario> Visit for PlannedRun<'_, S> {
    type Output = StudyRow;

    /// What is timed is the method itself; what happens is observed through [`Any`], whose steps
    /// are the same to the last bit and which is compiled once for all methods.
    fn visit<T: Stepper + Into<Any>>(self, stepper: T) -> StudyRow {
        let Self { scenario, name, method, setting, effort } = self;
        let (stepping, limits) = match method.kind {
            MethodKind::Fixed => (Stepping::Ticks, Limits::default()),
            MethodKind::Played | MethodKind::Budgeted => (Stepping::Models, Limits::default()),
            MethodKind::Controlled => (Stepping::Ticks, offline()),
        };
        let tick = setting.tick;
        let any = stepper.into();
        let observed = observe(&RunJob { scenario, stepper: any, limits, stepping, tick });
        let job = RunJob { scenario, stepper, limits, stepping, tick };
        let times = time(&job, &observed.work, effort);
        StudyRow {
            scenario: name,
            method,
            setting,
            verdict: judge(scenario.reference(), &observed),
            counts: EvaluationCounts::new::<S>(&observed.work, setting.tick),
            times,
            energy_residual: observed.residual,
        }
    }
}
