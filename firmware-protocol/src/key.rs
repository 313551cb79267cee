//! Keys, boards, and the standard compass.
//!
//! A board reports its keys, at most twelve in a row. In the standard compass, also that of the
//! simulated keybed, board `b` carries the keys `11 b ..= 11 b + 10`.

pub use keyboard::{KEYS, KeyIndex};

/// Maximum number of keys of a board: an octave.
pub const MOST_KEYS: usize = 12;
/// Number of boards of the standard compass.
pub const BOARDS: usize = 8;
pub const KEYS_PER_BOARD: usize = 11;

const STANDARD_SLOTS: u8 = 11;
const STANDARD_BOARDS: u8 = 8;

/// A board's number on its link, `0 ..= 14`; 15 on the wire means all boards.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct BoardId(u8);

impl BoardId {
    pub const MAX: Self = Self(14);

    /// Returns the board with this number; `None` above 14.
    pub const fn new(number: u8) -> Option<Self> {
        if number <= Self::MAX.0 { Some(Self(number)) } else { None }
    }

    /// Returns the board of the standard compass that carries `key`.
    pub const fn of(key: KeyIndex) -> Self {
        Self(key.number() / STANDARD_SLOTS)
    }

    /// Returns the slot of `key` on its board of the standard compass, `0 ..= 10`.
    pub const fn slot_of(key: KeyIndex) -> usize {
        key.index() % KEYS_PER_BOARD
    }

    /// Returns the boards of the standard compass, from the bass to the treble.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..STANDARD_BOARDS).map(Self)
    }

    pub const fn number(self) -> u8 {
        self.0
    }

    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// Returns the indices of this board's keys in the standard compass.
    pub const fn keys(self) -> core::ops::Range<usize> {
        let first = self.index() * KEYS_PER_BOARD;
        first..first + KEYS_PER_BOARD
    }
}

/// One value for each key of a board, in the order of slots.
#[derive(Clone, Copy, Debug)]
pub struct PerKey<T> {
    values: [T; MOST_KEYS],
    n: usize,
}

impl<T: Copy + Default> PerKey<T> {
    /// Collects the first 12 of `values`.
    pub fn collect(values: impl IntoIterator<Item = T>) -> Self {
        let mut kept = Self::default();
        for (place, value) in kept.values.iter_mut().zip(values) {
            *place = value;
            kept.n += 1;
        }
        kept
    }

    pub fn as_slice(&self) -> &[T] {
        &self.values[..self.n]
    }

    pub const fn is_empty(&self) -> bool {
        self.n == 0
    }

    pub fn as_mut_slice(&mut self) -> &mut [T] {
        &mut self.values[..self.n]
    }
}

impl<T: Copy + Default> Default for PerKey<T> {
    fn default() -> Self {
        Self { values: [T::default(); MOST_KEYS], n: 0 }
    }
}

impl<T: Copy + Default + PartialEq> PartialEq for PerKey<T> {
    fn eq(&self, other: &Self) -> bool {
        self.as_slice() == other.as_slice()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_of_the_standard_compass_has_one_place() {
        let mut expected = 0;
        for board in BoardId::all() {
            for (slot, number) in board.keys().enumerate() {
                let key = KeyIndex::new(u8::try_from(number).unwrap()).unwrap();
                let (its_board, its_slot) = (BoardId::of(key), BoardId::slot_of(key));
                assert_eq!((key.index(), its_board, its_slot), (expected, board, slot));
                expected += 1;
            }
        }
        assert_eq!(expected, KEYS);
    }
}
