//! Subscriptions by topic, which the host queries before it computes anything.

use std::sync::atomic::{AtomicU32, AtomicU64, Ordering};

use crate::{KEYS, Topic, stream::protocol::place};

#[derive(Debug)]
pub(super) struct Following {
    counts: [AtomicU32; Topic::COMMON.len() + 2 * KEYS],
    begun: AtomicU64,
}

impl Default for Following {
    fn default() -> Self {
        let counts = [const { AtomicU32::new(0) }; Topic::COMMON.len() + 2 * KEYS];
        Self { counts, begun: AtomicU64::new(0) }
    }
}

// Counts are relaxed: one message more or less as a client connects makes no difference.
impl Following {
    pub(super) fn has(&self, topic: Topic) -> bool {
        self.counts.get(place(topic)).is_some_and(|count| count.load(Ordering::Relaxed) > 0)
    }

    pub(super) fn add(&self, topic: Topic) {
        if let Some(count) = self.counts.get(place(topic)) {
            count.fetch_add(1, Ordering::Relaxed);
        }
        // After the count: a thread that sees this sees the count, too.
        self.begun.fetch_add(1, Ordering::Release);
    }

    pub(super) fn begun(&self) -> u64 {
        self.begun.load(Ordering::Acquire)
    }

    pub(super) fn remove(&self, topic: Topic) {
        if let Some(count) = self.counts.get(place(topic)) {
            count.fetch_sub(1, Ordering::Relaxed);
        }
    }

    pub(super) fn keys(&self) -> u128 {
        let keys = (0..=u8::MAX).take(KEYS);
        let followed =
            keys.filter(|key| self.has(Topic::Block(*key)) || self.has(Topic::State(*key)));
        followed.fold(0, |mask, key| mask | 1 << key)
    }
}
