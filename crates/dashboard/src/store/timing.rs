//! Durations of ticks, tick by tick.

use telemetry::Ticks;

use super::journal::Journal;

const KEPT: usize = 60_000;

/// Outcome of a tick, with the cause of a miss.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TickOutcome {
    InTime,
    WokenLate,
    Preempted,
    OwnWork,
}

impl TickOutcome {
    pub const ALL: [Self; 4] = [Self::InTime, Self::WokenLate, Self::Preempted, Self::OwnWork];

    const fn of(outcome: u8) -> Self {
        match outcome {
            0 => Self::InTime,
            1 => Self::WokenLate,
            2 => Self::Preempted,
            _ => Self::OwnWork,
        }
    }

    pub const fn text(self) -> &'static str {
        match self {
            Self::InTime => "in time",
            Self::WokenLate => "woken late",
            Self::Preempted => "preempted",
            Self::OwnWork => "own work",
        }
    }
}

/// Times of one tick.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Timed {
    pub tick: u64,
    /// Time from due to woken (µs).
    pub lateness: f32,
    /// Time from samples in to forces out (µs).
    pub turnaround: f32,
    /// CPU time (µs).
    pub work: f32,
    pub cause: TickOutcome,
}

/// The newest ticks with their times.
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

    pub fn ticks(&self) -> &Journal<Timed> {
        &self.ticks
    }
}
