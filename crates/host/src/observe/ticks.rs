//! When ticks were done, column by column.

use telemetry::Ticks;

use super::pulses::{PulseRow, number};
use super::short;

/// Collects ticks, and their times where those are known.
#[derive(Debug, Default)]
pub(super) struct TicksBuilder {
    ticks: Ticks,
}

impl TicksBuilder {
    /// A tick was run; `pulse` are its times, if a clock was looked at.
    pub(super) fn push(&mut self, tick: u64, pulse: Option<&PulseRow>) {
        let it = &mut self.ticks;
        if it.after.is_empty() {
            it.tick = tick;
        }
        it.after.push(u32::try_from(tick - it.tick).unwrap_or(u32::MAX));
        let Some(pulse) = pulse else { return };
        it.lateness.push(microseconds(pulse.lateness));
        it.turnaround.push(microseconds(pulse.turnaround));
        it.work.push(microseconds(pulse.work));
        it.outcome.push(number(pulse.outcome));
        it.evaluations.push(pulse.evaluations);
    }

    /// The ticks so far, if there are any; the next ones begin.
    pub(super) fn take(&mut self) -> Option<Ticks> {
        (!self.ticks.after.is_empty()).then(|| std::mem::take(&mut self.ticks))
    }
}

fn microseconds(nanoseconds: u64) -> f32 {
    short(nanoseconds as f64 / 1e3)
}
