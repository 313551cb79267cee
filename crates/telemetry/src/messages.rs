//! The messages of `proto/letoff/telemetry.proto`.
//!
//! `tests/generated.rs` generates `proto/generated/` and fails when it is not up to date.

#![expect(clippy::all, clippy::pedantic, missing_docs, reason = "made by prost-build")]

include!("../proto/generated/letoff.telemetry.rs");

/// Descriptors of the messages for viewers: a `google.protobuf.FileDescriptorSet`.
pub const DESCRIPTORS: &[u8] = include_bytes!("../proto/generated/telemetry.binpb");
