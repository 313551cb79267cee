//! All runs of the chosen cases and methods.

use figures::parallel::in_parallel;
use mechanism::Library;
use pode::stepper::Any;
use serde::Serialize;

use super::case::{HARD_CASES, HardCase, HardFailure};
use super::run::{HardRun, HardVerdict};
use crate::accuracy::{UnknownName, is_asked_for, unknown_names};

/// Methods that a case must not defeat without a report, at its shortest step.
const FULL: [&str; 5] = ["rk4", "dop853", "tsitouras5", "by-need", "exact"];

/// Methods of a quick study, if none is named.
const QUICK: [&str; 4] = ["rk4", "dop853", "by-need", "exact"];

/// Cases and methods of a study.
#[derive(Clone, Debug)]
pub struct HardChoice {
    pub cases: Vec<&'static HardCase>,
    pub methods: Vec<&'static str>,
    /// Stride through the steps of a case; the shortest is always run.
    stride: usize,
}

impl HardChoice {
    /// Chooses the cases and methods with these names; an empty list chooses all.
    pub fn new(cases: &[String], methods: &[String]) -> Result<Self, Vec<UnknownName>> {
        let known: Vec<_> = HARD_CASES.iter().map(|it| it.name.as_str()).collect();
        let mut unknown = unknown_names("case", cases, &known);
        unknown.extend(unknown_names("method", methods, Any::NAMES));
        if !unknown.is_empty() {
            return Err(unknown);
        }
        Ok(Self {
            cases: HARD_CASES.iter().filter(|it| is_asked_for(cases, &it.name)).collect(),
            methods: Any::NAMES.iter().copied().filter(|it| is_asked_for(methods, it)).collect(),
            stride: 1,
        })
    }

    /// Leaves out long cases, every second step, and methods beyond those of a quick study.
    #[must_use]
    pub fn quick(mut self) -> Self {
        self.cases.retain(|it| !it.is_long);
        if self.methods.len() == Any::NAMES.len() {
            self.methods.retain(|it| QUICK.contains(it));
        }
        Self { stride: 2, ..self }
    }

    fn steps(&self, case: &HardCase) -> Vec<f64> {
        case.steps.iter().skip(self.stride - 1).step_by(self.stride).copied().collect()
    }

    /// Returns the number of runs.
    pub fn count(&self) -> usize {
        let steps = self.cases.iter().map(|it| self.steps(it).len());
        self.methods.len() * steps.sum::<usize>()
    }
}

/// A case with all its runs, method by method, the longest step first.
#[derive(Clone, Debug, Serialize)]
pub struct HardRow {
    pub case: &'static HardCase,
    pub runs: Vec<HardRun>,
}

impl HardRow {
    /// Returns the runs of methods that must be right, at the shortest step.
    fn judged(&self) -> impl Iterator<Item = &HardRun> {
        let shortest = self.runs.iter().map(|it| it.step).fold(f64::INFINITY, f64::min);
        let is_judged = move |it: &&HardRun| it.step <= shortest && FULL.contains(&it.method);
        self.runs.iter().filter(is_judged)
    }

    /// Returns the runs for which the case counts as failed.
    pub fn failures(&self) -> Vec<&HardRun> {
        self.judged().filter(|it| it.verdict.is_silent()).collect()
    }

    /// Returns `true` if the case failed, and its file has no explanation.
    pub fn is_unexplained(&self) -> bool {
        self.case.explained.is_none() && !self.failures().is_empty()
    }

    /// Describes the outcome of the methods that must be right, over all steps.
    pub fn outcome(&self) -> String {
        let full: Vec<_> = self.runs.iter().filter(|it| FULL.contains(&it.method)).collect();
        let right = full.iter().filter(|it| it.verdict == HardVerdict::Right).count();
        let count = format!("{right} of {} runs right", full.len());
        let shown = match self.case.expected.fails {
            Some(HardFailure::Mistake) => "the description is rejected".to_owned(),
            Some(HardFailure::Fault) => "the run ends there with a fault".to_owned(),
            None => match self.judged().filter_map(HardRun::error).reduce(f64::max) {
                Some(error) => format!("error at most {error:.0e} at the shortest step"),
                None => "the events are right".to_owned(),
            },
        };
        match &self.case.explained {
            Some(why) if !self.failures().is_empty() => format!("{count}; {why}"),
            _ => format!("{count}; {shown}"),
        }
    }
}

/// Runs the chosen cases on all processors; calls `done` after each run.
pub fn measure(choice: &HardChoice, done: &(dyn Fn() + Sync)) -> Vec<HardRow> {
    let library = Library::default();
    let models: Vec<_> = choice.cases.iter().map(|case| case.load(&library)).collect();
    let methods = || choice.methods.iter().copied();
    let all = 0..choice.cases.len();
    let mut jobs: Vec<_> = all.flat_map(|case| methods().map(move |it| (case, it))).collect();
    // Long cases first, so that no processor waits for the last of them.
    jobs.sort_by_key(|(case, _)| !choice.cases[*case].is_long);
    let found = in_parallel(&jobs, &|(place, method)| {
        let case = choice.cases[*place];
        let run = |step| {
            let run = case.run(&models[*place], method, step);
            done();
            run
        };
        choice.steps(case).into_iter().map(run).collect::<Vec<_>>()
    });
    let mut rows: Vec<_> =
        choice.cases.iter().map(|case| HardRow { case, runs: Vec::new() }).collect();
    for ((case, _), runs) in jobs.iter().zip(found) {
        rows[*case].runs.extend(runs);
    }
    rows
}
