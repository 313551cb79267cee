//! Bytes of a frame by its number of keys; multicast forces are always whole, see [`super::bus`].

pub use firmware_protocol::frame::{key_forces::ForcePacking, key_samples::SamplePacking};
