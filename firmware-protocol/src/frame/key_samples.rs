//! Where a board's keys are: board → host, once a tick.
//!
//! ```text
//! byte 0..6   header, class 2; board time is when the encoders were read
//! byte 6 + 3 k .. 9 + 3 k   key k: position [counts], 24 bits, little-endian
//! ```
//!
//! 39 bytes with eleven keys; 48 on CAN FD.

use super::{Class, DecodeError, Header};
use crate::key::PerKey;
use crate::quantity::Counts;

mod field {
    /// Bytes on CAN FD: the next length that it has.
    pub(super) const PADDED: usize = 48;
}

/// The longest encoding, padding included.
pub const MAX_LEN: usize = field::PADDED;

/// The positions of one board's keys.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct KeySamples {
    /// Who says so, and as of when.
    pub header: Header,
    /// Position of each key, in the order of slots.
    pub positions: PerKey<Counts>,
}

impl KeySamples {
    /// Reads a frame, padded or not; never panics, whatever the bytes.
    ///
    /// # Errors
    /// Says what in `bytes` is not of this frame.
    pub fn decode(bytes: &[u8]) -> Result<Self, DecodeError> {
        if MAX_LEN < bytes.len() {
            return Err(DecodeError::Length { got: bytes.len() });
        }
        let (header, values) = super::decode(bytes, Class::KeySamples)?;
        let positions = PerKey::collect(values.iter().copied().map(Counts::from_le_bytes));
        Ok(Self { header, positions })
    }

    /// Writes the frame and zeros behind it; returns its length without them.
    pub fn encode(&self, bytes: &mut [u8; MAX_LEN]) -> usize {
        let values = self.positions.as_slice().iter().map(|counts| counts.to_le_bytes());
        super::encode(bytes, Class::KeySamples, self.header, values)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::key::BoardId;
    use crate::sequence::Sequence;

    fn frame() -> KeySamples {
        let board = BoardId::new(3).unwrap();
        let header = Header { board, sequence: Sequence(9), stamp_us: 500, fault: true };
        KeySamples { header, positions: PerKey::collect((-5..6).map(Counts::saturating)) }
    }

    #[test]
    fn eleven_keys_fill_39_bytes_and_read_back_with_and_without_padding() {
        let mut bytes = [0xAA; MAX_LEN];
        let n = frame().encode(&mut bytes);
        assert_eq!(n, 39);
        assert_eq!(KeySamples::decode(&bytes[..n]), Ok(frame()));
        assert_eq!(KeySamples::decode(&bytes), Ok(frame()));
    }

    #[test]
    fn each_foreign_byte_is_refused_with_its_reason() {
        check(0, 0x22, DecodeError::Version(2));
        check(0, 0x11, DecodeError::Class(1));
        check(1, 0x08, DecodeError::NoSuchBoard(8));
        check(1, 0x13, DecodeError::Reserved(0x10));
        check(5, 0, DecodeError::KeyCount(0));
        check(5, 12, DecodeError::KeyCount(12));
        check(40, 1, DecodeError::Padding);
    }

    /// Asserts that a frame with `byte` at `place` is refused as `expected`.
    #[track_caller]
    fn check(place: usize, byte: u8, expected: DecodeError) {
        let mut bytes = [0; MAX_LEN];
        frame().encode(&mut bytes);
        bytes[place] = byte;
        assert_eq!(KeySamples::decode(&bytes), Err(expected));
    }

    #[test]
    fn a_frame_that_was_cut_is_refused() {
        let mut bytes = [0; MAX_LEN];
        let n = frame().encode(&mut bytes);
        for got in 0..n {
            assert_eq!(KeySamples::decode(&bytes[..got]), Err(DecodeError::Length { got }));
        }
        assert_eq!(KeySamples::decode(&[0; 49]), Err(DecodeError::Length { got: 49 }));
    }
}
