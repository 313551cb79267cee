//! Position of each key: its line, board and slot.

use firmware_protocol::key::{BoardId, MOST_KEYS};
use keyboard::{KEYS, KeyIndex, KeyRange};

/// Position of a board among all lines, and its keys.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct BoardPlace {
    pub line: usize,
    pub board: BoardId,
    pub first_key: KeyIndex,
    /// Number of its consecutive keys, `1 ..= 12`.
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

    /// Returns `true` if the keys fit on a board and on the keyboard.
    pub const fn is_possible(&self) -> bool {
        0 < self.n_keys && self.n_keys <= MOST_KEYS && self.keys().end <= KEYS
    }
}

/// Returns eight boards of eleven keys, each on its own line.
pub fn standard() -> Vec<BoardPlace> {
    let places = BoardId::all().enumerate().map(|(line, board)| {
        let first_key = u8::try_from(board.keys().start).ok().and_then(KeyIndex::new)?;
        Some(BoardPlace { line, board, first_key, n_keys: board.keys().len() })
    });
    places.flatten().collect()
}
