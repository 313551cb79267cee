//! Summaries of all keys.

use telemetry::{KEYS, Overview};

/// Depth, force, mode and fault of a key.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct KeySummary {
    /// Largest displacement since the previous message (m).
    pub position: f32,
    /// Sent force with the largest magnitude (N).
    pub force: f32,
    pub mode: Option<u8>,
    /// Bits as in `KeyBlock.flags`.
    pub flags: u8,
    pub fault: u8,
}

impl KeySummary {
    const NOTHING: Self = Self { position: 0.0, force: 0.0, mode: None, flags: 8, fault: 0 };

    fn of(overview: &Overview, i: usize) -> Self {
        let float = |values: &[f32]| values.get(i).copied().filter(|x| x.is_finite());
        let byte = |values: &[u8]| values.get(i).copied();
        let low = float(&overview.force_min).unwrap_or(0.0);
        let high = float(&overview.force_max).unwrap_or(0.0);
        Self {
            position: float(&overview.position_max).unwrap_or(0.0),
            force: if high.abs() < low.abs() { low } else { high },
            mode: byte(&overview.mode).filter(|mode| *mode != u8::MAX),
            flags: byte(&overview.flags).unwrap_or(0),
            fault: byte(&overview.fault).unwrap_or(0),
        }
    }
}

/// Summaries of all keys, of the newest overview.
#[derive(Clone, PartialEq, Debug)]
pub struct KeySummaries {
    keys: [KeySummary; KEYS],
    pub is_known: bool,
    pub tick: u64,
    pub dropped: u64,
}

impl Default for KeySummaries {
    fn default() -> Self {
        Self { keys: [KeySummary::NOTHING; KEYS], is_known: false, tick: 0, dropped: 0 }
    }
}

impl KeySummaries {
    /// Returns the summary of a key; that of a key at rest for an invalid number.
    pub fn key(&self, key: u8) -> KeySummary {
        self.keys.get(usize::from(key)).copied().unwrap_or(KeySummary::NOTHING)
    }

    /// Returns `true` if an overview repeats the known summaries.
    pub(crate) fn shows(&self, overview: &Overview) -> bool {
        self.keys.iter().enumerate().all(|(i, summary)| *summary == KeySummary::of(overview, i))
    }

    pub(crate) fn take(&mut self, overview: &Overview) {
        self.is_known = true;
        self.tick = overview.tick;
        self.dropped = overview.dropped;
        for (i, summary) in self.keys.iter_mut().enumerate() {
            *summary = KeySummary::of(overview, i);
        }
    }
}
