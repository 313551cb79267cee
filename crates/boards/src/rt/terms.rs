use firmware_protocol::frame::{key_forces::ForcePacking, key_samples::SamplePacking};

use crate::topology::BoardPlace;

/// Agreement with all boards at arming.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Terms {
    pub period_us: u16,
    pub samples: SamplePacking,
    pub forces: ForcePacking,
    /// Validity of forces after the samples that they answer (ms).
    pub valid_ms: u8,
}

/// Agreement with one board.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct BoardAgreement {
    pub place: BoardPlace,
    pub uid: [u8; 6],
    /// Its abilities, as in [`firmware_protocol::frame::hello::feature`].
    pub features: u16,
    /// Offset of its transmissions in the period (us).
    pub phase_us: u16,
    pub terms: Terms,
}
