//! One slider for many keys: the changes of the others when one is moved.

use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};
use telemetry::Difference;

/// Reaction of the other keys of a range.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub enum LinkedKeys {
    #[default]
    Alone,
    Same,
    /// The same offset or factor, which fades beside the range.
    Change,
    /// An offset or factor that fades from the moved key to both ends of the range, which stay.
    Graded,
}

impl LinkedKeys {
    pub const ALL: [Self; 4] = [Self::Alone, Self::Same, Self::Change, Self::Graded];

    pub const fn text(self) -> &'static str {
        match self {
            Self::Alone => "this key",
            Self::Same => "same value",
            Self::Change => "same change",
            Self::Graded => "fading change",
        }
    }
}

/// Keys that follow a moved one.
#[derive(Clone, PartialEq, Debug)]
pub struct FollowingKeys {
    pub link: LinkedKeys,
    pub range: RangeInclusive<u8>,
    /// Number of keys beside the range over which a change fades.
    pub fade: u8,
}

impl FollowingKeys {
    /// Returns the share of the change of `moved` that `key` gets, 0 to 1.
    pub fn weight(&self, moved: u8, key: u8) -> f64 {
        let (low, high) = (*self.range.start(), *self.range.end());
        match self.link {
            _ if key == moved => 1.0,
            LinkedKeys::Alone => 0.0,
            LinkedKeys::Same => f64::from(u8::from(self.range.contains(&key))),
            LinkedKeys::Change => {
                let beside = low.saturating_sub(key).max(key.saturating_sub(high));
                1.0 - f64::from(beside.min(self.fade + 1)) / (f64::from(self.fade) + 1.0)
            }
            LinkedKeys::Graded => {
                let end = if key < moved { low } else { high };
                let span = f64::from(moved) - f64::from(end);
                if self.range.contains(&key) && span != 0.0 {
                    (f64::from(key) - f64::from(end)) / span
                } else {
                    0.0
                }
            }
        }
    }
}

/// Change of a parameter, which others follow in part.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct MovedValue {
    pub before: f64,
    pub after: f64,
    /// `true` if others follow by the same factor, `false` by the same offset.
    pub is_scaled: bool,
}

impl MovedValue {
    /// Returns the difference of a key that follows with `weight`.
    pub fn share(&self, weight: f64) -> Difference {
        let Self { before, after, is_scaled } = *self;
        // Nothing grows out of zero.
        if is_scaled && f64::MIN_POSITIVE < before.abs() {
            Difference::Factor(1.0 + (after / before - 1.0) * weight)
        } else {
            Difference::Offset((after - before) * weight)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(link: LinkedKeys, fade: u8, moved: u8, expected: &[(u8, f64)]) {
        let following = FollowingKeys { link, range: 12..=16, fade };
        for key in 0..88 {
            let weight = expected.iter().find(|(it, _)| *it == key).map_or(0.0, |(_, it)| *it);
            let found = following.weight(moved, key);
            assert!((found - weight).abs() < 1e-12, "{key}: {found} for {weight}");
        }
    }

    #[test]
    fn a_key_follows_as_its_link_states() {
        check(LinkedKeys::Alone, 0, 14, &[(14, 1.0)]);
        let all = [(12, 1.0), (13, 1.0), (14, 1.0), (15, 1.0), (16, 1.0)];
        check(LinkedKeys::Same, 3, 14, &all);
        check(LinkedKeys::Change, 0, 14, &all);
        let faded = [(10, 1.0 / 3.0), (11, 2.0 / 3.0), (17, 2.0 / 3.0), (18, 1.0 / 3.0)];
        check(LinkedKeys::Change, 2, 14, &[&all[..], &faded[..]].concat());
        check(LinkedKeys::Graded, 2, 14, &[(13, 0.5), (14, 1.0), (15, 0.5)]);
        // The moved key is the end of the range, or outside.
        check(LinkedKeys::Graded, 0, 12, &[(12, 1.0), (13, 0.75), (14, 0.5), (15, 0.25)]);
        check(LinkedKeys::Same, 0, 20, &[&all[..], &[(20, 1.0)]].concat());
    }

    #[test]
    fn nothing_grows_out_of_zero() {
        let moved = MovedValue { before: 0.0, after: 3.0, is_scaled: true };
        assert_eq!(moved.share(0.5), Difference::Offset(1.5));
    }
}
