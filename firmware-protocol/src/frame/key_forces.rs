//! What a board's motors shall do: host → board, once a tick.
//!
//! ```text
//! byte 0..6   header, class 1; board time is that of the newest samples the host knew
//! byte 6 + 2 k .. 8 + 2 k   key k: force on the finger [mN], up positive, little-endian
//! ```
//!
//! 28 bytes with eleven keys; 32 on CAN FD.

use super::{Class, DecodeError, Header};
use crate::key::PerKey;
use crate::quantity::Millinewtons;

mod field {
    /// Bytes on CAN FD: the next length that it has.
    pub(super) const PADDED: usize = 32;
}

/// The longest encoding, padding included.
pub const MAX_LEN: usize = field::PADDED;

/// The forces of one board's keys, held until the next ones come.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct KeyForces {
    /// Who is meant, and which samples are answered.
    pub header: Header,
    /// Force of each key, in the order of slots.
    pub forces: PerKey<Millinewtons>,
}

impl KeyForces {
    /// Reads a frame, padded or not; never panics, whatever the bytes.
    ///
    /// # Errors
    /// Says what in `bytes` is not of this frame.
    pub fn decode(bytes: &[u8]) -> Result<Self, DecodeError> {
        if MAX_LEN < bytes.len() {
            return Err(DecodeError::Length { got: bytes.len() });
        }
        let (header, values) = super::decode(bytes, Class::KeyForces)?;
        let forces = PerKey::collect(values.iter().copied().map(Millinewtons::from_le_bytes));
        Ok(Self { header, forces })
    }

    /// Writes the frame and zeros behind it; returns its length without them.
    pub fn encode(&self, bytes: &mut [u8; MAX_LEN]) -> usize {
        let values = self.forces.as_slice().iter().map(|force| force.to_le_bytes());
        super::encode(bytes, Class::KeyForces, self.header, values)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::key::BoardId;
    use crate::sequence::Sequence;

    fn frame() -> KeyForces {
        let board = BoardId::new(7).unwrap();
        let header = Header { board, sequence: Sequence(255), stamp_us: 65_535, fault: false };
        let forces = (0..11).map(|key| Millinewtons::saturating(1_000 * key - 5_000));
        KeyForces { header, forces: PerKey::collect(forces) }
    }

    #[test]
    fn eleven_keys_fill_28_bytes_and_read_back_with_and_without_padding() {
        let mut bytes = [0xAA; MAX_LEN];
        let n = frame().encode(&mut bytes);
        assert_eq!(n, 28);
        assert_eq!(KeyForces::decode(&bytes[..n]), Ok(frame()));
        assert_eq!(KeyForces::decode(&bytes), Ok(frame()));
    }

    #[test]
    fn samples_are_not_forces() {
        let mut bytes = [0; MAX_LEN];
        frame().encode(&mut bytes);
        bytes[0] = bytes[0] & 0xF0 | Class::KeySamples as u8;
        assert_eq!(KeyForces::decode(&bytes), Err(DecodeError::Class(2)));
    }

    #[test]
    fn a_frame_that_was_cut_is_refused() {
        let mut bytes = [0; MAX_LEN];
        let n = frame().encode(&mut bytes);
        for got in 0..n {
            assert_eq!(KeyForces::decode(&bytes[..got]), Err(DecodeError::Length { got }));
        }
        assert_eq!(KeyForces::decode(&[0; 33]), Err(DecodeError::Length { got: 33 }));
    }
}
