//! Which key sits where: on which line, on which board, in which slot.

use firmware_protocol::key::{BoardId, MOST_KEYS};
use keyboard::{KEYS, KeyIndex, KeyRange};

/// A board's place among all lines, and the keys that it carries.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct BoardPlace {
    pub line: usize,
    pub board: BoardId,
    pub first_key: KeyIndex,
    /// How many keys it carries in a row, `1 ..= 12`.
    pub n_keys: usize,
}

impl BoardPlace {
    pub const fn keys(&self) -> std::ops::Range<usize> {
        let first = self.first_key.index();
        first..first + self.n_keys
    }

    pub fn key_range(&self) -> Option<KeyRange> {
        let last = u8::try_from(self.keys().end.checked_sub(1)?).ok()?;
        KeyRange::new(self.first_key, KeyIndex::new(last)?)
    }

    /// Tells whether its keys are a board's keys, and all of the compass.
    pub const fn is_possible(&self) -> bool {
        0 < self.n_keys && self.n_keys <= MOST_KEYS && self.keys().end <= KEYS
    }
}

/// Returns eight boards of eleven keys, each on a line of its own.
pub fn standard() -> Vec<BoardPlace> {
    let places = BoardId::all().enumerate().map(|(line, board)| {
        let first_key = u8::try_from(board.keys().start).ok().and_then(KeyIndex::new)?;
        Some(BoardPlace { line, board, first_key, n_keys: board.keys().len() })
    });
    places.flatten().collect()
}
