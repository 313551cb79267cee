//! The wire format between the host and the boards, as both sides compile it.
//!
//! Boards speak first: once a tick a board sends [`KeySamples`](frame::key_samples::KeySamples),
//! and the host answers with [`KeyForces`](frame::key_forces::KeyForces). Neither is ever
//! sent twice: what was lost is replaced by the next one, never repaired.
//! On CAN a frame travels as it is, padded to a length that CAN FD has; on a byte stream
//! it travels inside [`serial`] framing with its own checksum.
//!
//! ```
//! use firmware_protocol::frame::{Header, key_forces::{self, KeyForces}};
//! use firmware_protocol::key::{BoardId, PerKey};
//! use firmware_protocol::quantity::Millinewtons;
//! use firmware_protocol::sequence::Sequence;
//! use firmware_protocol::serial::{self, Deframer};
//!
//! let board = BoardId::new(3).unwrap();
//! let header = Header { board, sequence: Sequence(0), stamp_us: 1_000, fault: false };
//! let sent = KeyForces { header, forces: PerKey::collect([Millinewtons::saturating(500)]) };
//!
//! let (mut frame, mut wire) = ([0; key_forces::MAX_LEN], [0; serial::MAX_WIRE]);
//! let len = sent.encode(&mut frame);
//! let len = serial::encode(&frame[..len], &mut wire).unwrap();
//!
//! let mut deframer = Deframer::default();
//! for byte in &wire[..len] {
//!     if let Some(frame) = deframer.push(*byte) {
//!         assert_eq!(KeyForces::decode(frame.unwrap()), Ok(sent));
//!     }
//! }
//! ```
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
