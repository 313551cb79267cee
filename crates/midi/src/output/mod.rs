//! Destinations of messages: a port or a file.
//!
//! One [`Player`](crate::Player), which may block, owns an output; none is for the tick.

mod port;
mod ports;
#[cfg(unix)]
mod raw;
mod reconnecting;
pub mod score_timing;
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

/// Destination of timed messages.
pub trait Output {
    /// Sends `message`, which belongs to time `at` (s since the host started); an error loses it.
    fn send(&mut self, at: f64, message: Message) -> Result<(), MidiSendError>;

    /// Checks the connection at time `now` (s), if there is one; called a few times a second.
    ///
    /// # Errors
    /// The destination is away.
    fn poll(&mut self, now: f64) -> Result<(), MidiSendError> {
        let _ = now;
        Ok(())
    }

    /// Makes the sent messages durable; may be called again, and sending may continue after it.
    ///
    /// # Errors
    /// Something is not durable; nothing is lost by another try.
    fn finish(&mut self) -> Result<(), MidiSendError>;
}

/// Reason why a message did not arrive.
#[derive(Debug, thiserror::Error)]
pub enum MidiSendError {
    /// The port has vanished or does not accept; the output retries by itself.
    #[error("MIDI port \"{port}\" is away: it is connected again when it is back")]
    Away {
        /// Name of the port.
        port: String,
    },
    /// The time of a message is not finite.
    #[error("a message at {at} s cannot be recorded: its time is not a finite number")]
    NoSuchTime {
        /// The given time (s).
        at: f64,
    },
    #[error("the MIDI guardian is gone, {reason}: another one is started with the next message")]
    NoGuardian { reason: String },
    #[error(
        "{} could not be written ({source}), and its {messages} messages are lost with this run: \
         make room or choose another file, then run again", shown(.path)
    )]
    Write {
        path: PathBuf,
        /// Messages recorded so far.
        messages: usize,
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
