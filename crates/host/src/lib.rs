//! The keyboard host service: a checked scene becomes a run that plays, is observed and replayed.
//!
//! | module | contents |
//! |---|---|
//! | [`session`] | one run from its scene to its report |
//! | [`control`] | requests of commands and of the stream, on their way to a running voice |
//! | [`adapters`] | what plugs into the scheduler's ports: strikes, rows of telemetry, links |
//! | [`observe`] | from rings to telemetry messages, to recordings and to the stream |
//! | [`midi_thread`] | the thread that sends MIDI |
//! | [`guardian`] | the process that holds the MIDI port and the notes, and outlives the host |
//! | [`replay`] | a recording run again and compared |
//! | [`report`] | what a run did, for people and as JSON |
//! | [`simulated`] | simulated boards on wires of their own |
//!
//! Not here: equations, wire formats, what a strike means in MIDI, what people type.

pub mod adapters;
pub mod connected_boards;
pub mod control;
pub mod guardian;
pub mod midi_thread;
pub mod observe;
pub mod replay;
pub mod report;
pub mod session;
pub mod simulated;
