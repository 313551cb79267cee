//! A board's identity and keys, as reported by itself.

use std::fmt;

use keyboard::{KeyIndex, KeyRange};

/// Six bytes that are unique to a board; displayed as twelve hexadecimal digits.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct Uid(pub [u8; 6]);

impl fmt::Display for Uid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|byte| write!(f, "{byte:02x}"))
    }
}

/// Keys that a board claims to carry, valid or not.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ClaimedKeys {
    /// Number of the lowest key, `0 ..= 87` if it is one.
    pub first: u8,
    pub n: u8,
}

impl ClaimedKeys {
    /// Returns the range of these keys; `None` if it is empty or exceeds the keyboard.
    pub fn range(self) -> Option<KeyRange> {
        let last = self.first.checked_add(self.n.checked_sub(1)?)?;
        KeyRange::new(KeyIndex::new(self.first)?, KeyIndex::new(last)?)
    }

    pub fn contains(self, key: KeyIndex) -> bool {
        key.number().checked_sub(self.first).is_some_and(|slot| slot < self.n)
    }
}

impl fmt::Display for ClaimedKeys {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { first, n } = *self;
        match (n.checked_sub(1), self.range()) {
            (None, _) => write!(f, "no keys"),
            (Some(_), Some(range)) => write!(f, "{}..{}", range.first(), range.last()),
            (Some(others), None) => {
                let last = first.saturating_add(others);
                write!(f, "keys {first} to {last} (A0 is 0, C8 is 87)")
            }
        }
    }
}
