//! The last catalogue and the last voice of every key, which all other messages need.

use std::collections::BTreeMap;

use prost::Message as _;

use super::raw_message::RawMessage;
use crate::{Topic, Voice};

/// The last catalogue and the last voice of every key.
#[derive(Clone, Debug, Default)]
pub(super) struct Latest {
    catalogue: Option<RawMessage>,
    voices: BTreeMap<u32, RawMessage>,
    bytes: usize,
    /// Time of the newest of them (ns since 1970).
    newest: u64,
}

impl Latest {
    pub(super) fn note(&mut self, raw: &RawMessage) {
        if raw.topic == Topic::Catalogue {
            let old = self.catalogue.replace(raw.clone());
            self.change(raw, old);
        }
        if raw.topic == Topic::Voices
            && let Ok(voice) = Voice::decode(raw.bytes.as_slice())
        {
            let old = self.voices.insert(voice.key, raw.clone());
            self.change(raw, old);
        }
    }

    fn change(&mut self, new: &RawMessage, old: Option<RawMessage>) {
        self.newest = self.newest.max(new.made);
        self.bytes += new.bytes.len();
        self.bytes -= old.map_or(0, |old| old.bytes.len());
    }

    /// Returns them as repeated at `at` (ns since 1970), or right after the newest was made.
    pub(super) fn repeated(&self, at: u64) -> impl Iterator<Item = RawMessage> {
        let at = at.max(self.newest.saturating_add(1));
        self.catalogue
            .iter()
            .chain(self.voices.values())
            .map(move |raw| RawMessage { at, ..raw.clone() })
    }

    pub(super) const fn bytes(&self) -> usize {
        self.bytes
    }
}
