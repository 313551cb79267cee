/// Keys of a full compass, A0 to C8.
pub const KEYS: usize = 88;

/// MIDI number of key 0, A0.
const LOWEST_NOTE: u8 = 21;

/// A key of the compass, `0 ..= 87`: 0 is A0, 87 is C8.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct KeyIndex(u8);

impl KeyIndex {
    pub const LOWEST: Self = Self(0);
    pub const HIGHEST: Self = Self(87);

    /// Returns the key with this number; `None` above 87.
    pub const fn new(number: u8) -> Option<Self> {
        if (number as usize) < KEYS { Some(Self(number)) } else { None }
    }

    /// Returns the key of a MIDI note number, `21 ..= 108`.
    pub const fn from_midi(note: u8) -> Option<Self> {
        match note.checked_sub(LOWEST_NOTE) {
            Some(number) => Self::new(number),
            None => None,
        }
    }

    /// Returns all keys from bass to treble.
    pub fn all() -> impl DoubleEndedIterator<Item = Self> + ExactSizeIterator + Clone {
        (0..=Self::HIGHEST.0).map(Self)
    }

    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// Returns the number, `0 ..= 87`.
    pub const fn number(self) -> u8 {
        self.0
    }

    /// Returns the MIDI note number, `21 ..= 108`.
    pub const fn midi(self) -> u8 {
        self.0 + LOWEST_NOTE
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_compass_is_a0_to_c8() {
        assert_eq!(KeyIndex::new(0).map(KeyIndex::midi), Some(21));
        assert_eq!(KeyIndex::new(87).map(KeyIndex::midi), Some(108));
        assert_eq!(KeyIndex::new(88), None);
        assert_eq!(KeyIndex::from_midi(20), None);
        assert_eq!(KeyIndex::from_midi(109), None);
        assert_eq!(KeyIndex::from_midi(60).map(KeyIndex::number), Some(39));
        assert_eq!(KeyIndex::all().len(), KEYS);
        assert_eq!(KeyIndex::all().last(), Some(KeyIndex::HIGHEST));
    }
}
