//! The messages, as `proto/letoff/telemetry.proto` describes them.
//!
//! `proto/generated/` is made from that description by `tests/generated.rs`, which also tells
//! when it is not up to date.

#![expect(clippy::all, clippy::pedantic, missing_docs, reason = "made by prost-build")]

include!("../proto/generated/letoff.telemetry.rs");

/// What the messages are made of, for viewers: a `google.protobuf.FileDescriptorSet`.
pub const DESCRIPTORS: &[u8] = include_bytes!("../proto/generated/telemetry.binpb");
