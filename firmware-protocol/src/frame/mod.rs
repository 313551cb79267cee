//! The frames, one per file: field map, meaning, decode, encode, tests.
//!
//! ```text
//! byte 0      bits 7..5 kind, bit 4 flag, bits 3..0 board; 15 is all boards
//! ```
//!
//! Cyclic frames go on:
//!
//! ```text
//! byte 1      sequence
//! byte 2..3   board time [us], little-endian, wraps every 65.536 ms
//! byte 4..    values for each key
//! ```
//!
//! After the last value come zeros or nothing: CAN FD has only certain lengths. How many keys
//! there are and how they are packed was agreed before, see [`crate::acyclic::stream`] and
//! [`crate::acyclic::arm`].

pub mod broadcast;
pub mod hello;
pub mod key_forces;
pub mod key_samples;
pub mod multicast_forces;

use crate::key::BoardId;
use crate::length::padded;
use crate::sequence::SequenceNumber;

mod field {
    pub(super) const KIND_SHIFT: u8 = 5;
    pub(super) const FLAG_SHIFT: u8 = 4;
    pub(super) const BOARD: u8 = 0b0000_1111;
    pub(super) const HEADER_LEN: usize = 4;
}

/// The header of cyclic frames (bytes).
pub const HEADER_LEN: usize = field::HEADER_LEN;

/// What a board field holds that means all boards.
pub const ALL_BOARDS: u8 = field::BOARD;

/// What a frame is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(u8)]
pub enum FrameKind {
    /// Host to all boards, one of a few.
    Broadcast = 0,
    /// Host to one board: forces.
    KeyForces = 1,
    /// Host to all boards: forces of 30 keys.
    MulticastForces = 2,
    /// Board to host: positions.
    KeySamples = 3,
    /// Host to one board: a request.
    Request = 4,
    /// Board to host: its answer.
    Reply = 5,
    /// Board to host: who it is.
    Hello = 6,
}

impl FrameKind {
    /// All kinds, in the order of their numbers.
    pub const ALL: [Self; 7] = [
        Self::Broadcast,
        Self::KeyForces,
        Self::MulticastForces,
        Self::KeySamples,
        Self::Request,
        Self::Reply,
        Self::Hello,
    ];

    /// Returns the kind that a frame says it is; none if it is empty or of no known kind.
    pub fn of(frame: &[u8]) -> Option<Self> {
        Self::ALL.get(usize::from(frame.first()? >> field::KIND_SHIFT)).copied()
    }
}

/// Returns the board that a frame is from or for; none if it is for all, or empty.
pub fn board_of(frame: &[u8]) -> Option<BoardId> {
    BoardId::new(frame.first()? & field::BOARD)
}

/// What stands at the head of every cyclic frame.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Header {
    /// The board that sends, or that is meant.
    pub board: BoardId,
    /// Of samples, their number; of forces, the number of the samples that they answer.
    pub sequence: SequenceNumber,
    /// Board time of the samples (us).
    pub stamp_us: u16,
    /// From a board: it renders no forces, for whatever reason; its hello says which. From the
    /// host: render no force.
    pub flag: bool,
}

/// Why bytes are not the frame that was asked for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DecodeError {
    /// Too short, or longer than this frame can be.
    Length { got: usize },
    /// Another kind of frame, or none; the number that stands there.
    Kind(u8),
    /// No board has this number.
    NoSuchBoard(u8),
    /// Spoken by another generation of the protocol, with this major number.
    Version(u8),
    /// It does not begin as a hello does.
    Magic,
    /// Something follows the last value.
    Padding,
    /// A value that has no meaning: which byte.
    Value { at: usize },
}

/// Returns the first byte of a frame.
pub(crate) const fn head(kind: FrameKind, board: u8) -> u8 {
    (kind as u8) << field::KIND_SHIFT | board & field::BOARD
}

/// Checks that `first` starts a frame of `kind`.
pub(crate) const fn check_kind(first: u8, kind: FrameKind) -> Result<(), DecodeError> {
    let found = first >> field::KIND_SHIFT;
    if found == kind as u8 { Ok(()) } else { Err(DecodeError::Kind(found)) }
}

/// Checks the kind of a frame for or from one board, and reads which.
pub(crate) fn check_board(first: u8, kind: FrameKind) -> Result<BoardId, DecodeError> {
    check_kind(first, kind)?;
    let board = first & field::BOARD;
    BoardId::new(board).ok_or(DecodeError::NoSuchBoard(board))
}

/// Tells whether the flag is set in the first byte.
pub(crate) const fn flag(first: u8) -> bool {
    first >> field::FLAG_SHIFT & 1 != 0
}

/// Checks that nothing but zeros fill `bytes`.
pub(crate) fn check_padding(bytes: &[u8]) -> Result<(), DecodeError> {
    if bytes.iter().any(|byte| *byte != 0) { Err(DecodeError::Padding) } else { Ok(()) }
}

impl Header {
    /// Reads the header of a cyclic frame of `kind`; returns it with exactly `len` bytes of
    /// values, after a check that only padding follows.
    fn decode(bytes: &[u8], kind: FrameKind, len: usize) -> Result<(Self, &[u8]), DecodeError> {
        let length = DecodeError::Length { got: bytes.len() };
        let (head, rest) = bytes.split_first_chunk::<{ field::HEADER_LEN }>().ok_or(length)?;
        let [first, sequence, low, high] = *head;
        let board = check_board(first, kind)?;
        let (values, padding) = rest.split_at_checked(len).ok_or(length)?;
        if padded(field::HEADER_LEN + len) < bytes.len() {
            return Err(length);
        }
        check_padding(padding)?;
        let stamp_us = u16::from_le_bytes([low, high]);
        let header =
            Self { board, sequence: SequenceNumber(sequence), stamp_us, flag: flag(first) };
        Ok((header, values))
    }

    /// Writes the header of a frame of `kind`.
    fn encode(self, kind: FrameKind, bytes: &mut [u8; field::HEADER_LEN]) {
        let [low, high] = self.stamp_us.to_le_bytes();
        let flag = u8::from(self.flag) << field::FLAG_SHIFT;
        *bytes = [head(kind, self.board.number()) | flag, self.sequence.0, low, high];
    }
}
