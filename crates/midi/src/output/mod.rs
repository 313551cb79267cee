//! Where messages go: a port or a file.
//!
//! An output is owned by one [`Player`](crate::Player), which may block; none is for the tick.

mod port;
mod ports;
#[cfg(unix)]
mod raw;
mod reconnecting;
mod smf;
mod system;
mod watch;

use std::io;
use std::path::PathBuf;

use documents::shown;

pub use port::MidiPort;
pub use ports::Unavailable;
pub(crate) use ports::{CLIENT, look_for_sequencer};
#[cfg(unix)]
pub use raw::RawPort;
pub use reconnecting::{MidiSystem, ReconnectingPort};
pub use smf::Smf;
pub use system::ports;
pub(crate) use system::refused;

use crate::message::Message;

/// A destination of timed messages.
pub trait Output {
    /// Sends `message`, which belongs to time `at` (s since the host started).
    ///
    /// # Errors
    ///
    /// If the message is lost.
    fn send(&mut self, at: f64, message: Message) -> Result<(), MidiSendError>;

    /// Looks after the connection at time `now` (s), if there is one; called a few times a second.
    ///
    /// # Errors
    ///
    /// If the destination is away.
    fn poll(&mut self, now: f64) -> Result<(), MidiSendError> {
        let _ = now;
        Ok(())
    }

    /// Brings what was sent to safety; may be called again, and sending may go on after it.
    ///
    /// # Errors
    ///
    /// If something could not be brought to safety; nothing is lost by trying again.
    fn finish(&mut self) -> Result<(), MidiSendError>;
}

/// Why a message did not arrive.
#[derive(Debug, thiserror::Error)]
pub enum MidiSendError {
    /// The port has vanished or does not accept; it is tried again by itself.
    #[error("MIDI port \"{port}\" is away: it is connected again when it is back")]
    Away {
        /// Name of the port.
        port: String,
    },
    /// The time of a message is not a number.
    #[error("a message at {at} s cannot be recorded: its time is not a finite number")]
    NoSuchTime {
        /// The time that was given (s).
        at: f64,
    },
    /// The program that holds the port and the notes does not take messages.
    #[error("the MIDI guardian is gone, {reason}: another one is started with the next message")]
    NoGuardian { reason: String },
    /// The recording could not be written.
    #[error(
        "{} could not be written ({source}), and its {messages} messages are lost with this run: \
         make room or choose another file, then run again", shown(.path)
    )]
    Write {
        path: PathBuf,
        /// Messages recorded so far.
        messages: usize,
        /// What the system said.
        source: io::Error,
    },
}

impl<O: Output + ?Sized> Output for Box<O> {
    fn send(&mut self, at: f64, message: Message) -> Result<(), MidiSendError> {
        (**self).send(at, message)
    }

    fn poll(&mut self, now: f64) -> Result<(), MidiSendError> {
        (**self).poll(now)
    }

    fn finish(&mut self) -> Result<(), MidiSendError> {
        (**self).finish()
    }
}
