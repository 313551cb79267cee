//! A message on its way to clients, encoded once for all of them.

use tokio_tungstenite::tungstenite::Bytes;

use crate::{Topic, Update};

/// A message on its way to clients.
#[derive(Clone, Debug)]
pub(super) struct StreamSample {
    pub(super) topic: Topic,
    /// Of those whose last one every client gets: which one it is, and how many there were before.
    pub(super) latch: Option<(u16, u64)>,
    /// When it was made (ns since 1970).
    pub(super) at: u64,
    pub(super) payload: Bytes,
}

impl StreamSample {
    /// `update`, encoded.
    pub(super) fn new(topic: Topic, at: u64, update: &Update) -> Self {
        Self { topic, latch: None, at, payload: update.encode().into() }
    }

    /// The same, as one whose last one every client gets.
    pub(super) fn latched(self, number: u16, order: u64) -> Self {
        Self { latch: Some((number, order)), ..self }
    }
}
