//! Tests from a MIDI file to strokes of a simulated key.

mod performances;
mod pianist;
mod rehearse;
mod score;
mod simulated_key;
