//! How many bytes a frame takes for so many keys: the packings are those of the wire.
//!
//! Forces for all boards are another matter: their frames are always whole, see [`super::bus`].

pub use firmware_protocol::frame::key_forces::ForcePacking;
pub use firmware_protocol::frame::key_samples::SamplePacking;
