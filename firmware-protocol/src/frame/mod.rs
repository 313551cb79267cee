//! The frames, one per file: field map, meaning, decode, encode, tests.
//!
//! ```text
//! byte 0      bits 7..4 protocol major, bits 3..0 class (1 forces, 2 samples)
//! byte 1      bit 7 fault, bits 6..4 zero, bits 3..0 board
//! byte 2      sequence
//! byte 3..5   board time [us], little-endian, wraps every 65.536 ms
//! byte 5      keys in this frame, 1 ..= 11
//! byte 6..    one value for each key
//! ```
//!
//! After the last value come zeros or nothing: CAN FD has only certain lengths.

pub mod key_forces;
pub mod key_samples;

use crate::key::{BoardId, KEYS_PER_BOARD};
use crate::sequence::Sequence;
use crate::version::{PROTOCOL_VERSION, Version};

mod field {
    pub(super) const FAULT: u8 = 0b1000_0000;
    pub(super) const RESERVED: u8 = 0b0111_0000;
    pub(super) const LEN: usize = 6;
}

/// What a frame is; the smaller number wins the bus.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Class {
    /// Host to board: forces.
    KeyForces = 1,
    /// Board to host: positions.
    KeySamples = 2,
}

/// What stands at the head of every frame.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Header {
    /// The board that sends, or that is meant.
    pub board: BoardId,
    /// The number of this frame among those of its class and board.
    pub sequence: Sequence,
    /// Board time [us]: when the samples were taken, or which samples are answered.
    pub stamp_us: u16,
    /// From a board: a fault is latched. From the host: render no force.
    pub fault: bool,
}

/// Why bytes are not the frame that was asked for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DecodeError {
    /// Too short for what it announces, or longer than this frame can be.
    Length {
        /// Bytes that came.
        got: usize,
    },
    /// Spoken by another generation of the protocol, with this major number.
    Version(u8),
    /// Another class of frame, or none.
    Class(u8),
    /// No board has this number.
    NoSuchBoard(u8),
    /// Bits that must be zero are not.
    Reserved(u8),
    /// No board has this many keys.
    KeyCount(u8),
    /// Something follows the last key's value.
    Padding,
}

/// Reads the header of a frame of `class`; returns it with what follows, key by key.
///
/// `BYTES` is the size of one key's value.
fn decode<const BYTES: usize>(
    bytes: &[u8],
    class: Class,
) -> Result<(Header, &[[u8; BYTES]]), DecodeError> {
    let length = DecodeError::Length { got: bytes.len() };
    let (head, rest) = bytes.split_first_chunk::<{ field::LEN }>().ok_or(length)?;
    let [kind, address, sequence, stamp_low, stamp_high, n] = *head;
    check_kind(kind, class)?;
    if address & field::RESERVED != 0 {
        return Err(DecodeError::Reserved(address & field::RESERVED));
    }
    let board = address & !field::FAULT;
    let board = BoardId::new(board).ok_or(DecodeError::NoSuchBoard(board))?;
    if n == 0 || KEYS_PER_BOARD < usize::from(n) {
        return Err(DecodeError::KeyCount(n));
    }
    let (values, padding) = rest.split_at_checked(usize::from(n) * BYTES).ok_or(length)?;
    if padding.iter().any(|byte| *byte != 0) {
        return Err(DecodeError::Padding);
    }
    let header = Header {
        board,
        sequence: Sequence(sequence),
        stamp_us: u16::from_le_bytes([stamp_low, stamp_high]),
        fault: address & field::FAULT != 0,
    };
    Ok((header, values.as_chunks().0))
}

/// Checks the first byte: our generation, and the class that was asked for.
const fn check_kind(kind: u8, class: Class) -> Result<(), DecodeError> {
    let (major, found) = (kind >> 4, kind & 0xF);
    if !PROTOCOL_VERSION.understands(Version { major, minor: 0 }) {
        Err(DecodeError::Version(major))
    } else if found != class as u8 {
        Err(DecodeError::Class(found))
    } else {
        Ok(())
    }
}

/// Writes a frame of `class` into `bytes`, zeros behind it; returns its unpadded length.
///
/// `values` are at most 11, and `bytes` hold the header and eleven of them.
fn encode<const BYTES: usize>(
    bytes: &mut [u8],
    class: Class,
    header: Header,
    values: impl ExactSizeIterator<Item = [u8; BYTES]>,
) -> usize {
    debug_assert!(values.len() <= KEYS_PER_BOARD, "PerKey keeps eleven");
    bytes.fill(0);
    let [stamp_low, stamp_high] = header.stamp_us.to_le_bytes();
    let n = values.len();
    let head = [
        PROTOCOL_VERSION.major << 4 | class as u8,
        header.board.number() | if header.fault { field::FAULT } else { 0 },
        header.sequence.0,
        stamp_low,
        stamp_high,
        u8::try_from(n).unwrap_or_default(),
    ];
    let (start, rest) = bytes.split_at_mut(field::LEN);
    start.copy_from_slice(&head);
    for (place, value) in rest.as_chunks_mut::<BYTES>().0.iter_mut().zip(values) {
        *place = value;
    }
    field::LEN + n * BYTES
}
