//! Frames on classic CAN, whose frames hold eight bytes: in pieces of seven.
//!
//! ```text
//! byte 0      bits 7..5 number of the frame, bit 4 last piece, bits 3..0 number of the piece
//! byte 1..8   up to seven bytes of the frame
//! ```
//!
//! A lost piece loses its frame: the next one is already on its way.

use crate::MAX_FRAME;

/// Payload of a piece (bytes).
pub const PIECE: usize = 7;
pub const MOST_PIECES: usize = MAX_FRAME.div_ceil(PIECE);

pub const LAST: u8 = 0b0001_0000;
pub const INDEX: u8 = 0b0000_1111;
pub const ROLL_SHIFT: u8 = 5;

/// Returns the number of pieces of a frame of `len` bytes; an empty one takes one piece.
pub const fn count(len: usize) -> usize {
    if len == 0 { 1 } else { len.div_ceil(PIECE) }
}

/// Cuts `frame` into pieces, each with its length, under the rolling number `roll`.
///
/// Bytes beyond the longest frame are dropped.
pub fn cut(frame: &[u8], roll: u8) -> impl Iterator<Item = ([u8; 8], usize)> + '_ {
    let frame = &frame[..frame.len().min(MAX_FRAME)];
    let n = count(frame.len());
    (0..n).zip(0_u8..).map(move |(index, number)| {
        let part = frame.get(index * PIECE..).unwrap_or_default();
        let part = &part[..part.len().min(PIECE)];
        let mut piece = [0; 8];
        let last = if index + 1 == n { LAST } else { 0 };
        piece[0] = roll << ROLL_SHIFT | last | number & INDEX;
        piece[1..=part.len()].copy_from_slice(part);
        (piece, part.len() + 1)
    })
}

/// Joins the pieces of one sender, in a fixed buffer.
#[derive(Clone, Debug)]
pub struct Reassembler {
    buffer: [u8; MAX_FRAME],
    len: usize,
    /// Next piece, and the number of its frame.
    expected: Option<(u8, u8)>,
}

/// A piece that does not follow the one before: its frame is lost.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct PieceLost;

impl Default for Reassembler {
    fn default() -> Self {
        Self { buffer: [0; MAX_FRAME], len: 0, expected: None }
    }
}

impl Reassembler {
    /// Accepts the next piece; returns the frame after its last piece.
    ///
    /// # Errors
    /// A piece is missing; its frame is lost, and the next one starts afresh.
    pub fn push(&mut self, piece: &[u8]) -> Result<Option<&[u8]>, PieceLost> {
        let [head, part @ ..] = piece else { return self.lose() };
        let (roll, index) = (head >> ROLL_SHIFT, head & INDEX);
        let begins = index == 0;
        if !begins && self.expected != Some((roll, index)) {
            return self.lose();
        }
        let interrupted = begins && self.expected.is_some();
        if begins {
            self.len = 0;
        }
        let Some(place) = self.buffer.get_mut(self.len..self.len + part.len()) else {
            return self.lose();
        };
        place.copy_from_slice(part);
        self.len += part.len();
        if head & LAST != 0 {
            self.expected = None;
            return Ok(Some(&self.buffer[..self.len]));
        }
        self.expected = Some((roll, (index + 1) & INDEX));
        if interrupted { Err(PieceLost) } else { Ok(None) }
    }

    const fn lose<T>(&mut self) -> Result<T, PieceLost> {
        self.expected = None;
        Err(PieceLost)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_that_run_on_for_ever_are_refused() {
        let mut assembler = Reassembler::default();
        assert_eq!(assembler.push(&[0; 8]), Ok(None));
        for index in 1..9 {
            assert_eq!(assembler.push(&[index, 1, 2, 3, 4, 5, 6, 7]), Ok(None));
        }
        assert_eq!(assembler.push(&[9, 1, 2, 3, 4, 5, 6, 7]), Err(PieceLost));
        assert_eq!(assembler.push(&[]), Err(PieceLost));
    }
}
