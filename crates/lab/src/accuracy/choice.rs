use serde::{Deserialize, Serialize};

use super::method::{METHODS, NamedMethod, Setting};
use super::{Effort, study};
use crate::part::StudyPart;
use crate::scenario::{Plan, SCENARIOS, ScenarioEntry};

/// Name of the long runs among the scenarios.
pub const LONG_RUN: &str = "long-run";

/// A study as it was asked for; an empty list is all.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub struct StudyNames {
    pub scenarios: Vec<String>,
    pub methods: Vec<String>,
    pub is_quick: bool,
}

/// Scenarios and methods of a study, how thoroughly they are run, and the share of the runs.
#[derive(Clone, Debug)]
pub struct StudyChoice {
    pub names: StudyNames,
    pub scenarios: Vec<&'static ScenarioEntry>,
    pub methods: Vec<&'static NamedMethod>,
    pub effort: Effort,
    pub part: StudyPart,
}

/// Most ticks of a run in a quick study.
const QUICK_TICKS: f64 = 20_000.0;

/// A name that no scenario or method has.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct UnknownName {
    /// `scenario` or `method`.
    pub what: &'static str,
    pub name: String,
    pub known: Vec<&'static str>,
}

impl StudyChoice {
    /// Chooses the scenarios and methods with these names; an empty list chooses all.
    pub fn new(
        scenarios: &[String],
        methods: &[String],
        effort: Effort,
    ) -> Result<Self, Vec<UnknownName>> {
        let scenario_names: Vec<_> =
            SCENARIOS.iter().map(|entry| entry.name).chain([LONG_RUN]).collect();
        let method_names: Vec<_> = METHODS.iter().map(|method| method.name).collect();
        let mut unknown = unknown_names("scenario", scenarios, &scenario_names);
        unknown.extend(unknown_names("method", methods, &method_names));
        if !unknown.is_empty() {
            return Err(unknown);
        }
        Ok(Self {
            names: StudyNames {
                scenarios: scenarios.to_vec(),
                methods: methods.to_vec(),
                is_quick: effort.is_quick,
            },
            scenarios: SCENARIOS.iter().filter(|it| is_asked_for(scenarios, it.name)).collect(),
            methods: METHODS.iter().filter(|it| is_asked_for(methods, it.name)).collect(),
            effort,
            part: StudyPart::WHOLE,
        })
    }

    pub(super) fn runs(&self, plan: &Plan) -> Vec<(&'static NamedMethod, Setting)> {
        let (stride, most) =
            if self.effort.is_quick { (2, QUICK_TICKS) } else { (1, f64::INFINITY) };
        let settings = |method: &&'static NamedMethod| {
            let method = *method;
            let settings = method.settings(plan).into_iter().step_by(stride);
            let is_short = |it: &Setting| plan.until / it.tick <= most;
            settings.filter(is_short).map(move |it| (method, it)).collect::<Vec<_>>()
        };
        self.methods.iter().flat_map(settings).collect()
    }

    /// Returns the number of runs in the share; a scenario that cannot be read counts 0.
    pub fn count(&self) -> usize {
        let taken = |runs: usize| (0..runs).filter(|number| self.part.takes(*number)).count();
        let runs = |entry: &&ScenarioEntry| {
            study::build(entry).map_or(0, |study| taken(self.runs(&study.plan()).len()))
        };
        self.scenarios.iter().map(runs).sum::<usize>() + taken(self.long_runs())
    }

    /// Returns the number of long runs in all shares.
    pub fn long_runs(&self) -> usize {
        if is_asked_for(&self.names.scenarios, LONG_RUN) { self.methods.len() } else { 0 }
    }
}

/// Returns `true` if `asked` has the name, or is empty, which asks for all.
pub(crate) fn is_asked_for(asked: &[String], name: &str) -> bool {
    asked.is_empty() || asked.iter().any(|it| it == name)
}

pub(crate) fn unknown_names(
    what: &'static str,
    names: &[String],
    known: &[&'static str],
) -> Vec<UnknownName> {
    let is_unknown = |name: &&String| !known.contains(&name.as_str());
    let unknown = |name: &String| UnknownName { what, name: name.clone(), known: known.to_vec() };
    names.iter().filter(is_unknown).map(unknown).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(names: &[&str]) -> Vec<String> {
        names.iter().map(|name| (*name).to_owned()).collect()
    }

    #[test]
    fn every_unknown_name_is_told_at_once() {
        let scenarios = names(&["ball", "bell"]);
        let unknown = StudyChoice::new(&scenarios, &names(&["rk5"]), Effort::QUICK).unwrap_err();
        let told: Vec<_> = unknown.iter().map(|it| (it.what, it.name.as_str())).collect();
        assert_eq!(told, [("scenario", "bell"), ("method", "rk5")]);
    }

    #[test]
    fn methods_have_different_names() {
        let mut names: Vec<_> = METHODS.iter().map(|method| method.name).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), METHODS.len());
    }
}
