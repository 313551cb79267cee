//! Conversion of ticks to seconds.

/// Length of a quarter note before the first tempo (s): 120 a minute.
const DEFAULT_QUARTER: f64 = 0.5;

/// Times of ticks, followed from the start of a file to its end.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Map {
    /// Tick and time (s) of the last change of tempo.
    since: (u64, f64),
    /// Length of a tick from there on (s).
    tick: f64,
    /// Ticks per quarter note; `None` if ticks have a fixed length.
    pub(super) per_quarter: Option<u16>,
}

impl Map {
    /// Returns the map of a file with the header's `division`; `None` if a tick has no length.
    pub(super) fn new(division: u16) -> Option<Self> {
        let [frames, ticks] = division.to_be_bytes();
        let (tick, per_quarter) = if division < 0x8000 {
            (DEFAULT_QUARTER / f64::from(division), Some(division))
        } else {
            let frames = match frames.wrapping_neg() {
                29 => 30_000.0 / 1001.0,
                frames @ (24 | 25 | 30) => f64::from(frames),
                _ => return None,
            };
            (1.0 / (frames * f64::from(ticks)), None)
        };
        tick.is_finite().then_some(Self { since: (0, 0.0), tick, per_quarter })
    }

    /// Returns the time of `tick` (s); ticks before the last change of tempo are at that change.
    pub(super) fn seconds(&self, tick: u64) -> f64 {
        let (from, at) = self.since;
        at + tick.saturating_sub(from) as f64 * self.tick
    }

    /// Gives quarter notes a length of `quarter` (s) from `tick` on.
    pub(super) fn follow(&mut self, tick: u64, quarter: f64) {
        let Some(per_quarter) = self.per_quarter else { return };
        self.since = (tick, self.seconds(tick));
        self.tick = quarter / f64::from(per_quarter);
    }
}
