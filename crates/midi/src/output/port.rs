//! A MIDI port of the system: one that exists, or a virtual one of our own.

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
/// A port that vanishes is connected again by itself, even if it was away for a moment only, at
/// most one attempt a second; it first gets note-offs for what it may still sound. Until a loss
/// is noticed, within a second, messages go nowhere.
#[derive(Debug)]
pub struct MidiPort(ReconnectingPort<System>);

impl MidiPort {
    /// Connects to the first port whose name contains `name`, in whatever case.
    ///
    /// # Errors
    ///
    /// If there is no MIDI or no such port; says which ports exist and what to do.
    pub fn connect(name: &str) -> Result<Self, Unavailable> {
        let system = System::new(WantedPort::Existing(name.to_owned()));
        ReconnectingPort::connect(system, name.to_owned()).map(Self)
    }

    /// Makes a port called "letoff", to which other programs connect.
    ///
    /// # Errors
    ///
    /// If there is no MIDI, or the system has no virtual ports (Windows).
    pub fn create() -> Result<Self, Unavailable> {
        let system = System::new(WantedPort::Virtual);
        ReconnectingPort::connect(system, CLIENT.to_owned()).map(Self)
    }

    /// Keeps a ledger in `folder`, as [`ReconnectingPort::keep_ledger`].
    ///
    /// # Errors
    /// If no file can be written in the folder.
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
