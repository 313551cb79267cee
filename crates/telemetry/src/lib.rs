//! Observation of a host: messages, the stream that carries them, and recordings.
//!
//! Nothing here knows a key's physics or a clock. [`recording`] writes messages to files and reads
//! them back. The types here and the schemas for viewers are generated from
//! `proto/letoff/telemetry.proto`.
//!
//! | topic | message | when |
//! |---|---|---|
//! | `/keys/overview` | [`Overview`] | some thirty times a second |
//! | `/key/<n>/block` | [`KeyBlock`] | every tick in which anything changed |
//! | `/key/<n>/state` | [`KeyState`] | as blocks, for viewers that take one value with each time |
//! | `/events` | [`Event`] | as they happen |
//! | `/voices` | [`Voice`] | at the start, and with each change |
//! | `/catalogue` | [`Catalogue`] | at the start |
//! | `/ticks`, `/deadlines` | [`Ticks`], [`Deadlines`] | often; once a second |
//! | `/links` | [`Links`] | once a second |
//! | `/midi` | [`Midi`] | as they are sent |
//! | `/log` | [`Log`] | when there is something to read |
//! | `/status` | [`Status`] | with each change, and once a second |
//!
//! [`stream`] contains the server and the client.

#![forbid(unsafe_code)]

mod file;
mod host_status;
mod key_block;
mod keys;
mod messages;
pub mod metrics;
pub mod recording;
pub mod request;
mod role;
pub mod source;
pub mod stream;
pub mod topic;

pub use host_status::{BoardState, DeadlineStatus, HostState, HostStatus, RunProgress, Severity};
pub use keyboard::{Difference, KEYS, KeyIndex};
pub use keys::key_name;
pub use messages::*;
pub use request::{Reply, Request};
pub use source::{Arrival, ConnectionState, Source, Timeline};
pub use topic::{Topic, Update};
