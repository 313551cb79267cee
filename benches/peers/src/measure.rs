//! Nanoseconds of a run, repeated within one process.
//!
//! The thread's CPU time counts: other processes slow all codes alike through caches and clock
//! rate, but would take whole time slices from only some.

use std::time::Duration;

use rustix::time::{ClockId, clock_gettime};

use crate::entry::Run;
use crate::log::Log;

/// Minimum length of one timing, so that reading the clock, 0.3 µs, does not count.
const BATCH: Duration = Duration::from_micros(100);

/// Length of a run above which it is timed only once a round.
const LONG: Duration = Duration::from_millis(300);

pub(crate) fn time(run: &Run, log: &mut Log, budget: Duration) -> Vec<f64> {
    let once = batch(run, log, 1);
    if once > LONG {
        return vec![nanoseconds(once)];
    }
    let per_batch = BATCH.as_nanos().div_ceil(once.as_nanos().max(1));
    let per_batch = u32::try_from(per_batch).unwrap_or(u32::MAX);
    let start = now();
    let mut times = Vec::new();
    while times.len() < 3 || now().saturating_sub(start) < budget {
        times.push(nanoseconds(batch(run, log, per_batch)) / f64::from(per_batch));
    }
    times
}

fn batch(run: &Run, log: &mut Log, count: u32) -> Duration {
    let start = now();
    for _ in 0..count {
        log.clear();
        // Only runs that passed the judge are timed: they cannot fail now.
        let _ = run(std::hint::black_box(&mut *log));
    }
    now().saturating_sub(start)
}

fn now() -> Duration {
    Duration::try_from(clock_gettime(ClockId::ThreadCPUTime)).unwrap_or_default()
}

fn nanoseconds(duration: Duration) -> f64 {
    duration.as_secs_f64() * 1e9
}

pub(crate) fn median_and_minimum(values: &[f64]) -> Option<(f64, f64)> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let minimum = *sorted.first()?;
    Some((sorted[sorted.len() / 2], minimum))
}
