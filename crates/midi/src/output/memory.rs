//! An output that remembers, for tests and for assessing a performance.

use super::{Output, SendError};
use crate::message::Message;

/// Keeps every message with its time.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Memory {
    messages: Vec<(f64, Message)>,
}

impl Memory {
    /// What was sent so far, each with its time [s since the host started].
    pub fn messages(&self) -> &[(f64, Message)] {
        &self.messages
    }
}

impl Output for Memory {
    fn send(&mut self, at: f64, message: Message) -> Result<(), SendError> {
        self.messages.push((at, message));
        Ok(())
    }

    fn finish(&mut self) -> Result<(), SendError> {
        Ok(())
    }
}
