//! Forces of a board's motors: host → board, an answer to one frame of samples.
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
//! With eleven keys these are 26 and 48 bytes; on CAN FD 32 and 48.
//!
//! Between two frames the board renders F0 + K (s0 − s) + B (s0' − s'). The point s0, s0' moves as
//! the key was expected to. It starts at the position and velocity of the answered samples, which
//! the board knows exactly, so the frame does not contain them. It continues at that velocity for
//! at most [`crate::acyclic::arm::PATH_US`] after the samples. So only unexpected motion changes
//! the force, however long the frame was on its way. Force up and position down are positive: a
//! spring and a damper that push back grow upwards with s and s', so their K = −∂F/∂s and
//! B = −∂F/∂s' are **negative**.
//!
//! The forces are **valid until** the time of the answered samples plus the time that was agreed
//! at arming. A board accepts a frame only if both sequence and time are those of one of its last
//! 64 sample frames, which is neither older than that nor older than the last answered one: so no
//! stale force is rendered, whatever a link does.

use super::{DecodeError, FrameKind, HEADER_LEN, Header};
use crate::MAX_FRAME;
use crate::key::PerKey;
use crate::quantity::{Millinewtons, SlopeCode};

pub const MAX_LEN: usize = MAX_FRAME;

/// Packing of each key's force.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
#[repr(u8)]
pub enum ForcePacking {
    #[default]
    Force16 = 0,
    Force16Slope = 1,
    /// The force, held, in frames for all boards: [`super::multicast_forces`].
    Multicast16 = 2,
}

impl ForcePacking {
    pub const ALL: [Self; 3] = [Self::Force16, Self::Force16Slope, Self::Multicast16];

    pub fn new(number: u8) -> Option<Self> {
        Self::ALL.get(usize::from(number)).copied()
    }

    /// Returns the length of one key (bytes).
    pub const fn key_len(self) -> usize {
        match self {
            Self::Force16 | Self::Multicast16 => 2,
            Self::Force16Slope => 4,
        }
    }

    /// Returns the length of a frame with `n_keys` keys, without padding (bytes).
    pub const fn frame_len(self, n_keys: usize) -> usize {
        HEADER_LEN + n_keys * self.key_len()
    }
}

/// Agreed layout of a board's forces.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ForceLayout {
    pub packing: ForcePacking,
    pub n_keys: usize,
}

/// Slopes of a key's force between two frames.
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
    /// The receiver, and the answered samples.
    pub header: Header,
    /// Force of each key at the samples, in the order of slots.
    pub forces: PerKey<Millinewtons>,
    /// Slopes of each force; as many as forces, or none.
    pub slopes: PerKey<KeySlopes>,
}

impl KeyForces {
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

    /// Writes the frame, slopes if any, and zeros; returns its length without the zeros.
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

    pub const fn packing(&self) -> ForcePacking {
        if self.slopes.is_empty() { ForcePacking::Force16 } else { ForcePacking::Force16Slope }
    }
}
