//! The keyboard host service and everything behind the `letoff` command.
//!
//! The only crate that knows all others. [`command`] is what people type, [`config`] turns
//! their files into checked values, [`assemble`] connects objects, [`session`] runs them,
//! [`realtime`] holds threads and clocks, [`adapters`] plug into the scheduler's ports.
//!
//! Not here: equations, wire formats, what a strike means in MIDI.

pub mod adapters;
pub mod assemble;
pub mod bell;
mod boards;
pub mod command;
pub mod config;
pub mod control;
pub mod desk;
mod names;
pub mod observe;
pub mod realtime;
pub mod rehearsal;
pub mod replay;
pub mod report;
pub mod session;
pub mod simulate;
pub mod simulated;
