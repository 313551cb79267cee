//! One slider for many keys: the values of the others when one is moved.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};

/// Reaction of the other keys of a range.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub enum LinkedKeys {
    /// None: each key for itself.
    #[default]
    Alone,
    Same,
    Factor,
    /// They lie on straight lines from the moved key to both ends of the range, which stay.
    Graded,
}

impl LinkedKeys {
    /// Every link, in the order of the menu.
    pub const ALL: [Self; 4] = [Self::Alone, Self::Same, Self::Factor, Self::Graded];

    pub const fn text(self) -> &'static str {
        match self {
            Self::Alone => "this key",
            Self::Same => "same value",
            Self::Factor => "same factor",
            Self::Graded => "graded",
        }
    }
}

/// Returns the values of a range of keys, not yet limited, after `key` was moved to `value`.
/// `values` are those before, of every key that can follow.
pub fn moved(
    link: LinkedKeys,
    range: &RangeInclusive<u8>,
    values: &BTreeMap<u8, f64>,
    key: u8,
    value: f64,
) -> BTreeMap<u8, f64> {
    let others = values.iter().filter(|(other, _)| range.contains(other) || **other == key);
    let new = |(other, old): (&u8, &f64)| {
        let follows = match link {
            LinkedKeys::Alone => None,
            LinkedKeys::Same => Some(value),
            LinkedKeys::Factor => Some(scaled(*old, values.get(&key).copied(), value)),
            LinkedKeys::Graded => Some(graded(range, values, key, value, *other)),
        };
        let new = if *other == key { Some(value) } else { follows };
        new.map(|new| (*other, new))
    };
    others.filter_map(new).collect()
}

/// Returns `old` times the factor from `before` to `after`; nothing grows out of zero.
fn scaled(old: f64, before: Option<f64>, after: f64) -> f64 {
    match before {
        Some(before) if f64::MIN_POSITIVE < before.abs() => old * (after / before),
        _ => after,
    }
}

/// Returns the value of `other` on the line from the moved key to its end of the range.
fn graded(
    range: &RangeInclusive<u8>,
    values: &BTreeMap<u8, f64>,
    key: u8,
    value: f64,
    other: u8,
) -> f64 {
    let mut inside = values.range(range.clone());
    let end = if other < key { inside.next() } else { inside.next_back() };
    let Some((end, fixed)) = end.filter(|(end, _)| **end != key) else { return value };
    let along = (f64::from(other) - f64::from(key)) / (f64::from(*end) - f64::from(key));
    value + (fixed - value) * along
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values() -> BTreeMap<u8, f64> {
        (10..=20).map(|key| (key, f64::from(key))).collect()
    }

    #[track_caller]
    fn check(link: LinkedKeys, key: u8, value: f64, expected: &[(u8, f64)]) {
        let moved = moved(link, &(12..=16), &values(), key, value);
        let expected: BTreeMap<u8, f64> = expected.iter().copied().collect();
        assert_eq!(moved.keys().collect::<Vec<_>>(), expected.keys().collect::<Vec<_>>());
        for (key, value) in expected {
            assert!((moved[&key] - value).abs() < 1e-12, "{key}: {} for {value}", moved[&key]);
        }
    }

    #[test]
    fn what_follows_a_key_is_what_its_link_says() {
        check(LinkedKeys::Alone, 14, 3.0, &[(14, 3.0)]);
        check(LinkedKeys::Same, 14, 3.0, &[(12, 3.0), (13, 3.0), (14, 3.0), (15, 3.0), (16, 3.0)]);
        let factor = [(12, 24.0), (13, 26.0), (14, 28.0), (15, 30.0), (16, 32.0)];
        check(LinkedKeys::Factor, 14, 28.0, &factor);
        // It bends at the key and keeps its ends.
        let graded = [(12, 12.0), (13, 16.0), (14, 20.0), (15, 18.0), (16, 16.0)];
        check(LinkedKeys::Graded, 14, 20.0, &graded);
    }

    #[test]
    fn a_graded_range_turns_about_its_other_end() {
        let expected = [(12, 0.0), (13, 4.0), (14, 8.0), (15, 12.0), (16, 16.0)];
        check(LinkedKeys::Graded, 12, 0.0, &expected);
        let expected = [(12, 12.0), (13, 14.0), (14, 16.0), (15, 18.0), (16, 20.0)];
        check(LinkedKeys::Graded, 16, 20.0, &expected);
    }

    #[test]
    fn a_key_outside_the_range_takes_the_range_with_it() {
        let moved = moved(LinkedKeys::Same, &(12..=13), &values(), 20, 5.0);
        assert_eq!(moved, [(12, 5.0), (13, 5.0), (20, 5.0)].into());
    }

    #[test]
    fn nothing_grows_out_of_zero() {
        let zero = [(12, 0.0), (13, 4.0)].into();
        let moved = moved(LinkedKeys::Factor, &(12..=13), &zero, 12, 3.0);
        assert_eq!(moved, [(12, 3.0), (13, 3.0)].into());
    }
}
