//! An output that records messages.
#![expect(unreachable_pub, reason = "shared by test programs")]

use midi::{Message, MidiSendError, Output};

/// Records every message with its time.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct MessageRecorder {
    messages: Vec<(f64, Message)>,
}

impl MessageRecorder {
    /// Returns the messages, each with its time (s since the host started).
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
