//! Streams and recordings, also of hostile peers and broken files.
#![allow(clippy::expect_used, reason = "helpers of tests fail aloud")]

mod common;
mod generated;
mod hostile;
mod python_client;
mod python_reader;
mod recording;
mod stream;
mod test_server;
