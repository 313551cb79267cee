//! The keyboard host service: a checked scene becomes a run that is played, observed and replayed.
//!
//! | module | contents |
//! |---|---|
//! | [`session`] | one run from its scene to its report |
//! | [`control`] | requests of commands and the stream, on their path to a running voice |
//! | [`adapters`] | implementations of the scheduler's ports: strikes, telemetry rows, links |
//! | [`observe`] | path of the rings' rows to telemetry messages, recordings and the stream |
//! | [`midi_thread`] | thread that sends MIDI |
//! | [`guardian`] | process that holds the MIDI port and the notes, and outlives the host |
//! | [`replay`] | a recording, run again and compared |
//! | [`report`] | summary of a run, for people and as JSON |
//! | [`simulated`] | simulated boards on their own wires |
//!
//! Not here: equations, wire formats, the MIDI mapping of strikes, command lines.

pub mod adapters;
pub mod connected_boards;
pub mod control;
pub mod guardian;
pub mod midi_thread;
pub mod observe;
mod rehearsal_cache;
pub mod replay;
pub mod report;
pub mod session;
pub mod simulated;

pub use rehearsal_cache::RehearsalCache;
