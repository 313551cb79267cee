use tokio_tungstenite::tungstenite::Bytes;

use crate::{Topic, Update};

/// A message on its way to clients, encoded once for all of them.
#[derive(Clone, Debug)]
pub(super) struct StreamSample {
    pub(super) topic: Topic,
    /// Its slot, if every client gets the slot's last sample, and its order in the slot.
    pub(super) retained: Option<(u16, u64)>,
    /// Time at which it was made (ns since 1970).
    pub(super) at: u64,
    pub(super) payload: Bytes,
}

impl StreamSample {
    /// Encodes `update` from `at` (ns since 1970).
    pub(super) fn new(topic: Topic, at: u64, update: &Update) -> Self {
        Self { topic, retained: None, at, payload: update.encode().into() }
    }

    /// Returns this sample as the last one of `slot`, which every client gets.
    pub(super) const fn retained(mut self, slot: u16, order: u64) -> Self {
        self.retained = Some((slot, order));
        self
    }
}
