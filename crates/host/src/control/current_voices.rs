//! The voices that play in a running host, and changes of their values, checked as a whole.

use std::collections::BTreeMap;

use models::Parameter;
use telemetry::request::Change;
use telemetry::stream::ParameterSetting;

use crate::observe::instrument_of;
use diagnostics::{choice, quoted};
use scene::KeyVoice;

/// The voice that plays on each key.
#[derive(Clone, Debug)]
pub(super) struct CurrentVoices {
    pub(super) keys: Vec<Option<KeyVoice>>,
    /// The names of their instruments, as far as they are known.
    pub(super) instruments: Vec<Option<String>>,
}

/// Most mistakes that one answer names.
const MOST_TOLD: usize = 5;

impl CurrentVoices {
    /// Returns the voices with which a scene begins.
    pub(super) fn new(keys: Vec<Option<KeyVoice>>) -> Self {
        let of = |(key, voice): (u8, &Option<KeyVoice>)| instrument_of(key, voice.as_ref()?);
        let instruments = (0..).zip(&keys).map(of).collect();
        Self { keys, instruments }
    }

    /// Returns the voices of all keys that `changes` touch, with their new values.
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

    /// Takes note that `voices` play; of `instrument`, or of the one that was there.
    pub(super) fn put_in(&mut self, voices: BTreeMap<u8, KeyVoice>, instrument: Option<&str>) {
        for (key, voice) in voices {
            let key = usize::from(key);
            self.keys[key] = Some(voice);
            if let Some(name) = instrument {
                self.instruments[key] = Some(name.to_owned());
            }
        }
    }

    /// Returns the value of each parameter of each voice, in the order of keys.
    pub(super) fn settings(&self) -> Vec<ParameterSetting> {
        let voices = (0..).zip(&self.keys).filter_map(|(key, it)| Some((key, it.as_ref()?)));
        let of = |(key, it): (u8, &KeyVoice)| -> Vec<ParameterSetting> {
            let values = it.model.parameters.iter().zip(&it.values);
            values.map(|(parameter, value)| setting_of(key, parameter.name, *value)).collect()
        };
        voices.flat_map(of).collect()
    }

    /// Returns the value of the parameter that the stream calls `name`, if there is one.
    pub(super) fn setting(&self, name: &str) -> Option<ParameterSetting> {
        let Change { key, parameter: wanted, .. } = Change::named(name, 0.0)?;
        let voice = self.keys.get(usize::from(key))?.as_ref()?;
        let index = voice.model.parameters.iter().position(|it| it.name == wanted)?;
        Some(setting_of(key, &wanted, *voice.values.get(index)?))
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

/// Returns a value of a key's voice as a parameter of the stream.
pub(super) fn setting_of(key: u8, parameter: &str, value: f64) -> ParameterSetting {
    let change = Change { key, parameter: parameter.to_owned(), value };
    ParameterSetting { name: change.name(), value }
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
    fn a_parameter_is_found_by_its_name_as_in_the_list_of_all() {
        let playing = playing();
        let all = playing.settings();
        for setting in all.iter().step_by(97) {
            assert_eq!(playing.setting(&setting.name).as_ref(), Some(setting));
        }
        for name in ["", "/key/3", "/key/3/k22", "/key/88/k2", "k2"] {
            assert_eq!(playing.setting(name), None, "{name}");
        }
        assert!(all.iter().any(|it| it.name == setting_of(3, "k2", 0.0).name));
    }

    #[test]
    fn a_flood_of_mistakes_is_cut() {
        let wrong: Vec<_> = (0..50).map(|_| change(3, "no", 1.0)).collect();
        let said = playing().changed(&wrong).expect_err("wrong changes");
        assert!(said.ends_with("and 45 more"), "{said}");
    }
}
