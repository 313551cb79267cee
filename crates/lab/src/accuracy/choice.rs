//! What is asked for: which scenarios, which methods, how thoroughly.

use super::Effort;
use super::method::{METHODS, NamedMethod};
use super::study::{Setting, Study};
use crate::scenario::{SCENARIOS, ScenarioEntry};

/// Which scenarios and methods, and how much effort.
#[derive(Clone, Debug)]
pub struct StudyChoice {
    /// The scenarios, in their order.
    pub scenarios: Vec<&'static ScenarioEntry>,
    /// The methods, in their order.
    pub methods: Vec<&'static NamedMethod>,
    /// How much time is spent.
    pub effort: Effort,
}

/// A name that nothing has.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Unknown {
    /// What it should be a name of.
    pub what: &'static str,
    pub name: String,
    /// The names that there are.
    pub known: Vec<&'static str>,
}

impl StudyChoice {
    /// The scenarios and methods of these names; no names are all of them.
    ///
    /// # Errors
    /// Every name that is unknown.
    pub fn new(
        scenarios: &[String],
        methods: &[String],
        effort: Effort,
    ) -> Result<Self, Vec<Unknown>> {
        let scenario_names: Vec<_> = SCENARIOS.iter().map(|entry| entry.name).collect();
        let method_names: Vec<_> = METHODS.iter().map(|method| method.name).collect();
        let mut unknown = strangers("scenario", scenarios, &scenario_names);
        unknown.extend(strangers("method", methods, &method_names));
        if !unknown.is_empty() {
            return Err(unknown);
        }
        let is_asked_for =
            |asked: &[String], name| asked.is_empty() || asked.iter().any(|it| it == name);
        Ok(Self {
            scenarios: SCENARIOS.iter().filter(|it| is_asked_for(scenarios, it.name)).collect(),
            methods: METHODS.iter().filter(|it| is_asked_for(methods, it.name)).collect(),
            effort,
        })
    }

    /// The runs of one scenario, series by series.
    pub(super) fn runs(&self, study: &dyn Study) -> Vec<(&'static NamedMethod, Setting)> {
        let stride = if self.effort.is_quick { 2 } else { 1 };
        let settings = |method: &&'static NamedMethod| {
            let method = *method;
            study.settings(method).into_iter().step_by(stride).map(move |it| (method, it))
        };
        self.methods.iter().flat_map(settings).collect()
    }

    /// How many runs there are in all; what cannot be read has none.
    pub fn count(&self) -> usize {
        let runs =
            |entry: &&ScenarioEntry| entry.build().map_or(0, |it| self.runs(it.as_ref()).len());
        self.scenarios.iter().map(runs).sum()
    }
}

/// The names that are not among those `known`.
fn strangers(what: &'static str, names: &[String], known: &[&'static str]) -> Vec<Unknown> {
    let is_unknown = |name: &&String| !known.contains(&name.as_str());
    let unknown = |name: &String| Unknown { what, name: name.clone(), known: known.to_vec() };
    names.iter().filter(is_unknown).map(unknown).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(names: &[&str]) -> Vec<String> {
        names.iter().map(|name| (*name).to_owned()).collect()
    }

    #[test]
    fn no_names_are_all_of_them() {
        let choice = StudyChoice::new(&[], &[], Effort::QUICK).unwrap();
        assert_eq!(choice.scenarios.len(), SCENARIOS.len());
        assert_eq!(choice.methods.len(), METHODS.len());
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
