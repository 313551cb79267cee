//! Values of all keys at one time, and values between two of them.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

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

/// Values by their slots.
pub type SlotValues = BTreeMap<ParameterSlot, f64>;

/// Values of all keys at one time.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct Snapshot {
    /// Models of the values, key by key.
    pub models: BTreeMap<u8, String>,
    /// The values: a list, because a slot is no name in JSON.
    values: Vec<(ParameterSlot, f64)>,
}

impl Snapshot {
    pub fn new(models: BTreeMap<u8, String>, values: &SlotValues) -> Self {
        Self { models, values: values.iter().map(|(slot, value)| (slot.clone(), *value)).collect() }
    }

    /// Returns the values of keys that `models` still play.
    pub fn values(&self, models: &BTreeMap<u8, String>) -> SlotValues {
        let of_same = |(slot, _): &&(ParameterSlot, f64)| {
            self.models.get(&slot.key).is_some_and(|model| models.get(&slot.key) == Some(model))
        };
        self.values.iter().filter(of_same).cloned().collect()
    }
}

/// Returns the values at `share` between `from` (0) and `to` (1) that both contain.
pub fn between(from: &SlotValues, to: &SlotValues, share: f64) -> SlotValues {
    let mix = |(slot, a): (&ParameterSlot, &f64)| {
        let b = to.get(slot)?;
        Some((slot.clone(), a + (b - a) * share))
    };
    from.iter().filter_map(mix).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(list: &[(u8, &str, f64)]) -> SlotValues {
        list.iter().map(|(key, name, value)| (ParameterSlot::new(*key, *name), *value)).collect()
    }

    #[test]
    fn half_way_is_half_way() {
        let a = values(&[(0, "k", 1.0), (1, "k", 2.0), (2, "k", 5.0)]);
        let b = values(&[(0, "k", 3.0), (1, "k", 2.0), (3, "k", 5.0)]);
        assert_eq!(between(&a, &b, 0.5), values(&[(0, "k", 2.0), (1, "k", 2.0)]));
        assert_eq!(between(&a, &b, 0.0), values(&[(0, "k", 1.0), (1, "k", 2.0)]));
    }

    #[test]
    fn a_key_that_another_model_plays_is_left_alone() {
        let models: BTreeMap<u8, String> = [(0, "a".to_owned()), (1, "a".to_owned())].into();
        let snapshot = Snapshot::new(models, &values(&[(0, "k", 1.0), (1, "k", 2.0)]));
        let now = [(0, "a".to_owned()), (1, "b".to_owned())].into();
        assert_eq!(snapshot.values(&now), values(&[(0, "k", 1.0)]));
    }
}
