//! Retained messages: every client gets the last one, however late it connects.

use crate::{KEYS, Update};

/// Returns the slot of a retained message, where it replaces the one before: the catalogue has a
/// slot, and each key's voice.
pub(crate) fn retained_slot(update: &Update) -> Option<u16> {
    match update {
        Update::Catalogue(_) => Some(0),
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
