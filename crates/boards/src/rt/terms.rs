//! What is agreed with boards when they are armed.

use firmware_protocol::frame::key_forces::ForcePacking;
use firmware_protocol::frame::key_samples::SamplePacking;

use crate::topology::BoardPlace;

/// What is agreed with all boards.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Terms {
    /// Time between two exchanges (us).
    pub period_us: u16,
    pub samples: SamplePacking,
    pub forces: ForcePacking,
    /// How long forces are valid after the samples that they answer (ms).
    pub valid_ms: u8,
}

/// What is agreed with one board.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct BoardAgreement {
    pub place: BoardPlace,
    pub uid: [u8; 6],
    /// What it can, as in [`firmware_protocol::frame::hello::feature`].
    pub features: u16,
    /// When in the period it begins to send (us).
    pub phase_us: u16,
    pub terms: Terms,
}
