//! Conversion of ticks to seconds.

use midly::{Fps, MetaMessage, Timing, TrackEventKind};

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
    per_quarter: Option<f64>,
}

impl Map {
    /// Returns the map of a file with `timing`; `None` if a tick has no length.
    pub(super) fn new(timing: Timing) -> Option<Self> {
        let (tick, per_quarter) = match timing {
            Timing::Metrical(ticks) if ticks.as_int() > 0 => {
                let per_quarter = f64::from(ticks.as_int());
                (DEFAULT_QUARTER / per_quarter, Some(per_quarter))
            }
            Timing::Timecode(fps, subframes) if subframes > 0 => {
                (1.0 / (frames_per_second(fps) * f64::from(subframes)), None)
            }
            Timing::Metrical(_) | Timing::Timecode(..) => return None,
        };
        Some(Self { since: (0, 0.0), tick, per_quarter })
    }

    /// Returns the time of `tick` (s); ticks before the last change of tempo are at that change.
    pub(super) fn seconds(&self, tick: u64) -> f64 {
        let (from, at) = self.since;
        at + tick.saturating_sub(from) as f64 * self.tick
    }

    /// Follows a tempo event; ignores a tempo of zero, after which all would sound at once.
    pub(super) fn follow(&mut self, tick: u64, event: TrackEventKind<'_>) {
        let Some(per_quarter) = self.per_quarter else { return };
        if let TrackEventKind::Meta(MetaMessage::Tempo(us)) = event
            && us.as_int() > 0
        {
            self.since = (tick, self.seconds(tick));
            self.tick = f64::from(us.as_int()) * 1e-6 / per_quarter;
        }
    }
}

fn frames_per_second(fps: Fps) -> f64 {
    match fps {
        Fps::Fps24 => 24.0,
        Fps::Fps25 => 25.0,
        Fps::Fps29 => 30_000.0 / 1001.0,
        Fps::Fps30 => 30.0,
    }
}
