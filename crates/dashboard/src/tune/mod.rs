//! The edit layer: what plays is an instrument on each key, and differences from it.
//!
//! A requested value is shown at once and stays until the host has answered, so that a slider never
//! jumps back. Every change is a patch of the layer and one step of the history, also from
//! snapshots and saved instruments. Nothing here sends: [`Tuner::outgoing`] returns the request.

pub mod checks;
pub mod edit;
pub mod history;
pub mod link;
mod queue;

use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};
use telemetry::request::ParameterDifferences;
use telemetry::source::Ticket;
use telemetry::{Catalogue, Difference, Model, Parameter, Request, Update, Voice};

use crate::{names, number};
use checks::KeyChecks;
use edit::{BaseValues, EditPatch, LayerDifferences, ParameterSlot, Snapshot, runs};
use history::UndoHistory;
use link::{FollowingKeys, LinkedKeys, MovedValue};
use queue::{RequestQueue, SentRequest};

/// Units in which linked keys share an offset. In other units they share a factor.
const OFFSET_UNITS: [&str; 5] = ["m", "rad", "s", "1", ""];

/// Tuning state that is saved between starts.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct SavedTuning {
    pub locked: BTreeSet<String>,
    pub compared: [Option<Snapshot>; 2],
    pub named: BTreeMap<String, Snapshot>,
}

/// Voice of a key, as the host last reported.
#[derive(Clone, Debug)]
struct KeyInstrument {
    model: String,
    version: u32,
    instrument: String,
    base: Vec<f64>,
    values: Vec<f64>,
    revision: u32,
}

#[derive(Clone, Debug)]
struct LeftLayer {
    run: String,
    layer: Snapshot,
}

/// The parameters as the window shows and changes them.
#[derive(Clone, Debug, Default)]
pub struct Tuner {
    pub kept: SavedTuning,
    pub checks: KeyChecks,
    models: BTreeMap<(String, u32), Model>,
    instruments: BTreeMap<String, Vec<f64>>,
    played: BTreeMap<u8, KeyInstrument>,
    /// Displayed differences: requested, or else as reported.
    differences: LayerDifferences,
    queue: RequestQueue,
    history: UndoHistory,
    run: String,
    left: Option<LeftLayer>,
    refusal: Option<String>,
}

impl Tuner {
    /// Takes the host's reports of instruments and voices.
    pub fn take(&mut self, update: &Update) {
        if let Update::Catalogue(catalogue) = update {
            self.take_catalogue(catalogue);
        }
        if let Update::Voice(voice) = update {
            self.take_voice(voice);
        }
    }

    fn take_catalogue(&mut self, catalogue: &Catalogue) {
        let models = catalogue.models.iter().cloned();
        self.models = models.map(|model| ((model.name.clone(), model.version), model)).collect();
        let listed = catalogue.instruments.iter().filter(|it| !it.values.is_empty());
        self.instruments = listed.map(|it| (it.name.clone(), it.values.clone())).collect();
        if self.run != catalogue.run {
            self.history = UndoHistory::default();
            self.played.clear();
            self.run.clone_from(&catalogue.run);
        }
        for key in self.played.keys().copied().collect::<Vec<_>>() {
            if let (Some(base), Some(played)) = (self.listed(key), self.played.get_mut(&key)) {
                played.base = base;
            }
            self.follow_report(key);
        }
    }

    fn listed(&self, key: u8) -> Option<Vec<f64>> {
        let played = self.played.get(&key)?;
        let count = played.values.len();
        let values = self.instruments.get(&played.instrument)?;
        let start = usize::from(key) * count;
        (values.len() == telemetry::KEYS * count).then(|| values[start..start + count].to_vec())
    }

    fn take_voice(&mut self, voice: &Voice) {
        let Some(key) = number::key(voice.key) else { return };
        let before = self.played.get(&key);
        let is_same =
            before.is_some_and(|it| it.model == voice.model && it.instrument == voice.instrument);
        let base = before.filter(|_| is_same).map(|it| it.base.clone());
        if !is_same && !self.queue.expects(key, &voice.instrument) {
            self.queue.forget_key(key);
            self.checks.forget(key);
        }
        self.queue.arrived(key, &voice.instrument);
        let values = voice.values.clone();
        let played = KeyInstrument {
            model: voice.model.clone(),
            version: voice.version,
            instrument: voice.instrument.clone(),
            base: base.filter(|it| it.len() == values.len()).unwrap_or_else(|| values.clone()),
            values,
            revision: voice.revision,
        };
        self.played.insert(key, played);
        if let (Some(base), Some(played)) = (self.listed(key), self.played.get_mut(&key)) {
            played.base = base;
        }
        self.follow_report(key);
    }

    fn follow_report(&mut self, key: u8) {
        let Some(played) = self.played.get(&key) else { return };
        if self.queue.awaits(key) {
            return;
        }
        let Some(model) = self.models.get(&(played.model.clone(), played.version)) else { return };
        let numbers = model.parameters.iter().zip(&played.base).zip(&played.values);
        for ((parameter, base), value) in numbers {
            let slot = ParameterSlot::new(key, parameter.name.clone());
            if self.queue.is_pending(&slot) {
                continue;
            }
            let left = || self.left.as_ref().and_then(|left| left.layer.difference(&slot));
            let known = self.differences.get(&slot).copied().or_else(left);
            let known = known.unwrap_or(Difference::Value(*value));
            if value.to_bits() == base.to_bits() || !value.is_finite() {
                self.differences.remove(&slot);
            } else {
                self.differences.insert(slot, known.exactly(*base, *value));
            }
        }
        let is_known = |name: &str| model.parameters.iter().any(|it| it.name == name);
        self.differences.retain(|slot, _| slot.key != key || is_known(&slot.parameter));
    }

    /// Forgets the host's state when a connection begins; keeps the differences to offer them.
    pub fn forget(&mut self) {
        if !self.differences.is_empty() {
            self.left = Some(LeftLayer { run: self.run.clone(), layer: self.snapshot() });
        }
        self.queue = RequestQueue::default();
        self.checks.clear();
        self.differences.clear();
    }

    /// Queues again what a lost connection has left without an answer.
    pub fn connection_lost(&mut self) {
        self.queue.lose();
        self.checks.clear();
    }

    /// Returns the layer of an earlier run, if the present one lacks some of it.
    pub fn offer(&self) -> Option<&Snapshot> {
        let LeftLayer { run, layer } = self.left.as_ref()?;
        if *run == self.run || self.played.is_empty() {
            return None;
        }
        let lacks = |slot: &ParameterSlot, it| {
            self.at(slot.key, &slot.parameter).is_some() && self.differences.get(slot) != Some(&it)
        };
        layer.has(lacks).then_some(layer)
    }

    /// Puts the offered layer back, as one step.
    pub fn put_back(&mut self) {
        if let Some(left) = self.left.take() {
            self.recall(&left.layer, "put back");
        }
    }

    pub fn decline(&mut self) {
        self.left = None;
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

    /// Returns the value to show: that of the instrument with its difference.
    pub fn value(&self, key: u8, name: &str) -> Option<f64> {
        self.value_with(&ParameterSlot::new(key, name), |slot| self.differences.get(slot).copied())
    }

    /// Returns the value of the instrument itself.
    pub fn base(&self, key: u8, name: &str) -> Option<f64> {
        let (i, _) = self.at(key, name)?;
        self.played.get(&key)?.base.get(i).copied().filter(|value| value.is_finite())
    }

    fn value_with(
        &self,
        slot: &ParameterSlot,
        difference: impl Fn(&ParameterSlot) -> Option<Difference>,
    ) -> Option<f64> {
        let base = self.base(slot.key, &slot.parameter)?;
        Some(difference(slot).map_or(base, |it| it.applied_to(base)))
    }

    pub fn played(&self, key: u8) -> Option<(&str, &str)> {
        self.played.get(&key).map(|played| (played.model.as_str(), played.instrument.as_str()))
    }

    /// Returns `true` if a value was requested and not yet answered.
    pub fn is_asked(&self, key: u8, name: &str) -> bool {
        self.queue.is_pending(&ParameterSlot::new(key, name))
    }

    pub fn refusal(&self) -> Option<&str> {
        self.refusal.as_deref()
    }

    pub const fn history(&self) -> &UndoHistory {
        &self.history
    }

    /// Moves a key's parameter to `value`, and with it those that follow.
    ///
    /// Changes of the same `gesture` are undone together, and each begins where the gesture began.
    pub fn edit(
        &mut self,
        (key, parameter): (u8, &str),
        value: f64,
        following: &FollowingKeys,
        gesture: Option<u64>,
    ) {
        let origin = |slot: &ParameterSlot| {
            let before = self.history.origin(slot, gesture);
            before.unwrap_or_else(|| self.differences.get(slot).copied())
        };
        let moved = ParameterSlot::new(key, parameter);
        let Some(before) = self.value_with(&moved, origin) else { return };
        let Some((_, after)) = self.limited(&moved, value) else { return };
        let unit = self.parameter(key, parameter).map_or("", |it| it.unit.as_str());
        let is_scaled = !OFFSET_UNITS.contains(&unit);
        let change = MovedValue { before, after, is_scaled };
        let model = &self.played[&key].model;
        let mut patch = EditPatch::default();
        for other in self.played.iter().filter(|(_, played)| played.model == *model) {
            let weight = following.weight(key, *other.0);
            if weight <= 0.0 {
                continue;
            }
            let slot = ParameterSlot::new(*other.0, parameter);
            let Some(base) = self.base(slot.key, parameter) else { continue };
            let own = if following.link == LinkedKeys::Same {
                Difference::Value(after)
            } else {
                change.share(weight)
            };
            let layered = origin(&slot).map_or(own, |it| it.then(own, base));
            let value = if slot == moved { after } else { layered.applied_to(base) };
            let Some((_, value)) = self.limited(&slot, value) else { continue };
            let is_base = value.to_bits() == base.to_bits();
            patch.slots.insert(slot, (!is_base).then(|| layered.exactly(base, value)));
        }
        let title = self.parameter(key, parameter).map_or(parameter, names::title);
        let FollowingKeys { link, range, .. } = following;
        let text = if *link == LinkedKeys::Alone {
            format!("{title} of {}", names::name(key))
        } else {
            format!("{title} of {}, {}", names::range_name(range), link.text())
        };
        self.enter(&text, patch, gesture);
    }

    /// Lets another instrument play keys, as one step; a saved one takes these values of its base.
    pub fn use_instrument(&mut self, name: &str, keys: &RangeInclusive<u8>, values: BaseValues) {
        let mut patch = EditPatch::default();
        // Also on keys whose voices are not known: the host answers for the range.
        patch.instruments.extend(keys.clone().map(|key| (key, name.to_owned())));
        let of_keys = self.differences.keys().filter(|slot| keys.contains(&slot.key));
        patch.slots = of_keys.map(|slot| (slot.clone(), None)).collect();
        let text = format!("{name} on {}", names::range_name(keys));
        self.enter(&text, patch, None);
        if values == BaseValues::Present {
            self.queue.follow_base();
        }
    }

    /// Applies a patch as a step, without locked and unknown parameters and what is so already.
    fn enter(&mut self, text: &str, mut patch: EditPatch, gesture: Option<u64>) {
        let now = self.snapshot().instruments;
        let is_switched = |key: u8| patch.instruments.contains_key(&key);
        let slots = std::mem::take(&mut patch.slots).into_iter();
        patch.slots = slots
            .filter(|(slot, after)| {
                let is_new = self.differences.get(slot).copied() != *after;
                is_switched(slot.key) || is_new && !self.is_locked(&slot.parameter)
            })
            .collect();
        let mut before = EditPatch::default();
        let known = patch.instruments.keys().filter_map(|key| Some((*key, now.get(key)?.clone())));
        before.instruments.extend(known);
        let of_switched = self.differences.keys().filter(|slot| is_switched(slot.key));
        let slots = of_switched.chain(patch.slots.keys());
        before.slots =
            slots.map(|slot| (slot.clone(), self.differences.get(slot).copied())).collect();
        if !patch.is_empty() {
            self.history.enter(text, before, patch.clone(), gesture);
            self.apply(&patch);
        }
    }

    fn apply(&mut self, patch: &EditPatch) {
        if let Some(keys) = patch.keys() {
            self.checks.note((*keys.start(), *keys.end()));
        }
        for (keys, name) in runs(&patch.instruments) {
            self.differences.retain(|slot, _| !keys.contains(&slot.key));
            self.queue.switch(name, keys);
        }
        for (slot, difference) in &patch.slots {
            match difference {
                Some(difference) => self.differences.insert(slot.clone(), *difference),
                None => self.differences.remove(slot),
            };
            self.queue.mark(slot.clone());
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

    /// Undoes the last step, except parameters locked since; returns the keys that it changes.
    pub fn undo(&mut self) -> Option<RangeInclusive<u8>> {
        let patch = self.history.undo()?;
        self.restore(patch)
    }

    /// Redoes the latest undone step; returns the keys that it changes.
    pub fn redo(&mut self) -> Option<RangeInclusive<u8>> {
        let patch = self.history.redo()?;
        self.restore(patch)
    }

    fn restore(&mut self, mut patch: EditPatch) -> Option<RangeInclusive<u8>> {
        patch.slots.retain(|slot, _| !self.kept.locked.contains(&slot.parameter));
        self.apply(&patch);
        patch.keys()
    }

    /// Undoes or redoes until `steps` steps are done, counted from the oldest, as far as possible.
    pub fn go_to(&mut self, steps: usize) -> Option<RangeInclusive<u8>> {
        let mut keys = None;
        while steps < self.history.steps().len() {
            keys = self.undo();
        }
        while self.history.steps().len() < steps && self.history.next().is_some() {
            keys = self.redo();
        }
        keys
    }

    pub fn is_locked(&self, parameter: &str) -> bool {
        self.kept.locked.contains(parameter)
    }

    pub fn toggle_lock(&mut self, parameter: &str) {
        if !self.kept.locked.remove(parameter) {
            self.kept.locked.insert(parameter.to_owned());
        }
    }

    /// Returns the present layer: instruments and differences, as far as requested.
    pub fn snapshot(&self) -> Snapshot {
        let name = |(key, played): (&u8, &KeyInstrument)| {
            (*key, self.queue.expected(*key).unwrap_or(&played.instrument).to_owned())
        };
        Snapshot::new(self.played.iter().map(name).collect(), &self.differences)
    }

    /// Restores a snapshot, as one step.
    pub fn recall(&mut self, snapshot: &Snapshot, text: &str) {
        let patch = snapshot.patch_of(&self.snapshot());
        self.enter(text, patch, None);
    }

    /// Changes to differences between A (0) and B (1).
    pub fn morph(&mut self, share: f64, gesture: Option<u64>) {
        let now = self.snapshot();
        if let [Some(a), Some(b)] = &self.kept.compared {
            let base = |slot: &ParameterSlot| self.base(slot.key, &slot.parameter);
            let patch = a.between(b, share, (&now, base)).patch_of(&now);
            self.enter("from A to B", patch, gesture);
        }
    }

    /// Returns the request that saves the instrument of `key` with the differences of all its keys.
    /// `saved` are the names of instruments; one of them is replaced.
    pub fn saving(&self, key: u8, name: &str, saved: &[String]) -> Option<Request> {
        let base = self.played(key)?.1.to_owned();
        let mut differences: Vec<ParameterDifferences> = Vec::new();
        let is_of_base = |key: u8| self.played(key).is_some_and(|(_, it)| it == base);
        for (slot, difference) in self.differences.iter().filter(|(it, _)| is_of_base(it.key)) {
            let known = differences.iter_mut().find(|it| it.parameter == slot.parameter);
            match known {
                Some(known) => known.keys.push((slot.key, *difference)),
                None => differences.push(ParameterDifferences {
                    parameter: slot.parameter.clone(),
                    keys: vec![(slot.key, *difference)],
                }),
            }
        }
        let overwrite = saved.iter().any(|saved| saved == name);
        let name = name.to_owned();
        Some(Request::SaveInstrument { name, base, differences, overwrite })
    }

    /// Returns the next request; `None` while an answer is pending.
    ///
    /// A drag thus requests as often as the host answers, and always the newest value. Another
    /// instrument comes first, and values of its keys wait until it plays.
    pub fn outgoing(&self) -> Option<Request> {
        let request = self.queue.outgoing(|slot| self.value(slot.key, &slot.parameter));
        let figures = || self.checks.outgoing().map(|key| Request::Figures { key });
        request.or_else(|| figures().filter(|_| self.queue.is_empty()))
    }

    pub fn sent(&mut self, ticket: Ticket) {
        if self.queue.is_empty() {
            if let Some(key) = self.checks.outgoing() {
                self.checks.sent(ticket, key);
            }
            return;
        }
        let mut queue = std::mem::take(&mut self.queue);
        queue.sent(ticket, |slot| {
            let value = self.value(slot.key, &slot.parameter)?;
            Some((value, self.played.get(&slot.key)?.revision))
        });
        self.queue = queue;
    }

    /// Takes the host's answer; an error is a sentence.
    pub fn answered(&mut self, ticket: Ticket, result: Result<(), &str>) {
        let Some(asked) = self.queue.answered(ticket) else { return };
        self.refusal = result.err().map(str::to_owned);
        match asked {
            SentRequest::Switch(keys) if result.is_err() => {
                self.queue.forget_keys(&keys);
                self.history.forget(&[], &keys.clone().collect::<Vec<_>>());
                for key in keys {
                    self.follow_report(key);
                }
            }
            SentRequest::Switch(_) => {}
            SentRequest::Values(values) => {
                for (slot, (value, revision)) in &values {
                    let is_unchanged =
                        self.played.get(&slot.key).is_some_and(|it| it.revision == *revision);
                    if result.is_ok() && is_unchanged {
                        self.assume_set(slot, *value);
                    }
                }
                let slots: Vec<_> = values.into_keys().collect();
                if result.is_err() {
                    let is_old = |slot: &&ParameterSlot| !self.queue.is_pending(slot);
                    let refused: Vec<_> = slots.iter().filter(is_old).cloned().collect();
                    self.differences.retain(|slot, _| !refused.contains(slot));
                    self.history.forget(&slots, &[]);
                }
                let keys: BTreeSet<u8> = slots.iter().map(|slot| slot.key).collect();
                for key in keys {
                    self.follow_report(key);
                }
            }
        }
    }

    fn assume_set(&mut self, slot: &ParameterSlot, value: f64) {
        let Some((i, _)) = self.at(slot.key, &slot.parameter) else { return };
        let played = self.played.get_mut(&slot.key);
        if let Some(reported) = played.and_then(|played| played.values.get_mut(i)) {
            *reported = value;
        }
    }
}

#[cfg(test)]
mod tests;
