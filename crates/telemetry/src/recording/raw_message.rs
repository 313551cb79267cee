use super::error::RecordError;
use crate::{Topic, Update, topic::TopicDecodeError};

/// A message as it is stored in a file.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct RawMessage {
    /// Time under which it is recorded (ns since 1970).
    pub(super) at: u64,
    /// Time at which it was made (ns since 1970), earlier than `at` if it is repeated.
    pub(super) made: u64,
    pub(super) topic: Topic,
    pub(super) bytes: Vec<u8>,
}

impl RawMessage {
    pub(super) fn of(at: u64, update: &Update) -> Result<Self, RecordError> {
        let topic = update.topic().ok_or_else(|| RecordError::NoSuchKey { key: key(update) })?;
        Ok(Self { at, made: at, topic, bytes: update.encode() })
    }

    pub(super) fn update(&self) -> Result<Update, TopicDecodeError> {
        Update::decode(self.topic, &self.bytes)
    }
}

fn key(update: &Update) -> u32 {
    match update {
        Update::Block(block) => block.key,
        Update::State(key, _) => u32::from(*key),
        Update::Catalogue(_)
        | Update::Voice(_)
        | Update::Overview(_)
        | Update::Event(_)
        | Update::Ticks(_)
        | Update::Deadlines(_)
        | Update::Links(_)
        | Update::Midi(_)
        | Update::Log(_)
        | Update::Status(_) => 0,
    }
}
