//! Differences from instruments over the compass: of all keys, and as patches of some.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};
use telemetry::Difference;

/// A parameter of a key.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize, Deserialize)]
pub struct ParameterSlot {
    pub key: u8,
    pub parameter: String,
}

impl ParameterSlot {
    pub fn new(key: u8, parameter: impl Into<String>) -> Self {
        Self { key, parameter: parameter.into() }
    }
}

/// Differences of the edit layer, by slot.
pub type LayerDifferences = BTreeMap<ParameterSlot, Difference>;

/// Instruments of all keys, and the differences from them.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct Snapshot {
    pub instruments: BTreeMap<u8, String>,
    /// The differences, sorted by slot: a list, because a slot is no name in JSON.
    differences: Vec<(ParameterSlot, Difference)>,
}

impl Snapshot {
    pub fn new(instruments: BTreeMap<u8, String>, differences: &LayerDifferences) -> Self {
        let list = differences.iter().map(|(slot, it)| (slot.clone(), *it));
        Self { instruments, differences: list.collect() }
    }

    pub fn differences(&self) -> LayerDifferences {
        self.differences.iter().cloned().collect()
    }

    pub fn difference(&self, slot: &ParameterSlot) -> Option<Difference> {
        let index = self.differences.binary_search_by(|(other, _)| other.cmp(slot)).ok()?;
        Some(self.differences[index].1)
    }

    pub fn has(&self, is_it: impl Fn(&ParameterSlot, Difference) -> bool) -> bool {
        self.differences.iter().any(|(slot, difference)| is_it(slot, *difference))
    }

    /// Returns the number of changes: parameters and instruments, each over adjacent keys.
    pub fn changes(&self) -> usize {
        let slots = self.differences.iter().map(|(slot, _)| (slot.parameter.as_str(), slot.key));
        let slots: BTreeSet<_> = slots.collect();
        slots.iter().filter(|(name, key)| *key == 0 || !slots.contains(&(*name, key - 1))).count()
    }

    /// Returns the patch that turns `present` into this snapshot, on keys that both know.
    pub fn patch_of(&self, present: &Self) -> EditPatch {
        let is_known = |key: &u8| present.instruments.contains_key(key);
        let mut patch = EditPatch::default();
        for (key, name) in self.instruments.iter().filter(|(key, _)| is_known(key)) {
            if present.instruments.get(key) != Some(name) {
                patch.instruments.insert(*key, name.clone());
            }
        }
        let (wanted, now) = (self.differences(), present.differences());
        for slot in wanted.keys().chain(now.keys()) {
            let after = wanted.get(slot).copied();
            let is_switched = patch.instruments.contains_key(&slot.key);
            if is_known(&slot.key) && (is_switched || after != now.get(slot).copied()) {
                patch.slots.insert(slot.clone(), after);
            }
        }
        patch
    }

    /// Returns the snapshot at `share` between this one (0) and `other` (1); keys with different
    /// instruments stay as in `present`.
    #[must_use]
    pub fn between(
        &self,
        other: &Self,
        share: f64,
        (present, base): (&Self, impl Fn(&ParameterSlot) -> Option<f64>),
    ) -> Self {
        let name = |it: &Self, key: u8| it.instruments.get(&key).cloned();
        let is_mixed = |slot: &ParameterSlot| {
            let now = name(present, slot.key);
            now == name(self, slot.key) && now == name(other, slot.key)
        };
        let (from, to, now) = (self.differences(), other.differences(), present.differences());
        let mut mixed: LayerDifferences =
            now.into_iter().filter(|(slot, _)| !is_mixed(slot)).collect();
        for slot in from.keys().chain(to.keys()).filter(|slot| is_mixed(slot)) {
            let Some(base) = base(slot) else { continue };
            let mix = mix(from.get(slot).copied(), to.get(slot).copied(), share, base);
            mixed.extend(mix.map(|difference| (slot.clone(), difference)));
        }
        Self::new(present.instruments.clone(), &mixed)
    }
}

fn mix(
    from: Option<Difference>,
    to: Option<Difference>,
    share: f64,
    base: f64,
) -> Option<Difference> {
    let mixed = |a: f64, b: f64| a + (b - a) * share;
    let none_of = |it: Difference| match it {
        Difference::Offset(_) => Difference::Offset(0.0),
        Difference::Factor(_) => Difference::Factor(1.0),
        Difference::Value(_) => Difference::Value(base),
    };
    let like = from.or(to)?;
    let (a, b) = (from.unwrap_or_else(|| none_of(like)), to.unwrap_or_else(|| none_of(like)));
    Some(if a.is_like(b) {
        a.with_amount(mixed(a.amount(), b.amount()))
    } else {
        Difference::Value(mixed(a.applied_to(base), b.applied_to(base)))
    })
}

/// Values of the base of a saved instrument.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BaseValues {
    Saved,
    Present,
}

/// New instruments and differences of some keys.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct EditPatch {
    pub instruments: BTreeMap<u8, String>,
    /// Differences after the change; `None` for a value of the instrument.
    pub slots: BTreeMap<ParameterSlot, Option<Difference>>,
}

impl EditPatch {
    pub fn is_empty(&self) -> bool {
        self.instruments.is_empty() && self.slots.is_empty()
    }

    /// Returns the lowest and the highest key that the patch changes.
    pub fn keys(&self) -> Option<RangeInclusive<u8>> {
        let keys = || self.instruments.keys().copied().chain(self.slots.keys().map(|it| it.key));
        Some(keys().min()?..=keys().max()?)
    }
}

/// Returns adjacent keys with the same name.
pub fn runs(names: &BTreeMap<u8, String>) -> Vec<(RangeInclusive<u8>, &str)> {
    let mut runs: Vec<(RangeInclusive<u8>, &str)> = Vec::new();
    for (key, name) in names {
        match runs.last_mut() {
            Some((keys, last)) if last == name && keys.end() + 1 == *key => {
                *keys = *keys.start()..=*key;
            }
            _ => runs.push((*key..=*key, name)),
        }
    }
    runs
}
