//! Tuned parameters: the values shown, the changes to request, and undo.
//!
//! A requested value is shown at once and stays until the host has answered, so that a slider never
//! jumps back. Nothing here draws or sends: [`Tuner::outgoing`] returns the changes to request.

pub mod history;
pub mod link;
pub mod preset;
pub mod snapshot;

use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};
use telemetry::request::Change;
use telemetry::source::Ticket;
use telemetry::{Model, Parameter, Update};

use crate::{names, number};
use history::UndoHistory;
use link::LinkedKeys;
use snapshot::{ParameterSlot, SlotValues, Snapshot};

/// Tuning state that is saved between starts.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct SavedTuning {
    /// Parameters that nothing changes.
    pub locked: BTreeSet<String>,
    pub compared: [Option<Snapshot>; 2],
    pub named: BTreeMap<String, Snapshot>,
}

/// Instrument of a key, as the host last reported.
#[derive(Clone, Debug)]
struct KeyInstrument {
    model: String,
    /// Version of the model's description.
    version: u32,
    instrument: String,
    values: Vec<f64>,
    revision: u32,
}

/// Sent values whose answer is pending.
#[derive(Clone, Debug)]
struct PendingValues {
    ticket: Ticket,
    values: SlotValues,
    /// Revisions of the keys' voices when the values were sent.
    revisions: BTreeMap<u8, u32>,
}

/// The parameters as the window shows and changes them.
#[derive(Clone, Debug, Default)]
pub struct Tuner {
    pub kept: SavedTuning,
    /// Models by their names and versions of their descriptions.
    models: BTreeMap<(String, u32), Model>,
    played: BTreeMap<u8, KeyInstrument>,
    /// Requested values without an answer, by key and parameter.
    wanted: BTreeMap<u8, BTreeMap<String, f64>>,
    dirty: BTreeSet<ParameterSlot>,
    asked: Option<PendingValues>,
    history: UndoHistory,
    refusal: Option<String>,
}

impl Tuner {
    /// Takes the host's reports of models and voices.
    pub fn take(&mut self, update: &Update) {
        if let Update::Catalogue(catalogue) = update {
            let models = catalogue.models.iter().cloned();
            self.models =
                models.map(|model| ((model.name.clone(), model.version), model)).collect();
        }
        if let Update::Voice(voice) = update
            && let Some(key) = number::key(voice.key)
        {
            if self.played.get(&key).is_some_and(|played| played.model != voice.model) {
                self.wanted.remove(&key);
                self.dirty.retain(|slot| slot.key != key);
            }
            let played = KeyInstrument {
                model: voice.model.clone(),
                version: voice.version,
                instrument: voice.instrument.clone(),
                values: voice.values.clone(),
                revision: voice.revision,
            };
            self.played.insert(key, played);
        }
    }

    /// Forgets sent values that will not be answered any more.
    pub fn forget(&mut self) {
        self.asked = None;
        self.dirty.clear();
        self.wanted.clear();
    }

    pub fn parameter(&self, key: u8, name: &str) -> Option<&Parameter> {
        Some(self.at(key, name)?.1)
    }

    fn at(&self, key: u8, name: &str) -> Option<(usize, &Parameter)> {
        let played = self.played.get(&key)?;
        let model = self.models.get(&(played.model.clone(), played.version))?;
        let is_it = |(_, parameter): &(usize, &Parameter)| parameter.name == name;
        model.parameters.iter().enumerate().find(is_it)
    }

    /// Returns the value to show: the requested one, else the host's.
    pub fn value(&self, key: u8, name: &str) -> Option<f64> {
        self.wanted(key, name).or_else(|| self.reported(key, name))
    }

    fn wanted(&self, key: u8, name: &str) -> Option<f64> {
        self.wanted.get(&key)?.get(name).copied()
    }

    fn reported(&self, key: u8, name: &str) -> Option<f64> {
        let (i, _) = self.at(key, name)?;
        self.played.get(&key)?.values.get(i).copied().filter(|value| value.is_finite())
    }

    /// Returns the model and the instrument of a key.
    pub fn played(&self, key: u8) -> Option<(&str, &str)> {
        self.played.get(&key).map(|played| (played.model.as_str(), played.instrument.as_str()))
    }

    /// Returns `true` if a value was requested and not yet answered.
    pub fn is_asked(&self, key: u8, name: &str) -> bool {
        self.wanted(key, name).is_some()
    }

    /// Returns the reason why the last value was rejected.
    pub fn refusal(&self) -> Option<&str> {
        self.refusal.as_deref()
    }

    pub const fn history(&self) -> &UndoHistory {
        &self.history
    }

    /// Moves a key's parameter to `value`, and with it those of the range.
    ///
    /// Changes of the same `gesture` are undone together.
    pub fn edit(
        &mut self,
        (key, parameter): (u8, &str),
        value: f64,
        (link, range): (LinkedKeys, &RangeInclusive<u8>),
        gesture: Option<u64>,
    ) {
        let Some(model) = self.played.get(&key).map(|played| &played.model) else { return };
        let same = self.played.iter().filter(|(_, played)| played.model == *model);
        let values: BTreeMap<u8, f64> =
            same.filter_map(|(key, _)| Some((*key, self.value(*key, parameter)?))).collect();
        let moved = link::moved(link, range, &values, key, value);
        let values =
            moved.into_iter().map(|(key, value)| (ParameterSlot::new(key, parameter), value));
        let text = match link {
            LinkedKeys::Alone => format!("{parameter} of {}", names::name(key)),
            LinkedKeys::Same | LinkedKeys::Factor | LinkedKeys::Graded => {
                format!("{parameter} of {}, {}", names::range_name(range), link.text())
            }
        };
        self.apply(&text, &values.collect(), gesture);
    }

    /// Changes to `values`, as one step.
    ///
    /// Locked and unknown parameters, and NaN, have no effect; values are limited to their range.
    pub fn apply(&mut self, text: &str, values: &SlotValues, gesture: Option<u64>) {
        let mut before = SlotValues::new();
        let mut after = SlotValues::new();
        for (slot, value) in values {
            let Some((old, new)) = self.limited(slot, *value) else { continue };
            if new.to_bits() != old.to_bits() {
                before.insert(slot.clone(), old);
                after.insert(slot.clone(), new);
            }
        }
        if !after.is_empty() {
            self.want(&after);
            self.history.enter(text, before, after, gesture);
        }
    }

    /// Returns the value before, and the limited `value`; `None` if it must not change.
    fn limited(&self, slot: &ParameterSlot, value: f64) -> Option<(f64, f64)> {
        if !value.is_finite() || self.is_locked(&slot.parameter) {
            return None;
        }
        let old = self.value(slot.key, &slot.parameter)?;
        let limits = self.parameter(slot.key, &slot.parameter)?;
        let new =
            if limits.min <= limits.max { value.clamp(limits.min, limits.max) } else { value };
        Some((old, new))
    }

    fn want(&mut self, values: &SlotValues) {
        for (slot, value) in values {
            let of_key = self.wanted.entry(slot.key).or_default();
            of_key.insert(slot.parameter.clone(), *value);
        }
        self.dirty.extend(values.keys().cloned());
    }

    /// Undoes the last step; a parameter that was locked since stays.
    pub fn undo(&mut self) {
        if let Some(values) = self.history.undo() {
            self.want(&self.unlocked(values));
        }
    }

    pub fn redo(&mut self) {
        if let Some(values) = self.history.redo() {
            self.want(&self.unlocked(values));
        }
    }

    /// Undoes or redoes until `steps` steps are done, counted from the oldest, as far as possible.
    pub fn go_to(&mut self, steps: usize) {
        while steps < self.history.steps().len() {
            self.undo();
        }
        while self.history.steps().len() < steps && self.history.next().is_some() {
            self.redo();
        }
    }

    fn unlocked(&self, mut values: SlotValues) -> SlotValues {
        values.retain(|slot, value| self.limited(slot, *value).is_some());
        values
    }

    pub fn is_locked(&self, parameter: &str) -> bool {
        self.kept.locked.contains(parameter)
    }

    pub fn toggle_lock(&mut self, parameter: &str) {
        if !self.kept.locked.remove(parameter) {
            self.kept.locked.insert(parameter.to_owned());
        }
    }

    /// Returns all present values.
    pub fn snapshot(&self) -> Snapshot {
        Snapshot::new(self.models_played(), &self.values())
    }

    fn models_played(&self) -> BTreeMap<u8, String> {
        self.played.iter().map(|(key, played)| (*key, played.model.clone())).collect()
    }

    fn values(&self) -> SlotValues {
        let of_key = |(key, played): (&u8, &KeyInstrument)| {
            let model = self.models.get(&(played.model.clone(), played.version));
            let parameters = model.map(|model| &model.parameters);
            let names = parameters.into_iter().flatten().map(|it| it.name.clone());
            let values = names.filter_map(|name| {
                let value = self.value(*key, &name)?;
                Some((ParameterSlot::new(*key, name), value))
            });
            values.collect::<Vec<_>>()
        };
        self.played.iter().flat_map(of_key).collect()
    }

    /// Restores a snapshot, as one step.
    pub fn recall(&mut self, snapshot: &Snapshot, text: &str) {
        let values = snapshot.values(&self.models_played());
        self.apply(text, &values, None);
    }

    /// Changes to values between A (0) and B (1).
    pub fn morph(&mut self, share: f64, gesture: Option<u64>) {
        let models = self.models_played();
        if let [Some(a), Some(b)] = &self.kept.compared {
            let values = snapshot::between(&a.values(&models), &b.values(&models), share);
            self.apply("from A to B", &values, gesture);
        }
    }

    /// Returns the changes to request now; `None` while an answer is pending.
    ///
    /// A drag thus requests as often as the host answers, and always the newest value.
    pub fn outgoing(&self) -> Option<Vec<Change>> {
        if self.asked.is_some() || self.dirty.is_empty() {
            return None;
        }
        let change = |slot: &ParameterSlot| {
            let value = self.wanted(slot.key, &slot.parameter)?;
            Some(Change { key: slot.key, parameter: slot.parameter.clone(), value })
        };
        Some(self.dirty.iter().filter_map(change).collect())
    }

    /// Records that `ticket` requested the changes of [`Self::outgoing`].
    pub fn sent(&mut self, ticket: Ticket) {
        let dirty = std::mem::take(&mut self.dirty);
        let value = |slot: ParameterSlot| {
            let value = self.wanted(slot.key, &slot.parameter)?;
            Some((slot, value))
        };
        let values: SlotValues = dirty.into_iter().filter_map(value).collect();
        let keys = values.keys().map(|slot| slot.key).collect::<BTreeSet<_>>();
        let revision = |key: u8| Some((key, self.played.get(&key)?.revision));
        let revisions = keys.into_iter().filter_map(revision).collect();
        self.asked = Some(PendingValues { ticket, values, revisions });
    }

    /// Takes the host's answer; an error is a sentence.
    pub fn answered(&mut self, ticket: Ticket, result: Result<(), &str>) {
        let Some(asked) = self.asked.take_if(|asked| asked.ticket == ticket) else { return };
        self.refusal = result.err().map(str::to_owned);
        let slots: Vec<ParameterSlot> = asked.values.keys().cloned().collect();
        for (slot, value) in asked.values {
            if self.dirty.contains(&slot) {
                // The value was changed meanwhile: the newer one stays.
                continue;
            }
            if let Some(of_key) = self.wanted.get_mut(&slot.key) {
                of_key.remove(&slot.parameter);
            }
            if result.is_ok() && self.is_unchanged_since(&asked.revisions, slot.key) {
                self.assume_set(&slot, value);
            }
        }
        if result.is_err() {
            self.history.forget(&slots);
        }
    }

    fn is_unchanged_since(&self, revisions: &BTreeMap<u8, u32>, key: u8) -> bool {
        self.played.get(&key).map(|played| played.revision) == revisions.get(&key).copied()
    }

    /// Assumes the host's value; its voice is still on the way.
    fn assume_set(&mut self, slot: &ParameterSlot, value: f64) {
        let Some((i, _)) = self.at(slot.key, &slot.parameter) else { return };
        let played = self.played.get_mut(&slot.key);
        if let Some(told) = played.and_then(|played| played.values.get_mut(i)) {
            *told = value;
        }
    }
}

#[cfg(test)]
mod tests;
