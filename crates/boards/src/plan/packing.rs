//! Packings of the wire: bytes of a frame by its number of keys. Frames with forces for all boards
//! are always whole, see [`super::bus`].

pub use firmware_protocol::frame::{key_forces::ForcePacking, key_samples::SamplePacking};
