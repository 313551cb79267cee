//! The forces of thirty keys in one frame: host → all boards on a bus.
//!
//! ```text
//! byte 0      kind 2, flag: render no force, bits 3..0 group g
//! byte 1      sequence
//! byte 2..3   bus time [us] when the forces were computed, see [`super::broadcast`]
//! byte 4..64  force of the keys 30 g .. 30 g + 29 [mN]
//! ```
//!
//! 64 bytes exactly. Three frames carry a whole keyboard, where eight boards would take eight;
//! each board picks its own keys. The forces are valid until their bus time plus the time that
//! was agreed at arming; a board without bus time for a second accepts none.

use super::{DecodeError, FrameKind, check_kind, flag, head};
use crate::MAX_FRAME;
use crate::quantity::Millinewtons;
use crate::sequence::SequenceNumber;

pub const GROUP: usize = 30;
pub const GROUPS: usize = 3;

pub const LEN: usize = MAX_FRAME;

/// The forces of thirty keys.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct MulticastForces {
    /// Group of thirty keys, `0 ..= 2`.
    pub group: u8,
    /// Number of this frame among those of its group.
    pub sequence: SequenceNumber,
    /// Bus time when the forces were computed (us).
    pub stamp_us: u16,
    pub flag: bool,
    pub forces: [Millinewtons; GROUP],
}

impl MulticastForces {
    pub fn decode(bytes: &[u8]) -> Result<Self, DecodeError> {
        let bytes: &[u8; LEN] =
            bytes.try_into().map_err(|_other_length| DecodeError::Length { got: bytes.len() })?;
        let [first, sequence, low, high, values @ ..] = bytes;
        check_kind(*first, FrameKind::MulticastForces)?;
        let group = first & super::field::BOARD;
        if GROUPS <= usize::from(group) {
            return Err(DecodeError::Value { at: 0 });
        }
        let mut forces = [Millinewtons::default(); GROUP];
        for (force, bytes) in forces.iter_mut().zip(values.as_chunks().0) {
            *force = Millinewtons::from_le_bytes(*bytes);
        }
        let stamp_us = u16::from_le_bytes([*low, *high]);
        Ok(Self {
            group,
            sequence: SequenceNumber(*sequence),
            stamp_us,
            flag: flag(*first),
            forces,
        })
    }

    pub fn encode(&self) -> [u8; LEN] {
        let mut bytes = [0; LEN];
        let [low, high] = self.stamp_us.to_le_bytes();
        let flag = u8::from(self.flag) << super::field::FLAG_SHIFT;
        let first = head(FrameKind::MulticastForces, self.group) | flag;
        let (start, rest) = bytes.split_at_mut(super::HEADER_LEN);
        start.copy_from_slice(&[first, self.sequence.0, low, high]);
        for (place, force) in rest.as_chunks_mut().0.iter_mut().zip(&self.forces) {
            *place = force.to_le_bytes();
        }
        bytes
    }
}
