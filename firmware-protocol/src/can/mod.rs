//! Frames on CAN: identifiers, padding, and pieces for classic CAN.
//!
//! ```text
//! identifier, 11 bits:  bits 10..7 class, bits 6..0 board; 15 is all boards
//! ```
//!
//! The class comes first, so that urgent frames win the bus whichever board sends them. The frame
//! contains kind and board too: receivers reject a frame that disagrees with its identifier.

pub mod pieces;

pub use crate::length::{LENGTHS, padded};

use crate::frame::{ALL_BOARDS, FrameKind};

/// Class of a frame, by urgency; the smaller number wins the bus.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
#[repr(u8)]
pub enum Class {
    Stop = 0,
    /// Bus time, and "who is there?".
    Sync = 1,
    MulticastForces = 2,
    KeyForces = 3,
    KeySamples = 4,
    Request = 8,
    Reply = 9,
    Hello = 10,
}

impl Class {
    /// All classes in the order of urgency.
    pub const ALL: [Self; 8] = [
        Self::Stop,
        Self::Sync,
        Self::MulticastForces,
        Self::KeyForces,
        Self::KeySamples,
        Self::Request,
        Self::Reply,
        Self::Hello,
    ];

    /// Returns the class of a frame; `None` if its kind is unknown.
    pub fn of(frame: &[u8]) -> Option<Self> {
        Some(match FrameKind::of(frame)? {
            FrameKind::Broadcast if frame.get(1) == Some(&1) => Self::Stop,
            FrameKind::Broadcast => Self::Sync,
            FrameKind::KeyForces => Self::KeyForces,
            FrameKind::MulticastForces => Self::MulticastForces,
            FrameKind::KeySamples => Self::KeySamples,
            FrameKind::Request => Self::Request,
            FrameKind::Reply => Self::Reply,
            FrameKind::Hello => Self::Hello,
        })
    }
}

/// Bits of the identifier below the class.
pub const NODE_BITS: u16 = 7;

/// Returns the identifier of a frame; `None` if its kind is unknown.
pub fn identifier(frame: &[u8]) -> Option<u16> {
    let class = Class::of(frame)?;
    let node =
        if class == Class::MulticastForces { ALL_BOARDS } else { frame.first()? & ALL_BOARDS };
    Some(u16::from(class as u8) << NODE_BITS | u16::from(node))
}

/// Returns `true` if a frame may have this identifier.
pub fn agrees(id: u16, frame: &[u8]) -> bool {
    identifier(frame) == Some(id)
}
