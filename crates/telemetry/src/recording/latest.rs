//! The last catalogue and the last voice of every key, without which nothing can be understood.

use std::collections::BTreeMap;

use prost::Message as _;

use super::raw::Raw;
use crate::{Topic, Voice};

/// The last catalogue and the last voice of every key.
#[derive(Clone, Debug, Default)]
pub(super) struct Latest {
    catalogue: Option<Raw>,
    voices: BTreeMap<u32, Raw>,
    bytes: usize,
    /// When the newest of them was made (ns since 1970).
    newest: u64,
}

impl Latest {
    /// Remembers `raw` if it is one of these.
    pub(super) fn note(&mut self, raw: &Raw) {
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

    fn change(&mut self, new: &Raw, old: Option<Raw>) {
        self.newest = self.newest.max(new.made);
        self.bytes += new.bytes.len();
        self.bytes -= old.map_or(0, |old| old.bytes.len());
    }

    /// They, said again at `at` (ns since 1970), or as soon as that is later than they were made:
    /// by this they are told from what is said for the first time.
    pub(super) fn again(&self, at: u64) -> impl Iterator<Item = Raw> {
        let at = at.max(self.newest.saturating_add(1));
        self.catalogue.iter().chain(self.voices.values()).map(move |raw| Raw { at, ..raw.clone() })
    }

    /// How much it holds (B).
    pub(super) const fn bytes(&self) -> usize {
        self.bytes
    }
}
