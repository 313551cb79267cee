//! Keys, boards, and which key sits where.
//!
//! Board `b` carries the keys `11 b ..= 11 b + 10`, in the order of its slots.

/// Keys of a full compass.
pub const KEYS: usize = BOARDS * KEYS_PER_BOARD;
/// Keys that one board carries at most.
pub const KEYS_PER_BOARD: usize = SLOTS as usize;
/// Boards of a full compass.
pub const BOARDS: usize = LAST_BOARD as usize + 1;

const SLOTS: u8 = 11;
const LAST_BOARD: u8 = 7;

/// A key of the compass, `0 ..= 87`: 0 is A0, 87 is C8.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct KeyIndex(u8);

impl KeyIndex {
    /// The key with this number; none above 87.
    pub const fn new(number: u8) -> Option<Self> {
        if (number as usize) < KEYS { Some(Self(number)) } else { None }
    }

    /// The number, for arrays over the compass.
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// The board that carries this key.
    pub const fn board(self) -> BoardId {
        BoardId(self.0 / SLOTS)
    }

    /// The key's place on its board, `0 ..= 10`.
    pub const fn slot(self) -> usize {
        self.index() % KEYS_PER_BOARD
    }
}

/// A board, `0 ..= 7`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct BoardId(u8);

impl BoardId {
    /// The board with this number; none above 7.
    pub const fn new(number: u8) -> Option<Self> {
        if (number as usize) < BOARDS { Some(Self(number)) } else { None }
    }

    /// All boards, from the bass to the treble.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..=LAST_BOARD).map(Self)
    }

    /// The number as it stands on the wire.
    pub const fn number(self) -> u8 {
        self.0
    }

    /// The number, for arrays over boards.
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// The places of this board's keys in an array over the compass.
    pub const fn keys(self) -> core::ops::Range<usize> {
        let first = self.index() * KEYS_PER_BOARD;
        first..first + KEYS_PER_BOARD
    }
}

/// One value for each key of a board, in the order of its slots.
#[derive(Clone, Copy, Debug)]
pub struct PerKey<T> {
    values: [T; KEYS_PER_BOARD],
    n: usize,
}

impl<T: Copy + Default> PerKey<T> {
    /// Keeps the first 11 of `values`.
    pub fn collect(values: impl IntoIterator<Item = T>) -> Self {
        let mut kept = Self { values: [T::default(); KEYS_PER_BOARD], n: 0 };
        for (place, value) in kept.values.iter_mut().zip(values) {
            *place = value;
            kept.n += 1;
        }
        kept
    }

    /// The values that are there.
    pub fn as_slice(&self) -> &[T] {
        &self.values[..self.n]
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
    fn the_compass_ends_at_key_87_and_board_7() {
        assert!(KeyIndex::new(87).is_some());
        assert_eq!(KeyIndex::new(88), None);
        assert!(BoardId::new(7).is_some());
        assert_eq!(BoardId::new(8), None);
    }

    #[test]
    fn every_key_has_one_place() {
        let mut expected = 0;
        for board in BoardId::all() {
            for (slot, number) in board.keys().enumerate() {
                let key = KeyIndex::new(u8::try_from(number).unwrap()).unwrap();
                assert_eq!((key.index(), key.board(), key.slot()), (expected, board, slot));
                expected += 1;
            }
        }
        assert_eq!(expected, KEYS);
    }

    #[test]
    fn a_board_keeps_no_more_than_eleven_values() {
        assert_eq!(PerKey::collect(0..20).as_slice(), [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
    }
}
