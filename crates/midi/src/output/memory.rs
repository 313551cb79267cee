//! An output that remembers, for tests and for assessing a performance.

use super::{MidiSendError, Output};
use crate::message::Message;

/// Keeps every message with its time.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct MessageRecorder {
    messages: Vec<(f64, Message)>,
}

impl MessageRecorder {
    /// What was sent so far, each with its time (s since the host started).
    pub fn messages(&self) -> &[(f64, Message)] {
        &self.messages
    }
}

impl Output for MessageRecorder {
    fn send(&mut self, at: f64, message: Message) -> Result<(), MidiSendError> {
        self.messages.push((at, message));
        Ok(())
    }

    fn finish(&mut self) -> Result<(), MidiSendError> {
        Ok(())
    }
}
