//! Bare timer thread, to compare the tick with.
//!
//! It runs beside the tick, with the same period and priority, between the tick's due times.
//! Lateness in both is due to the machine; lateness only in the tick is due to this program.

use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;

use hdrhistogram::Histogram;
use scheduler::time::{Nanos, Timetable};

use super::run;
use super::stolen::stolen;
use super::thread::{SchedulingPolicy, ThreadPlan};
use super::{clock, memory};

/// A running bare timer thread.
#[derive(Debug)]
pub struct Baseline {
    stop: Arc<AtomicBool>,
    thread: JoinHandle<BaselineTiming>,
    /// Time stolen from all processors before the thread began (s).
    stolen: Option<f64>,
}

/// Measurements of the bare timer.
#[derive(Debug)]
pub struct BaselineTiming {
    /// Woken − due (ns).
    pub lateness: Histogram<u64>,
    pub standing: SchedulingPolicy,
    /// Time that a hypervisor took from all processors in the run (s), if the kernel counts it.
    pub stolen: Option<f64>,
    period: Nanos,
}

impl BaselineTiming {
    /// Counts wake-ups later than a period less the usual `work` (ns): too late for any tick.
    pub fn stops(&self, work: &Histogram<u64>) -> u64 {
        let spare = self.period.as_u64().saturating_sub(work.value_at_quantile(0.5));
        self.lateness.count_between(spare + 1, u64::MAX)
    }
}

impl Baseline {
    /// Starts a thread that sleeps until half a period after each due time of `timetable`.
    ///
    /// # Errors
    /// If the system provides no thread.
    pub fn start(timetable: Timetable, plan: ThreadPlan) -> io::Result<Self> {
        let lateness = run::histogram().map_err(io::Error::other)?;
        let stop = Arc::new(AtomicBool::new(false));
        let asked = Arc::clone(&stop);
        let period = timetable.period().span(1);
        let thread =
            std::thread::Builder::new().name("letoff-baseline".into()).spawn(move || {
                let standing = plan.ask(0);
                memory::prefault_stack();
                let lateness = measure(timetable, lateness, &asked);
                BaselineTiming { lateness, standing, stolen: None, period }
            })?;
        Ok(Self { stop, thread, stolen: stolen() })
    }

    /// Stops the thread, within a period, and returns its measurements; `None` if it panicked.
    pub fn stop(self) -> Option<BaselineTiming> {
        self.stop.store(true, Ordering::Release);
        let measured = self.thread.join().ok()?;
        let stolen = stolen().zip(self.stolen).map(|(after, before)| after - before);
        Some(BaselineTiming { stolen, ..measured })
    }
}

fn measure(
    timetable: Timetable,
    mut lateness: Histogram<u64>,
    stop: &AtomicBool,
) -> Histogram<u64> {
    let half = Nanos::new(timetable.period().span(1).as_u64() / 2);
    let mut tick = 0;
    loop {
        let due = timetable.due(tick).after(half);
        clock::sleep_until(due);
        let woken = clock::monotonic();
        lateness.saturating_record(woken.since(due).as_u64());
        if stop.load(Ordering::Acquire) {
            return lateness;
        }
        // Like the tick: a beat that was slept through is skipped.
        tick = timetable.newest(woken.before(half)).unwrap_or(tick).max(tick) + 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stop_is_longer_than_what_a_usual_tick_has_to_spare() {
        let [mut lateness, mut work] = [(); 2].map(|()| run::histogram().unwrap());
        for (micros, n) in [(20, 96), (550, 1), (650, 2), (7000, 1)] {
            lateness.saturating_record_n(1000 * micros, n);
        }
        for micros in [300, 400, 900] {
            work.saturating_record(1000 * micros);
        }
        let standing = SchedulingPolicy { policy: String::new(), advice: Vec::new() };
        let period = Nanos::from_millis(1);
        let timing = BaselineTiming { lateness, standing, stolen: None, period };
        assert_eq!(timing.stops(&work), 3);
    }
}
