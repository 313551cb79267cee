//! The frames, one per module: field map, meaning, decode, encode. No decoder panics.
//!
//! ```text
//! byte 0      bits 7..5 kind, bit 4 flag, bits 3..0 board; 15 is all boards
//! ```
//!
//! Cyclic frames continue:
//!
//! ```text
//! byte 1      sequence
//! byte 2..3   board time [us], little-endian, wraps every 65.536 ms
//! byte 4..    values for each key
//! ```
//!
//! Zeros or nothing follow the last value: CAN FD has only certain lengths. The number of keys and
//! their packing were agreed before, see [`crate::acyclic::stream`] and [`crate::acyclic::arm`].

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

pub const HEADER_LEN: usize = field::HEADER_LEN;

pub const ALL_BOARDS: u8 = field::BOARD;

/// Kind of a frame.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(u8)]
pub enum FrameKind {
    /// Host to all boards: see [`broadcast`].
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
    /// Board to host: its identity.
    Hello = 6,
}

impl FrameKind {
    pub const ALL: [Self; 7] = [
        Self::Broadcast,
        Self::KeyForces,
        Self::MulticastForces,
        Self::KeySamples,
        Self::Request,
        Self::Reply,
        Self::Hello,
    ];

    /// Returns the kind of a frame; `None` if it is empty or of an unknown kind.
    pub fn of(frame: &[u8]) -> Option<Self> {
        Self::ALL.get(usize::from(frame.first()? >> field::KIND_SHIFT)).copied()
    }
}

/// Returns the sender or receiver of a frame; `None` if it is for all boards, or empty.
pub fn board_of(frame: &[u8]) -> Option<BoardId> {
    BoardId::new(frame.first()? & field::BOARD)
}

/// Header of every cyclic frame.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Header {
    /// Sender or receiver.
    pub board: BoardId,
    /// Number of the samples, or of the samples that the forces answer.
    pub sequence: SequenceNumber,
    /// Board time of the samples (us).
    pub stamp_us: u16,
    /// From a board: it renders no forces, see its hello. From the host: render no force.
    pub flag: bool,
}

/// Reason why bytes are not the expected frame.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DecodeError {
    /// Too short, or longer than the frame can be.
    Length { got: usize },
    /// Another kind of frame, or none, by its number.
    Kind(u8),
    /// Not the number of a board.
    NoSuchBoard(u8),
    /// Another major version of the protocol.
    Version(u8),
    /// The frame does not begin as a hello.
    Magic,
    /// Nonzero bytes follow the last value.
    Padding,
    /// Invalid value in this byte.
    Value { at: usize },
}

pub(crate) const fn head(kind: FrameKind, board: u8) -> u8 {
    (kind as u8) << field::KIND_SHIFT | board & field::BOARD
}

pub(crate) const fn check_kind(first: u8, kind: FrameKind) -> Result<(), DecodeError> {
    let found = first >> field::KIND_SHIFT;
    if found == kind as u8 { Ok(()) } else { Err(DecodeError::Kind(found)) }
}

/// Checks the kind of a frame for or from one board, and returns the board.
pub(crate) fn check_board(first: u8, kind: FrameKind) -> Result<BoardId, DecodeError> {
    check_kind(first, kind)?;
    let board = first & field::BOARD;
    BoardId::new(board).ok_or(DecodeError::NoSuchBoard(board))
}

pub(crate) const fn flag(first: u8) -> bool {
    first >> field::FLAG_SHIFT & 1 != 0
}

pub(crate) fn check_padding(bytes: &[u8]) -> Result<(), DecodeError> {
    if bytes.iter().any(|byte| *byte != 0) { Err(DecodeError::Padding) } else { Ok(()) }
}

impl Header {
    /// Decodes the header of a cyclic frame of `kind`, and `len` bytes of values before padding.
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

    fn encode(self, kind: FrameKind, bytes: &mut [u8; field::HEADER_LEN]) {
        let [low, high] = self.stamp_us.to_le_bytes();
        let flag = u8::from(self.flag) << field::FLAG_SHIFT;
        *bytes = [head(kind, self.board.number()) | flag, self.sequence.0, low, high];
    }
}
