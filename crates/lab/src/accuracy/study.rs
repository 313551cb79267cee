//! A scenario with its model's type erased.

use super::method::{NamedMethod, Setting};
use super::row::{EvaluationCounts, StudyRow};
use super::{Effort, job::RunJob, judge::judge, observe::observe, time::time};
use crate::scenario::{BadFile, Plan, Scenario, ScenarioEntry, ScenarioVisitor};

pub(super) trait Study {
    fn plan(&self) -> Plan;

    /// Returns a run without number and name.
    fn run(&self, method: &'static NamedMethod, setting: Setting, effort: Effort) -> StudyRow;
}

pub(super) fn build(entry: &ScenarioEntry) -> Result<Box<dyn Study>, BadFile> {
    entry.visit(BoxedStudy)
}

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

    /// Runs as the host does, with one type for all methods, so that less code is compiled.
    fn run(&self, method: &'static NamedMethod, setting: Setting, effort: Effort) -> StudyRow {
        let job = RunJob {
            scenario: self,
            stepper: method.stepper(&setting),
            limits: method.limits(),
            stepping: method.stepping(),
            tick: setting.tick,
        };
        let observed = observe(&job);
        let times = time(&job, &observed, effort);
        StudyRow {
            number: 0,
            scenario: String::new(),
            method,
            setting,
            verdict: judge(self.reference(), &observed),
            counts: EvaluationCounts::new::<S>(&observed.work, setting.tick),
            times,
            energy_residual: Some(observed.residual).filter(|it| it.is_finite()),
        }
    }
}
