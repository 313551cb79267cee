//! The voices of a running host, and changes of their values that are checked as a whole.

use std::{collections::BTreeMap, sync::Arc};

use instruments::{LoadedModel, Parameter};
use keyboard::{KeyIndex, KeyRange};
use mechanism::unmet;
use telemetry::{key_name, request::Change, stream::ParameterSetting};

use super::description_states::known_path;
use super::new_voice::{NewVoice, VoiceHandover};
use crate::observe::instrument_of;
use documents::{choice, quoted};
use scene::{InstrumentFile, KeyVoice, Render, Scene, Voicing};

#[derive(Clone, Debug)]
pub(super) struct CurrentVoices {
    pub(super) render: Render,
    pub(super) keys: Vec<Option<KeyVoice>>,
    pub(super) instruments: Vec<Option<String>>,
    pub(super) voicings: Vec<Option<Voicing>>,
    /// Later changes of the values, by parameter.
    changed: Vec<BTreeMap<&'static str, f64>>,
}

const MOST_TOLD: usize = 5;

impl CurrentVoices {
    pub(super) fn new(scene: &Scene) -> Self {
        let keys = scene.keys.clone();
        let of = |(key, voice): (u8, &Option<KeyVoice>)| instrument_of(key, voice.as_ref()?);
        let instruments = (0..).zip(&keys).map(of).collect();
        let changed = vec![BTreeMap::new(); keys.len()];
        Self { render: scene.render, keys, instruments, voicings: scene.voicings.clone(), changed }
    }

    pub(super) fn computed_by(&self, render: Render) -> Self {
        Self { render, ..self.clone() }
    }

    pub(super) fn voice(&self, key: u8) -> Result<&KeyVoice, String> {
        let range = single(key)?;
        self.keys[usize::from(key)].as_ref().ok_or_else(|| self.missing(range))
    }

    /// Returns the keys of `range` with a voice, or a sentence if there are none.
    pub(super) fn keys_in(&self, range: KeyRange) -> Result<Vec<u8>, String> {
        let has_voice = |key: &u8| self.keys[usize::from(*key)].is_some();
        let keys: Vec<_> = range.numbers().filter(has_voice).collect();
        if keys.is_empty() { Err(self.missing(range)) } else { Ok(keys) }
    }

    fn missing(&self, keys: KeyRange) -> String {
        let is_in_scene = |key: u8| self.voicings[usize::from(key)].is_some();
        if keys.numbers().any(is_in_scene) {
            format!("no board carries {keys}")
        } else {
            format!("no voice of this scene is on {keys}")
        }
    }

    /// Returns the voices of all keys in `changes`, with their new values.
    ///
    /// # Errors
    /// A sentence on each mistake.
    pub(super) fn changed(&self, changes: &[Change]) -> Result<BTreeMap<u8, NewVoice>, String> {
        let mut voices = BTreeMap::new();
        let mut wrong = Vec::new();
        for change in changes {
            if let Err(why) = self.apply(change, &mut voices) {
                wrong.push(why);
            }
        }
        wrong.extend(voices.iter().filter_map(|(key, voice)| unmet_on(*key, voice)));
        let more = wrong.len().saturating_sub(MOST_TOLD);
        wrong.truncate(MOST_TOLD);
        if 0 < more {
            wrong.push(format!("and {more} more"));
        }
        if !wrong.is_empty() {
            return Err(wrong.join("; "));
        }
        let values = |voice| NewVoice { voice, handover: VoiceHandover::Values };
        Ok(voices.into_iter().map(|(key, voice)| (key, values(voice))).collect())
    }

    /// Returns a sentence on the changed values and their number; `None` if no value changes.
    pub(super) fn described(&self, changes: &[Change]) -> Option<(String, u32)> {
        let mut by_name: BTreeMap<&str, Vec<(u8, String)>> = BTreeMap::new();
        for Change { key, parameter: wanted, value } in changes {
            let voice = self.voice(*key).ok()?;
            let index = voice.model.parameters.iter().position(|it| it.name == wanted)?;
            let (Parameter { unit, .. }, before) =
                (&voice.model.parameters[index], voice.values[index]);
            if before.to_bits() != value.to_bits() {
                let text = format!("{before} -> {value}{}", suffix(unit));
                by_name.entry(wanted).or_default().push((*key, text));
            }
        }
        let count = by_name.values().map(Vec::len).sum::<usize>();
        let sentence = |(name, changes): (&&str, &Vec<(u8, String)>)| {
            let (first, last) = (changes.first()?, changes.last()?);
            let of = |(key, text): &(u8, String)| format!("{} {text}", key_name((*key).into()));
            Some(match changes.len() {
                1 => format!("{} {name} {}", key_name(first.0.into()), first.1),
                n => format!("{name} of {n} keys: {} to {}", of(first), of(last)),
            })
        };
        let mut sentences: Vec<_> = by_name.iter().take(MOST_TOLD).filter_map(sentence).collect();
        let more = by_name.len().saturating_sub(MOST_TOLD);
        sentences.extend((0 < more).then(|| format!("and {more} more")));
        let count = u32::try_from(count).unwrap_or(u32::MAX);
        (0 < count).then(|| (sentences.join("; "), count))
    }

    /// Returns the voices for `model` on `keys`, or else on those that play another version of its
    /// description. A new version keeps values that were changed meanwhile.
    ///
    /// # Errors
    /// A condition of the model that the values do not meet, or missing presets.
    pub(super) fn loaded(
        &self,
        model: &Arc<LoadedModel>,
        keys: Option<KeyRange>,
    ) -> Result<BTreeMap<u8, NewVoice>, String> {
        let mut voices = BTreeMap::new();
        for (key, playing) in (0..).zip(&self.keys) {
            let Some(playing) = playing.as_ref().filter(|it| !it.model.is(model)) else { continue };
            let is_version = playing.model.file().is_some() && playing.model.file() == model.file();
            if !keys.map_or(is_version, |keys| keys.numbers().contains(&key)) {
                continue;
            }
            let voice = if is_version { self.next_version(key, model) } else { None };
            let anew = || Some(NewVoice::anew(&Voicing::of_model(model)?, key, model.name));
            let voice =
                voice.or_else(anew).ok_or_else(|| format!("{} has no preset", model.name))?;
            if let Some(why) = unmet_on(key, &voice.voice) {
                return Err(why);
            }
            voices.insert(key, voice);
        }
        Ok(voices)
    }

    fn next_version(&self, key: u8, model: &Arc<LoadedModel>) -> Option<NewVoice> {
        let index = usize::from(key);
        let voicing = self.voicings.get(index)?.as_ref()?.following(model)?;
        let mut voice = KeyVoice::new(&voicing, key);
        let changed = self.changed.get(index)?;
        for (place, parameter) in voice.values.iter_mut().zip(&model.parameters) {
            let value = changed.get(parameter.name).filter(|it| refuse(parameter, **it).is_ok());
            *place = value.copied().unwrap_or(*place);
        }
        Some(NewVoice { voice, handover: VoiceHandover::Version(voicing) })
    }

    pub(super) fn put_in(&mut self, voices: BTreeMap<u8, NewVoice>) {
        for (key, NewVoice { voice, handover }) in voices {
            let key = usize::from(key);
            match handover {
                VoiceHandover::Values => self.note_changes(key, &voice),
                VoiceHandover::Anew(voicing, name) => {
                    self.voicings[key] = Some(voicing);
                    self.instruments[key] = Some(name);
                    self.changed[key].clear();
                }
                VoiceHandover::Version(voicing) => self.voicings[key] = Some(voicing),
                VoiceHandover::Settings => {}
            }
            self.keys[key] = Some(voice);
        }
    }

    fn note_changes(&mut self, key: usize, voice: &KeyVoice) {
        let before = self.keys[key].as_ref().map_or(&[][..], |before| &before.values);
        let values = voice.model.parameters.iter().zip(voice.values.iter().zip(before));
        let is_other =
            |(_, (now, before)): &(&Parameter, (&f64, &f64))| now.to_bits() != before.to_bits();
        let changed = values.filter(is_other).map(|(it, (now, _before))| (it.name, *now));
        self.changed[key].extend(changed);
    }

    pub(super) fn untouched_instrument(&self, key: u8) -> Option<&str> {
        let index = usize::from(key);
        let name = self.instruments.get(index)?.as_deref()?;
        self.changed.get(index)?.is_empty().then_some(name)
    }

    /// Returns the files of playing instruments that are no part of the program.
    pub(super) fn files(&self) -> impl Iterator<Item = &InstrumentFile> {
        self.keys.iter().flatten().filter_map(|voice| voice.file.as_deref())
    }

    /// Returns the keys of the instrument `name` and their voices.
    pub(super) fn played_by(&self, name: &str) -> Vec<(u8, &KeyVoice)> {
        let voices = (0..).zip(self.keys.iter().zip(&self.instruments));
        let of_name = voices.filter(|(_, (_, instrument))| instrument.as_deref() == Some(name));
        of_name.filter_map(|(key, (voice, _))| Some((key, voice.as_ref()?))).collect()
    }

    pub(super) fn models(&self) -> Vec<Arc<LoadedModel>> {
        crate::observe::distinct(self.keys.iter().flatten().map(|voice| &voice.model))
    }

    pub(super) fn settings(&self) -> Vec<ParameterSetting> {
        let voices = (0..).zip(&self.keys).filter_map(|(key, it)| Some((key, it.as_ref()?)));
        let of = |(key, it): (u8, &KeyVoice)| -> Vec<ParameterSetting> {
            let values = it.model.parameters.iter().zip(&it.values);
            values.map(|(parameter, value)| setting_of(key, parameter.name, *value)).collect()
        };
        voices.flat_map(of).collect()
    }

    /// Returns the value of the stream's parameter `name`, if it exists.
    pub(super) fn setting(&self, name: &str) -> Option<ParameterSetting> {
        let Change { key, parameter: wanted, .. } = Change::named(name, 0.0)?;
        let voice = self.keys.get(usize::from(key))?.as_ref()?;
        let index = voice.model.parameters.iter().position(|it| it.name == wanted)?;
        Some(setting_of(key, &wanted, *voice.values.get(index)?))
    }

    /// Returns `true` if the description of some voice was read from `file`.
    pub(super) fn plays(&self, file: &str) -> bool {
        let path = known_path(file);
        self.models().iter().any(|model| model.file() == Some(path.as_str()))
    }

    fn apply(&self, change: &Change, voices: &mut BTreeMap<u8, KeyVoice>) -> Result<(), String> {
        let Change { key, parameter: wanted, value } = change;
        let playing = self.voice(*key)?;
        let parameters = &playing.model.parameters;
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

/// Returns `true` if `scene` has a voice for `key` that was left out since no board carries it.
pub(crate) fn is_absent(scene: &Scene, key: usize) -> bool {
    scene.keys[key].is_none() && scene.voicings[key].is_some()
}

/// Returns the range of one key, or a sentence if there is no such key.
pub(super) fn single(key: u8) -> Result<KeyRange, String> {
    let range = KeyIndex::new(key).and_then(|key| KeyRange::new(key, key));
    range.ok_or_else(|| format!("there is no key {key}, give 0 to 87"))
}

pub(super) fn setting_of(key: u8, parameter: &str, value: f64) -> ParameterSetting {
    let change = Change { key, parameter: parameter.to_owned(), value };
    ParameterSetting { name: change.name(), value }
}

fn unmet_on(key: u8, voice: &KeyVoice) -> Option<String> {
    let condition = unmet(&voice.model, &voice.values).into_iter().next()?;
    let key = KeyIndex::new(key).map_or_else(String::new, |key| key.to_string());
    Some(format!("{} needs {condition}, which does not hold on {key}", voice.model.name))
}

fn refuse(parameter: &Parameter, value: f64) -> Result<(), String> {
    let Parameter { name, unit, range: (low, high), .. } = parameter;
    if (*low..=*high).contains(&value) {
        return Ok(());
    }
    Err(format!("{name} is {low} to {high}{}, not {value:?}", suffix(unit)))
}

/// Returns the unit after a number; the unit 1 is not printed.
fn suffix(unit: &str) -> String {
    if unit == "1" { String::new() } else { format!(" {unit}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn playing() -> CurrentVoices {
        CurrentVoices::new(
            &Scene::load(&scene::Library::default(), "springs", &[]).expect("a scene of ours"),
        )
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
            let voice = &voices[&key].voice;
            let index = voice.model.parameters.iter().position(|it| it.name == name);
            voice.values[index.expect("a parameter")]
        };
        assert!((value(3, "k2") - 900.0).abs() < 1e-12 && (value(4, "g") - 8.0).abs() < 1e-12);
    }

    #[test]
    fn changes_are_described_with_the_values_before() {
        let playing = playing();
        let before = |key: u8| playing.setting(&format!("/key/{key}/g")).expect("a value").value;
        let one = playing.described(&[change(39, "g", 9.0)]);
        assert_eq!(one, Some((format!("C4 g {} -> 9 m/s²", before(39)), 1)));
        let all: Vec<_> = (0..88).map(|key| change(key, "g", 9.0)).collect();
        let (low, high) = (before(0), before(87));
        let text = format!("g of 88 keys: A0 {low} -> 9 m/s² to C8 {high} -> 9 m/s²");
        assert_eq!(playing.described(&all), Some((text, 88)));
        assert_eq!(playing.described(&[change(39, "g", before(39))]), None);
    }

    #[test]
    fn all_that_is_wrong_is_said_and_nothing_is_changed() {
        let wrong = [
            change(3, "k2", 900.0),
            change(88, "k2", 1.0),
            change(3, "k22", 1.0),
            change(3, "g", f64::NAN),
            change(3, "g", -1.0),
            change(3, "restitution", 2.0),
        ];
        let said = playing().changed(&wrong).expect_err("wrong changes");
        assert_eq!(said.split("; ").count(), 5, "{said}");
        assert!(said.contains("there is no key 88"), "{said}");
        assert!(said.contains("no parameter \"k22\"") && said.contains("\"k2\""), "{said}");
        assert!(said.contains("g is 0 to 1000 m/s², not NaN"), "{said}");
        assert!(said.contains("restitution is 0 to 1, not 2"), "{said}");
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
}
