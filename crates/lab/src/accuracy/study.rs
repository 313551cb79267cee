//! A scenario whose model's type is known by name only, and the runs it can do.

use pode::Stepper;
use pode::stepper::StepperVisitor;

use super::Effort;
use super::job::RunJob;
use super::judge::judge;
use super::method::{NamedMethod, Setting};
use super::observe::observe;
use super::row::{EvaluationCounts, StudyRow, Times};
use super::time::time;
use crate::scenario::{BadFile, Plan, Scenario, ScenarioEntry, ScenarioVisitor};

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

    /// What happens is observed through the method of any type, which is compiled once for each
    /// model; what is timed is the method itself, whose steps are the same to the last bit.
    fn run(
        &self,
        scenario: &'static str,
        method: &'static NamedMethod,
        setting: Setting,
        effort: Effort,
    ) -> StudyRow {
        let job = RunJob {
            scenario: self,
            stepper: method.stepper(&setting),
            limits: method.limits(),
            stepping: method.stepping(),
            tick: setting.tick,
        };
        let observed = observe(&job);
        let times = job.stepper.visit(TimedRun { job: &job, work: &observed.work, effort });
        StudyRow {
            scenario,
            method,
            setting,
            verdict: judge(self.reference(), &observed),
            counts: EvaluationCounts::new::<S>(&observed.work, setting.tick),
            times,
            energy_residual: observed.residual,
        }
    }
}

/// A run that is timed under the type of its method.
struct TimedRun<'a, S, T> {
    job: &'a RunJob<'a, S, T>,
    work: &'a [pode::Work],
    effort: Effort,
}

impl<S: Scenario, T> StepperVisitor for TimedRun<'_, S, T> {
    type Output = Times;

    fn visit<U: Stepper>(self, stepper: U) -> Times {
        let RunJob { scenario, limits, stepping, tick, .. } = *self.job;
        time(&RunJob { scenario, stepper, limits, stepping, tick }, self.work, self.effort)
    }
}
