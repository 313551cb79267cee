//! Other values for the voices of a running host: checked as a whole, then put in.

use std::collections::BTreeMap;

use models::Parameter;
use telemetry::request::Change;

use crate::observe::instrument_of;
use diagnostics::{choice, quoted};
use scene::KeyVoice;

/// What plays on each key now.
#[derive(Clone, Debug)]
pub(super) struct CurrentVoices {
    pub(super) keys: Vec<Option<KeyVoice>>,
    /// The instruments that they came from, as far as that is known.
    pub(super) instruments: Vec<Option<String>>,
}

/// Mistakes that are told at once.
const MOST_TOLD: usize = 5;

impl CurrentVoices {
    /// As a scene begins.
    pub(super) fn new(keys: Vec<Option<KeyVoice>>) -> Self {
        let of = |(key, voice): (u8, &Option<KeyVoice>)| instrument_of(key, voice.as_ref()?);
        let instruments = (0..).zip(&keys).map(of).collect();
        Self { keys, instruments }
    }

    /// The voices of all keys that `changes` touch, with all of them.
    ///
    /// # Errors
    /// What is wrong with any of them, in a sentence each.
    pub(super) fn changed(&self, changes: &[Change]) -> Result<BTreeMap<u8, KeyVoice>, String> {
        let mut voices = BTreeMap::new();
        let mut wrong = Vec::new();
        for change in changes {
            if let Err(why) = self.apply(change, &mut voices) {
                wrong.push(why);
            }
        }
        let more = wrong.len().saturating_sub(MOST_TOLD);
        wrong.truncate(MOST_TOLD);
        if 0 < more {
            wrong.push(format!("and {more} more"));
        }
        if wrong.is_empty() { Ok(voices) } else { Err(wrong.join("; ")) }
    }

    fn apply(&self, change: &Change, voices: &mut BTreeMap<u8, KeyVoice>) -> Result<(), String> {
        let Change { key, parameter: wanted, value } = change;
        let playing = self.keys.get(usize::from(*key)).and_then(Option::as_ref);
        let playing = playing.ok_or_else(|| format!("key {key} has no voice in this scene"))?;
        let parameters = playing.model.parameters;
        let index = parameters.iter().position(|it| it.name == wanted).ok_or_else(|| {
            let known = parameters.iter().map(|it| it.name);
            let (model, wanted) = (playing.model.name, quoted(wanted));
            format!("{model} has no parameter {wanted}: {}", choice(&change.parameter, known))
        })?;
        refuse(&parameters[index], *value)?;
        let voice = voices.entry(*key).or_insert_with(|| playing.clone());
        voice.values[index] = *value;
        Ok(())
    }
}

/// Refuses what is no value of `parameter`.
fn refuse(parameter: &Parameter, value: f64) -> Result<(), String> {
    let Parameter { name, unit, range: (low, high), .. } = parameter;
    if (*low..=*high).contains(&value) {
        return Ok(());
    }
    Err(format!("{name} is {low} to {high} {unit}, not {value}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use scene::Scene;

    fn playing() -> CurrentVoices {
        CurrentVoices::new(Scene::load("default", &[]).expect("the default scene").keys)
    }

    fn change(key: u8, parameter: &str, value: f64) -> Change {
        Change { key, parameter: parameter.into(), value }
    }

    #[test]
    fn changes_of_one_key_come_together() {
        let changes = [change(3, "k2", 900.0), change(3, "g", 9.0), change(4, "g", 8.0)];
        let voices = playing().changed(&changes).expect("good changes");
        assert_eq!(voices.keys().copied().collect::<Vec<_>>(), [3, 4]);
        let value = |key: u8, name: &str| {
            let voice = &voices[&key];
            let index = voice.model.parameters.iter().position(|it| it.name == name);
            voice.values[index.expect("a parameter")]
        };
        assert!((value(3, "k2") - 900.0).abs() < 1e-12 && (value(4, "g") - 8.0).abs() < 1e-12);
    }

    #[test]
    fn all_that_is_wrong_is_said_and_nothing_is_changed() {
        let wrong = [
            change(3, "k2", 900.0),
            change(88, "k2", 1.0),
            change(3, "k22", 1.0),
            change(3, "g", f64::NAN),
            change(3, "g", -1.0),
        ];
        let said = playing().changed(&wrong).expect_err("wrong changes");
        assert_eq!(said.split("; ").count(), 4, "{said}");
        assert!(said.contains("key 88 has no voice"), "{said}");
        assert!(said.contains("no parameter \"k22\"") && said.contains("\"k2\""), "{said}");
        assert!(said.contains("g is 0 to 1000 m/s², not NaN"), "{said}");
    }

    #[test]
    fn a_flood_of_mistakes_is_cut() {
        let wrong: Vec<_> = (0..50).map(|_| change(3, "no", 1.0)).collect();
        let said = playing().changed(&wrong).expect_err("wrong changes");
        assert!(said.ends_with("and 45 more"), "{said}");
    }
}
