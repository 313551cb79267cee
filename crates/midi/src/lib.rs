//! MIDI messages for strikes and releases, and received program changes.
//!
//! | event | messages, at the same time |
//! |---|---|
//! | a strike on a silent note | note-on, velocity from the hammer speed by a [`VelocityCurve`], or the one of an instrument without dynamics |
//! | a strike on a sounding note | note-off, then note-on |
//! | the damper falls on a sounding note | a real note-off (`8n`) with its release velocity |
//! | a strike with the damper down | note-on, and its note-off [`player::UNDAMPED`] later |
//! | the damper lifts | nothing |
//! | the force on a held key changes, of an instrument with aftertouch | pressure of the channel or of the key |
//! | a pedal moves | CC64 (sustain), CC66 (sostenuto) or CC67 (una corda), if its 7-bit value changed |
//! | [`Player::silence`], or the player is dropped | note-off for every held note, CC64, CC66 and CC67 = 0, CC123, CC120 |
//! | no sign of the host for [`guardian::SILENT_AFTER`], or it exits | the same, by a [`NoteGuardian`] that outlives it |
//!
//! Everything here may block and allocate: a tick passes its events through a ring and waits for
//! nothing. [`Schedule`] puts them in order of time, note-offs first.
//! This crate reads no clock: times are `f64` seconds since the host started, given as arguments.

#![forbid(unsafe_code)]

pub mod guardian;
pub mod held;
pub mod input;
mod ledger;
pub mod message;
pub mod note;
pub mod output;
pub mod pedal;
pub mod player;
pub mod schedule;
pub mod sound;
pub mod velocity;

pub use guardian::NoteGuardian;
pub use held::HeldNotes;
pub use input::{ProgramChange, ProgramInput};
pub use message::{Controller, Message, MidiDecodeError};
pub use note::{Note, Velocity};
#[cfg(unix)]
pub use output::RawPort;
pub use output::{
    MidiPort, MidiSendError, MidiSystem, Output, ReconnectingPort, Smf, Unavailable, ports,
    score_timing::{ScoreMark, ScoreTiming},
};
pub use pedal::{Pedal, PedalMove};
pub use player::{NoteEvent, NoteEventKind, Player, PressureTarget};
pub use schedule::Schedule;
pub use velocity::{UnknownCurve, VelocityCurve};
