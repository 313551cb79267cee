use std::sync::atomic::{AtomicU64, Ordering};

/// A set of keys in atomics, for one writer: bit n of both words together is key n.
///
/// # Real-time
/// Two loads or stores; the two words of a set may be of two ticks.
#[derive(Debug, Default)]
pub struct AtomicKeySet([AtomicU64; 2]);

impl AtomicKeySet {
    /// Replaces the set; bit n is key n.
    pub fn store(&self, keys: u128) {
        for (word, bits) in self.0.iter().zip(words(keys)) {
            word.store(bits, Ordering::Relaxed);
        }
    }

    pub fn insert(&self, keys: u128) {
        for (word, bits) in self.0.iter().zip(words(keys)) {
            if bits != 0 {
                word.fetch_or(bits, Ordering::Relaxed);
            }
        }
    }

    /// Returns the set; bit n is key n.
    pub fn load(&self) -> u128 {
        let [low, high] = self.0.each_ref().map(|word| u128::from(word.load(Ordering::Relaxed)));
        low | high << 64
    }

    pub fn keys(&self) -> impl Iterator<Item = u8> + use<> {
        let keys = self.load();
        (0..128).filter(move |key| keys >> key & 1 == 1)
    }
}

fn words(keys: u128) -> [u64; 2] {
    const LOW: u128 = u64::MAX as u128;
    [keys & LOW, keys >> 64].map(|bits| u64::try_from(bits).unwrap_or_default())
}
