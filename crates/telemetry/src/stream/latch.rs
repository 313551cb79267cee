//! Messages of which the last one is always there.

use crate::{KEYS, Update};

/// Of messages whose last one every client gets: which one it takes the place of.
///
/// There is one catalogue, and one voice for each key.
pub(crate) fn latch(update: &Update) -> Option<u16> {
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
