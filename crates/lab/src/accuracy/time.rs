//! Nanoseconds of a run, as a whole and tick by tick.
//!
//! A run is deterministic, so the least time excludes other programs and the hypervisor. The mean
//! is the least of all repeats, and each tick's time is the least over the repeats of that tick.
//! Without repeats, the mean is that of the ticks of the run whose work was counted.

use std::hint::black_box;
use std::time::{Duration, Instant};

use pode::Work;

use super::{Effort, job::RunJob, observe::ObservedRun, row::Times};
use crate::scenario::Scenario;

pub(super) fn time<S: Scenario>(
    job: &RunJob<'_, S>,
    observed: &ObservedRun<S::Model>,
    effort: Effort,
) -> Times {
    let began = Instant::now();
    let mut whole = Duration::MAX;
    let (work, mut ticks) = (&observed.work, observed.ticks.clone());
    let mut repeats = 0;
    while repeats < effort.repeats || began.elapsed() < effort.budget {
        whole = whole.min(run(job, work.len()));
        run_by_ticks(job, &mut ticks);
        repeats += 1;
    }
    let reading = clock_reading();
    let ticks: Vec<f64> = ticks.iter().map(|tick| ns(tick.saturating_sub(reading))).collect();
    let whole = if repeats > 0 { ns(whole) } else { ticks.iter().sum() };
    figures(whole, &ticks, work, job.tick)
}

fn run<S: Scenario>(job: &RunJob<'_, S>, ticks: usize) -> Duration {
    let mut simulator = job.simulator();
    let began = Instant::now();
    for _ in 0..ticks {
        black_box(job.advance_alone(&mut simulator));
    }
    began.elapsed()
}

/// Runs all ticks, and reads the clock around each; keeps the least time of each tick.
fn run_by_ticks<S: Scenario>(job: &RunJob<'_, S>, least: &mut [Duration]) {
    let mut simulator = job.simulator();
    for least in least {
        let began = Instant::now();
        black_box(job.advance_alone(&mut simulator));
        *least = began.elapsed().min(*least);
    }
}

fn clock_reading() -> Duration {
    let nothing = || {
        let began = Instant::now();
        black_box(began).elapsed()
    };
    (0..1000).map(|_| nothing()).min().unwrap_or_default()
}

fn ns(duration: Duration) -> f64 {
    duration.as_secs_f64() * 1e9
}

/// Returns the means, and the worst of `ticks` of `tick` (s), by the events in each.
fn figures(whole: f64, ticks: &[f64], work: &[Work], tick: f64) -> Times {
    let most = work.iter().map(|work| work.events).max().unwrap_or(0);
    let of = |events: u32| {
        let times = ticks.iter().zip(work).filter(|(_, work)| work.events == events);
        let (sum, n) = times.fold((0.0, 0_u32), |(sum, n), (time, _)| (sum + time, n + 1));
        (n > 0).then(|| sum / f64::from(n))
    };
    Times {
        per_ms: whole / (ticks.len() as f64 * tick * 1e3),
        worst_tick: ticks.iter().copied().fold(0.0, f64::max),
        without_event: of(0),
        with_one_event: of(1),
        with_most_events: of(most).filter(|_| most > 0),
        most_events: most,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_told_apart_by_their_events() {
        let work = [0, 1, 0, 3, 1].map(|events| Work { events, ..Work::default() });
        let times = figures(1000.0, &[10.0, 50.0, 20.0, 400.0, 70.0], &work, 2e-3);
        assert!((times.per_ms - 100.0).abs() < 1e-12);
        assert!((times.worst_tick - 400.0).abs() < 1e-12);
        assert_eq!(times.without_event, Some(15.0));
        assert_eq!(times.with_one_event, Some(60.0));
        assert_eq!((times.with_most_events, times.most_events), (Some(400.0), 3));
    }

    #[test]
    fn a_run_without_events_has_no_time_for_them() {
        let times = figures(10.0, &[10.0], &[Work::default()], 1e-3);
        assert_eq!((times.with_one_event, times.with_most_events), (None, None));
    }
}
