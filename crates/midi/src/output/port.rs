//! A MIDI port of the system: an existing one, or a virtual one of our own.

use std::io;
use std::path::Path;

use super::Unavailable;
use super::ports::CLIENT;
use super::reconnecting::ReconnectingPort;
use super::system::{System, WantedPort};
use super::{MidiSendError, Output};
use crate::message::Message;

/// Sends to a MIDI port at once; the times of messages only pace the reconnection.
///
/// A port that vanishes is connected again, at most one attempt a second. It first gets note-offs
/// for what it may still sound. Until a loss is noticed, within a second, messages are lost.
#[derive(Debug)]
pub struct MidiPort(ReconnectingPort<System>);

impl MidiPort {
    /// Connects to the first port whose name contains `name`, ignoring case.
    ///
    /// # Errors
    /// There is no MIDI or no such port; lists the ports and the remedy.
    pub fn connect(name: &str) -> Result<Self, Unavailable> {
        let system = System::new(WantedPort::Existing(name.to_owned()));
        ReconnectingPort::connect(system, name.to_owned()).map(Self)
    }

    /// Creates a port called "letoff", to which other programs connect.
    ///
    /// # Errors
    /// There is no MIDI, or the system has no virtual ports (Windows).
    pub fn create() -> Result<Self, Unavailable> {
        let system = System::new(WantedPort::Virtual);
        ReconnectingPort::connect(system, CLIENT.to_owned()).map(Self)
    }

    /// Keeps a ledger in `folder`: see [`ReconnectingPort::keep_ledger`].
    pub fn keep_ledger(&mut self, folder: &Path) -> io::Result<()> {
        self.0.keep_ledger(folder)
    }
}

impl Output for MidiPort {
    fn send(&mut self, at: f64, message: Message) -> Result<(), MidiSendError> {
        self.0.send(at, message)
    }

    fn poll(&mut self, now: f64) -> Result<(), MidiSendError> {
        self.0.poll(now)
    }

    fn finish(&mut self) -> Result<(), MidiSendError> {
        self.0.finish()
    }
}
