//! Times of all ticks so far, as distributions.

use hdrhistogram::Histogram;
use scheduler::deadline::{MissCause, Outcome};
use telemetry::{Deadlines, Spread};

use super::pulses::PulseRow;
use crate::report::Quantiles;
use engine::realtime::run::{CreationError, histogram};

#[derive(Debug)]
pub(super) struct DeadlinesBuilder {
    counts: Deadlines,
    lateness: Histogram<u64>,
    turnaround: Histogram<u64>,
    work: Histogram<u64>,
}

impl DeadlinesBuilder {
    pub(super) fn new() -> Result<Self, CreationError> {
        Ok(Self {
            counts: Deadlines::default(),
            lateness: histogram()?,
            turnaround: histogram()?,
            work: histogram()?,
        })
    }

    pub(super) const fn skip(&mut self, ticks: u64) {
        self.counts.skipped += ticks;
    }

    pub(super) fn push(&mut self, pulse: &PulseRow) {
        self.lateness.saturating_record(pulse.lateness);
        self.turnaround.saturating_record(pulse.turnaround);
        self.work.saturating_record(pulse.work);
        let counts = &mut self.counts;
        counts.ticks += 1;
        let Outcome::Missed(cause) = pulse.outcome else { return };
        counts.missed += 1;
        *match cause {
            MissCause::OwnWork => &mut counts.own_work,
            MissCause::WokenLate => &mut counts.woken_late,
            MissCause::Preempted => &mut counts.preempted,
        } += 1;
    }

    pub(super) fn read(&self) -> Deadlines {
        Deadlines {
            lateness: Some(spread(&self.lateness)),
            turnaround: Some(spread(&self.turnaround)),
            work: Some(spread(&self.work)),
            ..self.counts.clone()
        }
    }
}

/// Returns a histogram with doubling edges, up to the largest time (us).
fn spread(histogram: &Histogram<u64>) -> Spread {
    let Quantiles { p50, p99, p99_9, max } = Quantiles::of(histogram);
    let bins = histogram.iter_log(1_000, 2.0);
    let (edge, count) = bins
        .map(|bin| (bin.value_iterated_to() as f64 / 1e3, bin.count_since_last_iteration()))
        .unzip();
    Spread { p50, p99, p999: p99_9, max, edge, count }
}
