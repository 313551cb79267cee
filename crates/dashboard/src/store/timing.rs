//! When ticks were done, tick by tick.

use telemetry::Ticks;

use super::journal::Journal;

/// Ticks that are kept.
const KEPT: usize = 60_000;

/// How a tick went.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TickOutcome {
    InTime,
    /// It was woken late.
    WokenLate,
    /// Something else ran instead.
    Preempted,
    /// It had too much to do.
    OwnWork,
}

impl TickOutcome {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::InTime, Self::WokenLate, Self::Preempted, Self::OwnWork];

    const fn of(outcome: u8) -> Self {
        match outcome {
            0 => Self::InTime,
            1 => Self::WokenLate,
            2 => Self::Preempted,
            _ => Self::OwnWork,
        }
    }

    /// In words.
    pub const fn text(self) -> &'static str {
        match self {
            Self::InTime => "in time",
            Self::WokenLate => "woken late",
            Self::Preempted => "preempted",
            Self::OwnWork => "own work",
        }
    }
}

/// When a tick was done.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Timed {
    pub tick: u64,
    /// Woken after it was due (µs).
    pub lateness: f32,
    /// Samples in to forces out (µs).
    pub turnaround: f32,
    /// CPU time (µs).
    pub work: f32,
    pub cause: TickOutcome,
}

/// The newest ticks.
#[derive(Clone, Debug)]
pub struct Timing {
    ticks: Journal<Timed>,
}

impl Default for Timing {
    fn default() -> Self {
        Self { ticks: Journal::new(KEPT) }
    }
}

impl Timing {
    pub(super) fn take(&mut self, ticks: &Ticks) {
        let float = |values: &[f32], i: usize| {
            values.get(i).copied().filter(|it| it.is_finite()).unwrap_or(0.0)
        };
        if super::LAST_TICK < ticks.tick {
            return;
        }
        for (i, after) in ticks.after.iter().enumerate() {
            self.ticks.push(Timed {
                tick: ticks.tick.saturating_add((*after).into()),
                lateness: float(&ticks.lateness, i),
                turnaround: float(&ticks.turnaround, i),
                work: float(&ticks.work, i),
                cause: TickOutcome::of(ticks.outcome.get(i).copied().unwrap_or(0)),
            });
        }
    }

    /// Oldest first.
    pub fn ticks(&self) -> &Journal<Timed> {
        &self.ticks
    }
}
