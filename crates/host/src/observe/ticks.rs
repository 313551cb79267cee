use telemetry::Ticks;

use super::pulses::{PulseRow, number};
use super::short;

#[derive(Debug, Default)]
pub(super) struct TicksBuilder {
    ticks: Ticks,
}

impl TicksBuilder {
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

    pub(super) fn take(&mut self) -> Option<Ticks> {
        (!self.ticks.after.is_empty()).then(|| std::mem::take(&mut self.ticks))
    }
}

fn microseconds(nanoseconds: u64) -> f32 {
    short(nanoseconds as f64 / 1e3)
}
