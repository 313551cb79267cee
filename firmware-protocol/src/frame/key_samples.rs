//! Positions of a board's keys: board → host, at the agreed rate.
//!
//! ```text
//! byte 0..3   header, kind 3; board time is when the encoders were read; flag: the board
//!             renders no forces
//! byte 4..    for each key, by packing:
//!             position16           2 bytes  position [counts], saturated
//!             position24           3 bytes  position [counts]
//!             position16-velocity  4 bytes  position, velocity [0.2 mm/s]
//!             position24-velocity  5 bytes  position, velocity
//! ```
//!
//! With eleven keys these are 26, 37, 48 and 59 bytes; on CAN FD 32, 48, 48, 64. Down is positive.

use super::{DecodeError, FrameKind, HEADER_LEN, Header};
use crate::MAX_FRAME;
use crate::key::PerKey;
use crate::quantity::{Counts, SpeedCode};

pub const MAX_LEN: usize = MAX_FRAME;

/// Packing of each key's sample.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
#[repr(u8)]
pub enum SamplePacking {
    Position16 = 0,
    #[default]
    Position24 = 1,
    Position16Velocity = 2,
    Position24Velocity = 3,
}

impl SamplePacking {
    /// All packings, the one with the least information first.
    pub const ALL: [Self; 4] =
        [Self::Position16, Self::Position24, Self::Position16Velocity, Self::Position24Velocity];

    pub fn new(number: u8) -> Option<Self> {
        Self::ALL.get(usize::from(number)).copied()
    }

    /// Returns the length of one key (bytes).
    pub const fn key_len(self) -> usize {
        match self {
            Self::Position16 => 2,
            Self::Position24 => 3,
            Self::Position16Velocity => 4,
            Self::Position24Velocity => 5,
        }
    }

    /// Returns the length of a frame with `n_keys` keys, without padding (bytes).
    pub const fn frame_len(self, n_keys: usize) -> usize {
        HEADER_LEN + n_keys * self.key_len()
    }

    const fn is_short(self) -> bool {
        matches!(self, Self::Position16 | Self::Position16Velocity)
    }

    pub const fn has_velocity(self) -> bool {
        matches!(self, Self::Position16Velocity | Self::Position24Velocity)
    }
}

/// Agreed layout of a board's samples.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SampleLayout {
    pub packing: SamplePacking,
    pub n_keys: usize,
}

/// Positions of one board's keys at one time, with velocities if the packing has them.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct KeySamples {
    /// The sender, and the time at which the encoders were read.
    pub header: Header,
    /// Position of each key, in the order of slots.
    pub positions: PerKey<Counts>,
    /// Velocity of each key; as many as positions, or none.
    pub velocities: PerKey<SpeedCode>,
}

impl KeySamples {
    pub fn decode(bytes: &[u8], layout: SampleLayout) -> Result<Self, DecodeError> {
        let SampleLayout { packing, n_keys } = layout;
        let len = n_keys * packing.key_len();
        let (header, values) = Header::decode(bytes, FrameKind::KeySamples, len)?;
        let keys = values.chunks_exact(packing.key_len());
        let positions = PerKey::collect(keys.clone().map(|key| position(packing, key)));
        let velocities = if packing.has_velocity() {
            PerKey::collect(
                keys.filter_map(<[u8]>::last_chunk).copied().map(SpeedCode::from_le_bytes),
            )
        } else {
            PerKey::default()
        };
        Ok(Self { header, positions, velocities })
    }

    /// Writes the frame and zeros, 0 for a missing velocity; returns its length without zeros.
    pub fn encode(&self, packing: SamplePacking, bytes: &mut [u8; MAX_LEN]) -> usize {
        let (start, rest) = bytes.split_at_mut(HEADER_LEN);
        rest.fill(0);
        if let Some(head) = start.first_chunk_mut() {
            self.header.encode(FrameKind::KeySamples, head);
        }
        let velocities = self.velocities.as_slice().iter().copied();
        let velocities = velocities.chain(core::iter::repeat(SpeedCode::default()));
        let keys = self.positions.as_slice().iter().zip(velocities);
        for (place, (counts, velocity)) in rest.chunks_exact_mut(packing.key_len()).zip(keys) {
            put(packing, place, *counts, velocity);
        }
        packing.frame_len(self.positions.as_slice().len()).min(MAX_LEN)
    }
}

fn position(packing: SamplePacking, key: &[u8]) -> Counts {
    match *key {
        [low, high, ..] if packing.is_short() => {
            Counts::saturating(i16::from_le_bytes([low, high]).into())
        }
        [low, middle, high, ..] => Counts::from_le_bytes([low, middle, high]),
        _ => Counts::default(),
    }
}

fn put(packing: SamplePacking, place: &mut [u8], counts: Counts, velocity: SpeedCode) {
    let positions = if packing.is_short() { 2 } else { 3 };
    let bytes = if packing.is_short() {
        let [low, high] = counts.saturated().to_le_bytes();
        [low, high, 0]
    } else {
        counts.to_le_bytes()
    };
    for (place, byte) in
        place.iter_mut().zip(bytes[..positions].iter().copied().chain(velocity.to_le_bytes()))
    {
        *place = byte;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::key::BoardId;
    use crate::sequence::SequenceNumber;

    #[test]
    fn a_position_beyond_16_bits_stops_at_the_edge() {
        let (board, sequence) = (BoardId::new(3).unwrap(), SequenceNumber(7));
        let header = Header { board, sequence, stamp_us: 40_000, flag: true };
        let positions = PerKey::collect([Counts::saturating(40_000); 11]);
        let samples = KeySamples { header, positions, velocities: PerKey::default() };
        let mut bytes = [0; MAX_LEN];
        let len = samples.encode(SamplePacking::Position16, &mut bytes);
        let layout = SampleLayout { packing: SamplePacking::Position16, n_keys: 11 };
        let read = KeySamples::decode(&bytes[..len], layout).unwrap();
        assert_eq!(read.positions.as_slice()[0].get(), 32_767);
    }
}
