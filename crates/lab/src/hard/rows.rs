//! All runs of the chosen cases and methods.

use std::collections::BTreeMap;
use std::sync::Arc;

use cli::simulate::StudiedMethod;
use figures::parallel::in_parallel;
use instruments::LoadedModel;
use mechanism::Library;
use serde::Serialize;

use super::case::{HardCase, HardFailure};
use super::run::{HardRun, HardVerdict};
use crate::accuracy::{UnknownName, unknown_names};

/// Methods that a case must not defeat without a report, at its shortest step.
const FULL: [&str; 5] = ["rk4", "dop853", "tsitouras5", "by-need", "exact"];

/// Methods of a quick study, if none is named.
const QUICK: [&str; 4] = ["rk4", "dop853", "by-need", "exact"];

/// A case with a description that has mistakes, all of them on `mistakes`.
#[derive(Clone, Debug, thiserror::Error)]
#[error("the description of {case:?} has mistakes: {mistakes}")]
pub struct BadCase {
    pub case: String,
    pub mistakes: String,
}

/// Cases and methods of a study.
#[derive(Clone, Debug)]
pub struct HardChoice {
    pub cases: Vec<&'static HardCase>,
    pub methods: Vec<&'static str>,
    /// Stride through the steps of a case; the shortest is always run.
    stride: usize,
}

impl HardChoice {
    /// Chooses from `all` the cases and methods with these names; an empty list chooses all.
    pub fn new(
        all: &'static [HardCase],
        cases: &[String],
        methods: &[String],
    ) -> Result<Self, Vec<UnknownName>> {
        let known: Vec<_> = all.iter().map(|it| it.name.as_str()).collect();
        let names: Vec<_> = StudiedMethod::names().collect();
        let mut unknown = unknown_names("case", cases, &known);
        unknown.extend(unknown_names("method", methods, &names));
        if !unknown.is_empty() {
            return Err(unknown);
        }
        let is_asked_for =
            |asked: &[String], name: &str| asked.is_empty() || asked.iter().any(|it| it == name);
        Ok(Self {
            cases: all.iter().filter(|it| is_asked_for(cases, &it.name)).collect(),
            methods: names.into_iter().filter(|it| is_asked_for(methods, it)).collect(),
            stride: 1,
        })
    }

    /// Leaves out long cases, every second step, and methods beyond those of a quick study.
    #[must_use]
    pub fn quick(mut self) -> Self {
        self.cases.retain(|it| !it.is_long);
        if self.methods.len() == StudiedMethod::names().count() {
            self.methods.retain(|it| QUICK.contains(it));
        }
        Self { stride: 2, ..self }
    }

    fn steps(&self, case: &HardCase) -> Vec<f64> {
        let mut steps: Vec<_> = case.steps.iter().rev().step_by(self.stride).copied().collect();
        steps.reverse();
        steps
    }

    /// Returns the number of runs.
    pub fn count(&self) -> usize {
        let steps = self.cases.iter().map(|it| self.steps(it).len());
        self.methods.len() * steps.sum::<usize>()
    }
}

/// A case with all its runs, method by method, the longest step first.
#[derive(Clone, Debug)]
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
        let is_failure = |it: &&HardRun| HardVerdict::Reported < it.verdict;
        self.judged().filter(is_failure).collect()
    }

    /// Returns `true` if the case failed, and its file has no explanation.
    pub fn is_unexplained(&self) -> bool {
        self.case.explained.is_none() && !self.failures().is_empty()
    }

    /// Describes the outcome of the methods that must be right, over all steps.
    pub fn outcome(&self) -> String {
        let full: Vec<_> = self.runs.iter().filter(|it| FULL.contains(&it.method)).collect();
        let count = |verdict| full.iter().filter(|it| it.verdict == verdict).count();
        let reported = match count(HardVerdict::Reported) {
            0 => String::new(),
            some => format!(", {some} reported"),
        };
        let count = format!("{} of {} runs right{reported}", count(HardVerdict::Right), full.len());
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

/// Figures of a study, for programs.
#[derive(Clone, Debug, Serialize)]
pub struct HardSummary<'a> {
    pub cases: usize,
    pub runs: usize,
    pub verdicts: BTreeMap<&'static str, usize>,
    /// Cases that failed, each with the reason if it is known.
    pub failed: BTreeMap<&'a str, Option<&'a str>>,
    pub rows: BTreeMap<&'a str, &'a [HardRun]>,
}

impl<'a> HardSummary<'a> {
    pub fn new(rows: &'a [HardRow]) -> Self {
        let runs = || rows.iter().flat_map(|it| &it.runs);
        let count = |verdict| runs().filter(|it| it.verdict == verdict).count();
        let failed = rows.iter().filter(|it| !it.failures().is_empty());
        Self {
            cases: rows.len(),
            runs: runs().count(),
            verdicts: HardVerdict::ALL.map(|it| (it.title(), count(it))).into(),
            failed: failed.map(|it| (&*it.case.name, it.case.explained.as_deref())).collect(),
            rows: rows.iter().map(|it| (&*it.case.name, &*it.runs)).collect(),
        }
    }
}

type CaseModel = Result<Arc<LoadedModel>, String>;

/// Runs the chosen cases on all processors; calls `done` after each run.
///
/// # Errors
/// A description has mistakes.
pub fn measure(choice: &HardChoice, done: &(dyn Fn() + Sync)) -> Result<Vec<HardRow>, BadCase> {
    let library = Library::default();
    let mut models = Vec::new();
    for case in &choice.cases {
        let model: CaseModel = case.load(&library);
        match (&model, case.expected.fails) {
            (Err(_), Some(HardFailure::Mistake)) | (Ok(_), _) => models.push(model),
            (Err(mistakes), _) => {
                return Err(BadCase { case: case.name.clone(), mistakes: mistakes.clone() });
            }
        }
    }
    let methods = || choice.methods.iter().copied();
    let all = 0..choice.cases.len();
    let mut jobs: Vec<_> = all.flat_map(|case| methods().map(move |it| (case, it))).collect();
    // Long cases first, so that no processor waits for the last of them.
    jobs.sort_by_key(|(case, _)| !choice.cases[*case].is_long);
    let found = in_parallel(&jobs, &|(place, method)| {
        let case = choice.cases[*place];
        let run = |step| {
            let run = run(case, &models[*place], method, step);
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
    Ok(rows)
}

fn run(case: &HardCase, model: &CaseModel, method: &'static str, step: f64) -> HardRun {
    match (model, case.expected.fails) {
        (Err(mistakes), _) => HardRun::ended(method, step, HardVerdict::Right, mistakes.clone()),
        (Ok(_), Some(HardFailure::Mistake)) => {
            let remark = "the description is accepted".to_owned();
            HardRun::ended(method, step, HardVerdict::Wrong, remark)
        }
        (Ok(model), _) => case.run(model, method, step),
    }
}
