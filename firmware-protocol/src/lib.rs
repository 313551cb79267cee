//! The wire format between the host and the boards, as both sides compile it.
//!
//! Boards speak first: once a tick a board sends [`KeySamples`](frame::key_samples::KeySamples),
//! and the host answers with [`KeyForces`](frame::key_forces::KeyForces). Neither is ever
//! sent twice: what was lost is replaced by the next one, never repaired.
//! On CAN a frame travels as it is, padded to a length that CAN FD has; on a byte stream
//! it travels inside [`serial`] framing with its own checksum.
//!
//! Here are integers only. Metres and newtons appear in `hardware::calibration`.
#![no_std]
#![forbid(unsafe_code)]

pub mod frame;
pub mod key;
pub mod quantity;
pub mod sequence;
pub mod serial;
pub mod version;
