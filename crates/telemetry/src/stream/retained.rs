//! Retained messages: every client gets the last one, however late it connects.

use crate::{KEYS, Update};

/// Slot of the status, after those of the keys' voices.
const STATUS: u16 = 100;

/// Returns the slot of a retained message, where it replaces the one before: the catalogue and the
/// status have a slot, and each key's voice.
pub(crate) fn retained_slot(update: &Update) -> Option<u16> {
    match update {
        Update::Catalogue(_) => Some(0),
        Update::Status(_) => Some(STATUS),
        Update::Voice(voice) => {
            let key = u16::try_from(voice.key).ok();
            key.filter(|key| usize::from(*key) < KEYS).map(|key| key + 1)
        }
        Update::Overview(_)
        | Update::Block(_)
        | Update::State(..)
        | Update::Event(_)
        | Update::Ticks(_)
        | Update::Deadlines(_)
        | Update::Links(_)
        | Update::Midi(_)
        | Update::Log(_) => None,
    }
}

/// Log lines that a server keeps for clients that connect later.
const LOG_LINES: u64 = 100;

/// Returns the slot of the log line with this number: it replaces the oldest kept line.
pub(crate) fn log_slot(number: u64) -> u16 {
    u16::try_from(number % LOG_LINES).map_or(u16::MAX, |place| STATUS + 1 + place)
}
