//! Streams and recordings, also of hostile peers and broken files.
#![expect(clippy::expect_used, clippy::panic, reason = "helpers of tests fail aloud")]
#![expect(clippy::wildcard_enum_match_arm, reason = "a test looks for one thing")]

mod common;
mod generated;
mod hostile;
mod python_client;
mod python_reader;
mod recording;
mod stream;
mod test_server;
