//! Tests from a MIDI file to strokes of a simulated key.
#![expect(clippy::expect_used, reason = "a test that cannot be set up fails")]

mod odd_files;
mod performances;
mod pianist;
mod rehearse;
mod score;
mod simulated_key;
