//! A scenario whose model's type is known by name only, and the runs it can do.

use super::Effort;
use super::job::RunJob;
use super::judge::judge;
use super::method::{NamedMethod, Setting};
use super::observe::observe;
use super::row::{EvaluationCounts, StudyRow};
use super::time::time;
use crate::scenario::{BadFile, Plan, Scenario, ScenarioEntry, ScenarioVisitor};
use cli::simulate::MethodVisitor;
use pode::Stepper;

/// A scenario that can be run with every method.
pub(super) trait Study {
    /// Returns how long the scenario is run, and with which ticks.
    fn plan(&self) -> Plan;

    /// Does one run, judges and times it.
    fn run(
        &self,
        scenario: &'static str,
        method: &'static NamedMethod,
        setting: Setting,
        effort: Effort,
    ) -> StudyRow;
}

/// Builds the scenario of an entry.
///
/// # Errors
/// When its reference cannot be read.
pub(super) fn build(entry: &ScenarioEntry) -> Result<Box<dyn Study>, BadFile> {
    entry.visit(BoxedStudy)
}

/// Forgets a scenario's type.
struct BoxedStudy;

impl ScenarioVisitor for BoxedStudy {
    type Output = Box<dyn Study>;

    fn visit<S: Scenario + 'static>(self, scenario: S) -> Box<dyn Study> {
        Box::new(scenario)
    }
}

impl<S: Scenario> Study for S {
    fn plan(&self) -> Plan {
        Scenario::plan(self)
    }

    /// Observed and timed as the host runs it, by a method that is one of several: compiled once
    /// for each type of scenario.
    fn run(
        &self,
        scenario: &'static str,
        method: &'static NamedMethod,
        setting: Setting,
        effort: Effort,
    ) -> StudyRow {
        let run = StudyRun { scenario: self, name: scenario, method, setting, effort };
        method.stepper(&setting).visit(run)
    }
}

/// A run whose method is known by its name only.
struct StudyRun<'a, S> {
    scenario: &'a S,
    name: &'static str,
    method: &'static NamedMethod,
    setting: Setting,
    effort: Effort,
}

impl<S: Scenario> MethodVisitor for StudyRun<'_, S> {
    type Output = StudyRow;

    fn visit<T: Stepper>(self, stepper: T) -> StudyRow {
        let Self { scenario, name, method, setting, effort } = self;
        let job = RunJob {
            scenario,
            stepper,
            limits: method.limits(),
            stepping: method.stepping(),
            tick: setting.tick,
        };
        let observed = observe(&job);
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
