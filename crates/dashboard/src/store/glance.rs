//! All keys at a glance.

use telemetry::{KEYS, Overview};

/// What a key is seen to do.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct KeySummary {
    /// Largest displacement since the message before (m).
    pub position: f32,
    /// The force sent that is farthest from none (N).
    pub force: f32,
    /// Mode, if there is one.
    pub mode: Option<u8>,
    /// Bits as in `KeyBlock.flags`.
    pub flags: u8,
    pub fault: u8,
}

impl KeySummary {
    const NOTHING: Self = Self { position: 0.0, force: 0.0, mode: None, flags: 8, fault: 0 };

    /// The `i`th key of an overview.
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

/// The newest overview.
#[derive(Clone, PartialEq, Debug)]
pub struct Glances {
    keys: [KeySummary; KEYS],
    /// Whether there was one.
    pub is_known: bool,
    /// The last tick that is in it.
    pub tick: u64,
    /// Samples that found no room on their way.
    pub dropped: u64,
}

impl Default for Glances {
    fn default() -> Self {
        Self { keys: [KeySummary::NOTHING; KEYS], is_known: false, tick: 0, dropped: 0 }
    }
}

impl Glances {
    /// The key `key`; nothing for one that is none.
    pub fn key(&self, key: u8) -> KeySummary {
        self.keys.get(usize::from(key)).copied().unwrap_or(KeySummary::NOTHING)
    }

    /// Whether an overview says of each key what is known already.
    pub(crate) fn shows(&self, overview: &Overview) -> bool {
        self.keys.iter().enumerate().all(|(i, glance)| *glance == KeySummary::of(overview, i))
    }

    /// Takes an overview.
    pub(crate) fn take(&mut self, overview: &Overview) {
        self.is_known = true;
        self.tick = overview.tick;
        self.dropped = overview.dropped;
        for (i, glance) in self.keys.iter_mut().enumerate() {
            *glance = KeySummary::of(overview, i);
        }
    }
}
