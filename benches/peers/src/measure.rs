//! Nanoseconds of a run, repeated within one process.
//!
//! It is the thread's CPU time that counts: on a shared machine others take caches and
//! clock rate from all codes alike, but not whole time slices from some.

use std::time::Duration;

use rustix::time::{ClockId, clock_gettime};

use crate::entry::Run;
use crate::log::Log;

/// One timing is at least this long, so that reading the clock, 0.3 µs, does not count.
const BATCH: Duration = Duration::from_micros(100);

/// A run longer than this is timed once a round only.
const LONG: Duration = Duration::from_millis(300);

/// Times `run` for about `budget` and returns the time of one run (ns), once per batch.
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
        // Only runs that were judged right are timed: they cannot fail now.
        let _ = run(std::hint::black_box(&mut *log));
    }
    now().saturating_sub(start)
}

/// CPU time of this thread.
fn now() -> Duration {
    Duration::try_from(clock_gettime(ClockId::ThreadCPUTime)).unwrap_or_default()
}

fn nanoseconds(duration: Duration) -> f64 {
    duration.as_secs_f64() * 1e9
}

/// The median of `values`, and their minimum.
pub(crate) fn median_and_minimum(values: &[f64]) -> Option<(f64, f64)> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let minimum = *sorted.first()?;
    Some((sorted[sorted.len() / 2], minimum))
}
