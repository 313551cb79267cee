//! Instruments of the user's own folder: listed in the catalogue, saved from what plays.

use std::{collections::BTreeMap, fs, sync::Arc};

use documents::{quoted, shown};
use keyboard::{Difference, KEYS};
use scene::{CompassDifferences, Instrument, InstrumentEdit};
use telemetry::request::ParameterDifferences;

use super::{FingerOwner, RequestHandler, current_voices::CurrentVoices, folders::Overwriting};
use crate::observe;

impl RequestHandler {
    /// Saves differences from a playing instrument as a file that plays the same to the last bit.
    ///
    /// # Errors
    /// A sentence; nothing was written.
    pub(super) fn save_instrument(
        &self,
        (name, base): (&str, &str),
        (differences, overwriting): (&[ParameterDifferences], Overwriting),
        (who, by): (&str, FingerOwner),
    ) -> Result<String, String> {
        let path = self.folders.new_instrument(name)?;
        if path.exists() && overwriting == Overwriting::Refused {
            return Err(format!("an instrument {} exists", quoted(name)));
        }
        let edit = edit_of(differences)?;
        let (path_of_base, instrument) = self.base(base, by)?;
        refuse_other_values(&self.playing(), base, &instrument, &edit)?;
        let text = instrument.edited(&path_of_base, name, &edit);
        // Damage must not replace a good file.
        let part = path.with_added_extension("part");
        let written = fs::write(&part, text).and_then(|()| fs::rename(&part, &path));
        written.map_err(|error| format!("{} cannot be written: {error}", shown(&path)))?;
        let saved = self.load_instrument(&path.to_string_lossy(), by)?;
        self.note_own(saved);
        let text = format!("{name} is saved as {}", shown(&path));
        self.tell(&text, who);
        Ok(text)
    }

    /// Loads the playing instrument `name`; returns its name in files, too.
    fn base(&self, name: &str, by: FingerOwner) -> Result<(String, Instrument), String> {
        let playing = self.playing();
        let path = playing.files().find(|file| file.name == name).map(|file| file.path.clone());
        drop(playing);
        let path = path.map_or_else(|| self.folders.instrument(name), Ok)?;
        let instrument = self.load_instrument(&path, by)?;
        Ok((path, instrument))
    }

    pub(super) fn load_instrument(
        &self,
        name_or_path: &str,
        by: FingerOwner,
    ) -> Result<Instrument, String> {
        let load = |_flag: &_| Instrument::load(&self.scene.library, name_or_path);
        self.run.background.load(by, load)?.map_err(|mistakes| mistakes.to_string())
    }

    pub(super) fn note_own(&self, instrument: Instrument) {
        self.own_instruments().insert(instrument.name.clone(), Arc::new(instrument));
        self.send_catalogue();
    }

    /// Sends the catalogue with the user's own instruments, those that play with their values.
    pub fn list_own_instruments(&self) {
        let playing: BTreeMap<_, _> =
            self.playing().files().map(|it| (it.name.clone(), it.path.clone())).collect();
        if playing.is_empty() && self.folders.own_instruments().is_empty() {
            return;
        }
        let loaded = playing.iter().filter_map(|(name, path)| {
            let instrument = self.load_instrument(path, None).ok()?;
            Some((name.clone(), Arc::new(instrument)))
        });
        let loaded: Vec<_> = loaded.collect();
        self.own_instruments().extend(loaded);
        self.send_catalogue();
    }

    pub(super) fn own_entries(&self) -> Vec<telemetry::Instrument> {
        let known = self.own_instruments();
        let mut entries: Vec<_> = known.values().map(|it| observe::instrument(it)).collect();
        let files = self.folders.own_instruments();
        let unread = files.into_iter().filter(|(name, _)| !known.contains_key(name));
        entries.extend(unread.map(|(name, path)| {
            let doc = shown(&path).clone();
            telemetry::Instrument { name, doc, is_own: true, ..Default::default() }
        }));
        entries.sort_by(|a, b| a.name.cmp(&b.name));
        entries
    }
}

fn edit_of(differences: &[ParameterDifferences]) -> Result<InstrumentEdit, String> {
    let mut edit = InstrumentEdit::new();
    for ParameterDifferences { parameter, keys } in differences {
        let compass: &mut CompassDifferences =
            edit.entry(parameter.clone()).or_insert([None; KEYS]);
        for (key, difference) in keys {
            let place = compass.get_mut(usize::from(*key)).filter(|_| is_finite(*difference));
            *place.ok_or_else(|| format!("{parameter} has no difference of key {key}"))? =
                Some(*difference);
        }
    }
    Ok(edit)
}

const fn is_finite(difference: Difference) -> bool {
    difference.amount().is_finite()
}

fn refuse_other_values(
    playing: &CurrentVoices,
    base: &str,
    instrument: &Instrument,
    edit: &InstrumentEdit,
) -> Result<(), String> {
    let model = instrument.model();
    let unknown = edit.keys().find(|name| !model.parameters.iter().any(|it| it.name == **name));
    if let Some(name) = unknown {
        return Err(format!("{base} has no parameter {}", quoted(name)));
    }
    for (key, voice) in playing.played_by(base) {
        let values = model.parameters.iter().zip(instrument.values(key)).zip(&voice.values);
        for ((parameter, value), now) in values {
            let difference = edit.get(parameter.name).and_then(|it| it[usize::from(key)]);
            let value = difference.map_or(value, |it| it.applied_to(value));
            if value.to_bits() != now.to_bits() {
                let name = parameter.name;
                return Err(format!(
                    "{name} of key {key} is {now:?} by now, not {value:?}: save once more"
                ));
            }
        }
    }
    Ok(())
}
