//! What a board's motors shall do: host → board, an answer to one frame of samples.
//!
//! ```text
//! byte 0..3   header, kind 1; sequence and board time are those of the samples answered;
//!             flag: render no force
//! byte 4..    for each key, by packing:
//!             force16        2 bytes  F0 [mN]
//!             force16-slope  4 bytes  F0, stiffness K, damping B ([`SlopeCode`], 0.25 N/m and
//!                                     0.001 N s/m)
//! ```
//!
//! With eleven keys these are 26 and 48 bytes; on CAN FD 32 and 48 (filled exactly).
//!
//! Between two frames the board renders F0 + K (s0 − s) + B (s0' − s'). The point s0, s0'
//! moves as the key was expected to: it starts at the position and velocity in the samples
//! that the frame answers, which the board knows exactly, so they need no bytes, and goes on at
//! that velocity for at most [`crate::acyclic::arm::PATH_US`] after they were taken. So only
//! what was not expected changes the force, however long the frame was on its way. Force up and position down are positive: a spring and a
//! damper that push back grow upwards with s and s', so their K = −∂F/∂s and B = −∂F/∂s' are
//! **negative**.
//!
//! The forces are **valid until** the time of the samples answered plus the time that was
//! agreed when the board was armed. A board takes a frame only if both sequence and time are
//! those of one of its last 64 frames of samples, which is not older than that and not older
//! than the one answered before: so nothing stale is ever rendered, whatever a link does.

use super::{DecodeError, FrameKind, HEADER_LEN, Header};
use crate::MAX_FRAME;
use crate::key::PerKey;
use crate::quantity::{Millinewtons, SlopeCode};

pub const MAX_LEN: usize = MAX_FRAME;

/// How each key is packed.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
#[repr(u8)]
pub enum ForcePacking {
    #[default]
    Force16 = 0,
    /// The force and how it goes on.
    Force16Slope = 1,
    /// The force, held, in frames for all boards: [`super::multicast_forces`].
    Multicast16 = 2,
}

impl ForcePacking {
    pub const ALL: [Self; 3] = [Self::Force16, Self::Force16Slope, Self::Multicast16];

    /// Returns the packing with this number.
    pub fn new(number: u8) -> Option<Self> {
        Self::ALL.get(usize::from(number)).copied()
    }

    /// Returns the bytes for one key.
    pub const fn key_len(self) -> usize {
        match self {
            Self::Force16 | Self::Multicast16 => 2,
            Self::Force16Slope => 4,
        }
    }

    /// Returns the bytes of a frame with `n_keys` keys, without padding.
    pub const fn frame_len(self, n_keys: usize) -> usize {
        HEADER_LEN + n_keys * self.key_len()
    }
}

/// What was agreed of a board's forces.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ForceLayout {
    /// How each key is packed.
    pub packing: ForcePacking,
    /// How many keys there are.
    pub n_keys: usize,
}

/// How a key's force goes on between two frames.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct KeySlopes {
    /// K = −∂F/∂s (0.25 N/m).
    pub stiffness: SlopeCode,
    /// B = −∂F/∂s' (0.001 N s/m).
    pub damping: SlopeCode,
}

/// The forces of one board's keys.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct KeyForces {
    /// Who is meant, and which samples are answered.
    pub header: Header,
    /// Force of each key where the samples have it, in the order of slots.
    pub forces: PerKey<Millinewtons>,
    /// How each force goes on; as many as forces, or none.
    pub slopes: PerKey<KeySlopes>,
}

impl KeyForces {
    /// Reads a frame, padded or not; never panics, whatever the bytes.
    ///
    /// # Errors
    /// Says what in `bytes` is not of this frame.
    pub fn decode(bytes: &[u8], layout: ForceLayout) -> Result<Self, DecodeError> {
        let ForceLayout { packing, n_keys } = layout;
        let len = n_keys * packing.key_len();
        let (header, values) = Header::decode(bytes, FrameKind::KeyForces, len)?;
        let keys = values.chunks_exact(packing.key_len());
        let force = |key: &[u8]| key.first_chunk().copied().map(Millinewtons::from_le_bytes);
        let slopes = |key: &[u8]| match *key {
            [_, _, stiffness, damping] => Some(KeySlopes {
                stiffness: SlopeCode::from_code(stiffness),
                damping: SlopeCode::from_code(damping),
            }),
            _ => None,
        };
        Ok(Self {
            header,
            forces: PerKey::collect(keys.clone().filter_map(force)),
            slopes: PerKey::collect(keys.filter_map(slopes)),
        })
    }

    /// Writes the frame with zeros behind it; returns its length without them.
    ///
    /// It has slopes if there are any.
    pub fn encode(&self, bytes: &mut [u8; MAX_LEN]) -> usize {
        let packing = self.packing();
        let (start, rest) = bytes.split_at_mut(HEADER_LEN);
        rest.fill(0);
        if let Some(head) = start.first_chunk_mut() {
            self.header.encode(FrameKind::KeyForces, head);
        }
        let places = rest.chunks_exact_mut(packing.key_len());
        for (slot, (place, force)) in places.zip(self.forces.as_slice()).enumerate() {
            place[..Millinewtons::LEN].copy_from_slice(&force.to_le_bytes());
            if let Some(KeySlopes { stiffness, damping }) = self.slopes.as_slice().get(slot) {
                place[Millinewtons::LEN..].copy_from_slice(&[stiffness.code(), damping.code()]);
            }
        }
        packing.frame_len(self.forces.as_slice().len()).min(MAX_LEN)
    }

    /// Returns how this frame is packed.
    pub const fn packing(&self) -> ForcePacking {
        if self.slopes.is_empty() { ForcePacking::Force16 } else { ForcePacking::Force16Slope }
    }
}
