//! The messages, as `proto/letoff/telemetry.proto` describes them.

#![expect(clippy::all, clippy::pedantic, missing_docs, reason = "made by prost-build")]

include!(concat!(env!("OUT_DIR"), "/letoff.telemetry.rs"));

/// What the messages are made of, for viewers: a `google.protobuf.FileDescriptorSet`.
pub const DESCRIPTORS: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/telemetry.binpb"));
