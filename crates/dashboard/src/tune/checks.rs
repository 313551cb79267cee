//! Figures of changed keys, which the host measures once no drag is under way.

use std::collections::{BTreeMap, BTreeSet};

use telemetry::{Reply, request::KeyFigure, source::Ticket};

/// Figures of a key, and what is wrong with it.
#[derive(Clone, Debug, Default)]
pub struct CheckedKey {
    pub figures: Vec<KeyFigure>,
    pub warnings: Vec<String>,
}

/// Keys to measure, and those that were measured since their last change.
#[derive(Clone, Debug, Default)]
pub struct KeyChecks {
    due: BTreeSet<u8>,
    asked: Option<(Ticket, u8)>,
    found: BTreeMap<u8, CheckedKey>,
    /// `true` while the mouse is pressed: the change is not over.
    pub is_held: bool,
}

impl KeyChecks {
    /// Forgets what was measured, and measures the ends of a changed range.
    pub(super) fn note(&mut self, (low, high): (u8, u8)) {
        self.found.retain(|key, _| !(low..=high).contains(key));
        self.due.extend([low, high]);
    }

    pub(super) fn forget(&mut self, key: u8) {
        self.due.remove(&key);
        self.found.remove(&key);
    }

    pub(super) fn clear(&mut self) {
        *self = Self { is_held: self.is_held, ..Self::default() };
    }

    pub(super) fn outgoing(&self) -> Option<u8> {
        let is_free = !self.is_held && self.asked.is_none();
        self.due.first().copied().filter(|_| is_free)
    }

    pub(super) fn sent(&mut self, ticket: Ticket, key: u8) {
        self.due.remove(&key);
        self.asked = Some((ticket, key));
    }

    /// Takes the answer to a measurement; returns `false` if it is not one.
    pub fn answered(&mut self, ticket: Ticket, result: &Result<Reply, String>) -> bool {
        let Some((_, key)) = self.asked.take_if(|(asked, _)| *asked == ticket) else {
            return false;
        };
        // A key that was changed meanwhile is measured again.
        if self.due.contains(&key) {
            return true;
        }
        let checked = match result {
            Ok(Reply::Figures { figures, warnings, .. }) => {
                CheckedKey { figures: figures.clone(), warnings: warnings.clone() }
            }
            Ok(_) => CheckedKey::default(),
            Err(why) => CheckedKey { warnings: vec![why.clone()], ..CheckedKey::default() },
        };
        self.found.insert(key, checked);
        true
    }

    /// Returns the key that is measured now, if any.
    pub fn measuring(&self) -> Option<u8> {
        self.asked.as_ref().map(|(_, key)| *key).or(self.due.first().copied())
    }

    pub fn found(&self) -> &BTreeMap<u8, CheckedKey> {
        &self.found
    }
}
