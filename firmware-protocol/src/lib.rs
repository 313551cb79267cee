//! The wire format between the host and the boards, as both sides compile it.
//!
//! There are two classes of traffic. **Cyclic** frames carry positions up and forces down, in a
//! fixed layout; none is ever repeated, since the next one replaces a lost one. **Acyclic**
//! requests are repeated until they are answered ([`acyclic`]).
//!
//! | frame | from | content |
//! |---|---|---|
//! | [`frame::hello`] | board | identity, version, keys and features |
//! | [`frame::key_samples`] | board | positions of the keys |
//! | [`frame::key_forces`] | host | the forces of one board, an answer to one frame of samples |
//! | [`frame::multicast_forces`] | host | the forces of 30 keys, on any boards |
//! | [`frame::broadcast`] | host | emergency stop, bus time, "who is there?" |
//! | [`acyclic`] | both | requests and replies |
//!
//! On a byte stream a frame travels inside [`serial`] framing with a checksum; on CAN FD padded
//! to a length of the bus, on classic CAN in pieces ([`can`]).
//!
//! ```
//! use firmware_protocol::frame::{FrameKind, Header, key_forces::{self, ForceLayout, ForcePacking, KeyForces}};
//! use firmware_protocol::key::{BoardId, PerKey};
//! use firmware_protocol::quantity::Millinewtons;
//! use firmware_protocol::sequence::SequenceNumber;
//! use firmware_protocol::serial::{self, Deframer};
//!
//! let board = BoardId::new(3).unwrap();
//! let header = Header { board, sequence: SequenceNumber(0), stamp_us: 1_000, flag: false };
//! let sent = KeyForces {
//!     header,
//!     forces: PerKey::collect([Millinewtons::saturating(500)]),
//!     slopes: PerKey::default(),
//! };
//!
//! let (mut frame, mut wire) = ([0; key_forces::MAX_LEN], [0; serial::MAX_WIRE]);
//! let len = sent.encode(&mut frame);
//! let len = serial::encode(&frame[..len], &mut wire).unwrap();
//!
//! let layout = ForceLayout { packing: ForcePacking::Force16, n_keys: 1 };
//! let mut deframer = Deframer::default();
//! for byte in &wire[..len] {
//!     if let Some(frame) = deframer.push(*byte) {
//!         let frame = frame.unwrap();
//!         assert_eq!(FrameKind::of(frame), Some(FrameKind::KeyForces));
//!         assert_eq!(KeyForces::decode(frame, layout), Ok(sent));
//!     }
//! }
//! ```
//!
//! This crate contains only integers. Metres and newtons appear in `boards::calibration`. `c/` is
//! the counterpart for firmware in C, and `vectors/` has golden bytes for any language.
#![no_std]
#![forbid(unsafe_code)]

#[macro_use]
mod record;

pub mod acyclic;
pub mod can;
pub mod frame;
pub mod key;
mod length;
pub mod quantity;
pub mod schema;
pub mod sequence;
pub mod serial;
pub mod version;

pub use record::{Nothing, Record, RecordField, RecordLayout};

/// Length of the longest frame on any link: CAN FD's (bytes).
pub const MAX_FRAME: usize = 64;
