//! The loop in real time: sleeps until due, polls, measures.

use std::sync::atomic::{AtomicBool, Ordering};

use hdrhistogram::Histogram;
use scheduler::deadline::{Counters, Ledger, MissCause, Outcome, TickTimes};
use scheduler::port::{KeyBus, TickObserver};
use scheduler::safety::FADE;
use scheduler::tick::{Scheduler, TickReport};
use scheduler::time::{Nanos, Timetable};

use super::clock;
use super::pool::{self, ThreadedLanes, WaitLimit};

pub use hdrhistogram::CreationError;

/// Longest time that a histogram resolves (ns); longer ones count as this.
const LONGEST: u64 = 1_000_000_000;

/// Significant digits of a histogram: 0.1 %.
const DIGITS: u8 = 3;

/// Objects that a tick uses.
#[derive(Debug)]
pub struct Assembly<'a, B, O> {
    pub scheduler: &'a mut Scheduler,
    pub bus: &'a mut B,
    pub lanes: &'a mut ThreadedLanes,
    pub observer: &'a mut O,
}

/// End of a run: the first condition that holds.
#[derive(Clone, Copy, Debug)]
pub struct Until<'a> {
    /// Checked before each tick.
    pub stop: &'a AtomicBool,
    /// Number of ticks, run or skipped; `None` for no limit.
    pub ticks: Option<u64>,
}

impl Until<'_> {
    pub(super) fn reached(&self, ticks: u64) -> bool {
        self.ticks.is_some_and(|limit| limit <= ticks) || self.stop.load(Ordering::Acquire)
    }
}

/// One tick as measured by the loop.
#[derive(Clone, Copy, Debug)]
pub struct TickTiming {
    pub report: TickReport,
    pub times: TickTimes,
    pub outcome: Outcome,
    /// `true` if voices waited although less than half of the tick's time was used: a bug.
    pub is_starved: bool,
}

fn is_starved(report: &TickReport, times: &TickTimes) -> bool {
    let slack = times.deadline.since(times.due).as_u64();
    0 < report.voices.waited && 2 * times.work.as_u64() < slack
}

const MAX_PAUSES: usize = 1000;

/// Sequence of lost ticks.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Pause {
    /// First tick after the lost ones.
    pub tick: u64,
    pub lost: u64,
}

/// Measurements of a run, in memory allocated before it.
#[derive(Debug)]
pub struct Timings {
    /// Woken − due of the tick that was slept for, run or skipped (ns).
    pub lateness: Histogram<u64>,
    /// Time from samples received to forces sent and observed (ns of host time).
    pub turnaround: Histogram<u64>,
    /// CPU time of the tick by its threads' clocks (ns).
    pub work: Histogram<u64>,
    /// Turns that were not ready in time and were held.
    pub late_turns: u64,
    /// Misses of ticks without time because simulated keys made up for skipped ticks.
    pub by_simulated_keys: u64,
    pub pauses: Vec<Pause>,
    /// Evaluations of ticks that missed their deadlines by own work.
    evaluations: Histogram<u64>,
    most_in_time: u64,
    ledger: Ledger,
}

impl Timings {
    /// Returns empty timings.
    ///
    /// # Errors
    /// If the histograms cannot be built, which their constants rule out.
    pub fn new() -> Result<Self, CreationError> {
        Ok(Self {
            lateness: histogram()?,
            turnaround: histogram()?,
            work: histogram()?,
            late_turns: 0,
            by_simulated_keys: 0,
            pauses: Vec::with_capacity(MAX_PAUSES),
            evaluations: histogram()?,
            most_in_time: 0,
            ledger: Ledger::default(),
        })
    }

    pub const fn counters(&self) -> Counters {
        self.ledger.counters()
    }

    /// Returns the misses by own work of ticks with no more evaluations than one that was in time,
    /// before or after: by counts that no machine changes, the model did not take that time.
    pub fn unexplained(&self) -> u64 {
        self.evaluations.count_between(0, self.most_in_time)
    }

    /// Records a tick that was woken `lateness` after the due time of the one slept for.
    fn enter(&mut self, lateness: Nanos, report: &TickReport, times: &TickTimes) -> Outcome {
        self.lateness.saturating_record(lateness.as_u64());
        self.turnaround.saturating_record(times.turnaround().as_u64());
        self.work.saturating_record(times.work.as_u64());
        self.late_turns += u64::from(report.voices.late);
        if 0 < report.skipped && self.pauses.len() < MAX_PAUSES {
            self.pauses.push(Pause { tick: report.tick, lost: report.skipped });
        }
        let outcome = self.ledger.enter(times, report.skipped);
        let evaluations = u64::from(report.voices.work.evaluations());
        match outcome {
            Outcome::Met => self.most_in_time = self.most_in_time.max(evaluations),
            Outcome::Missed(MissCause::OwnWork) => self.evaluations.saturating_record(evaluations),
            Outcome::Missed(MissCause::WokenLate | MissCause::Preempted) => {
                self.by_simulated_keys += u64::from(times.is_late_by_simulated_keys());
            }
        }
        outcome
    }
}

/// Returns a histogram of fixed size from a nanosecond to a second.
///
/// # Errors
/// Never for these bounds.
pub fn histogram() -> Result<Histogram<u64>, CreationError> {
    Histogram::new_with_bounds(1, LONGEST, DIGITS)
}

/// Returns a scheduler on the heap with slew limit `slew` (N/s) towards a voice; not for the tick.
#[expect(clippy::large_stack_frames, reason = "once, at set-up, on its way to the heap")]
pub fn scheduler(timetable: Timetable, slew: f64) -> Box<Scheduler> {
    Box::new(Scheduler::new(timetable, slew))
}

/// Runs ticks as they become due, the next one at `start`, and passes each to `watch`.
///
/// # Real-time
/// Allocates, locks and logs nothing; `watch` must not either.
pub fn run<B: KeyBus, O: TickObserver>(
    assembly: &mut Assembly<'_, B, O>,
    start: Nanos,
    until: Until<'_>,
    timings: &mut Timings,
    mut watch: impl FnMut(&TickTiming),
) {
    assembly.scheduler.resume_at(start);
    let mut ticks = 0;
    while !until.reached(ticks) {
        let slept_for = assembly.scheduler.next_due();
        clock::sleep_until(slept_for);
        if let Some((report, times)) = tick(assembly) {
            let lateness = times.woken.since(slept_for);
            let outcome = timings.enter(lateness, &report, &times);
            let is_starved = is_starved(&report, &times);
            watch(&TickTiming { report, times, outcome, is_starved });
            ticks += 1 + report.skipped;
        }
    }
}

/// Disarms all keys and runs ticks, unmeasured, until they feel the safe force.
pub fn ramp_down<B: KeyBus, O: TickObserver>(assembly: &mut Assembly<'_, B, O>) {
    assembly.scheduler.disarm();
    let fade_ticks = assembly.scheduler.timetable().period().ticks_in(FADE);
    // One more than the fade: its first tick holds.
    for _ in 0..=fade_ticks {
        clock::sleep_until(assembly.scheduler.next_due());
        tick(assembly);
    }
}

fn tick<B: KeyBus, O: TickObserver>(
    assembly: &mut Assembly<'_, B, O>,
) -> Option<(TickReport, TickTimes)> {
    let Assembly { scheduler, bus, lanes, observer } = assembly;
    let (woken, cpu_before) = (clock::monotonic(), clock::thread_cpu());
    lanes.set_patience(patience(scheduler.timetable(), scheduler.deadline(woken)));
    let report = scheduler.poll(woken, *bus, *lanes, *observer)?;
    let (finished, cpu) = (clock::monotonic(), clock::thread_cpu().since(cpu_before));
    let (due, deadline) = (report.due, report.deadline);
    let work = lanes.work_of_tick(cpu);
    scheduler.note_work(work);
    let simulated = bus.simulated_work();
    Some((report, TickTimes { due, deadline, woken, finished, work, simulated }))
}

const fn patience(timetable: Timetable, deadline: Nanos) -> WaitLimit {
    let period = timetable.period().span(1);
    let reserve = Nanos::new(period.as_u64() / pool::RESERVE);
    WaitLimit::Until { time: deadline.before(reserve), share: period.since(reserve) }
}

#[cfg(test)]
mod tests {
    use scheduler::lane::LaneReport;
    use scheduler::safety::SafetyReport;
    use scheduler::voice::VoiceWork;

    use super::*;

    /// Links, telemetry and page faults take time that no evaluation explains.
    #[test]
    fn a_tick_that_worked_too_long_is_own_work_however_quick_as_many_evaluations_once_were() {
        let mut timings = Timings::new().unwrap();
        let mut enter = |tick: u64, work: u64, derivatives: u32| {
            let due = Nanos::from_millis(tick);
            let finished = due.after(Nanos::from_micros(work));
            let deadline = due.after(Nanos::from_millis(1));
            let work = Nanos::from_micros(work);
            let simulated = Nanos::ZERO;
            let times = TickTimes { due, deadline, woken: due, finished, work, simulated };
            let work = VoiceWork { derivatives, guards: 100, events: 0, ..VoiceWork::NONE };
            let voices = LaneReport { work, ..LaneReport::default() };
            let safety = SafetyReport::default();
            let report = TickReport { tick, due, deadline, skipped: 0, voices, safety };
            timings.enter(Nanos::ZERO, &report, &times)
        };
        let own_work = Outcome::Missed(MissCause::OwnWork);
        assert_eq!(enter(0, 1500, 400), own_work);
        assert_eq!(enter(1, 30, 400), Outcome::Met);
        assert_eq!(enter(2, 1500, 400), own_work);
        assert_eq!(enter(3, 1500, 401), own_work);
        let counts = (timings.counters().missed_own_work, timings.unexplained());
        assert_eq!(counts, (3, 2), "more evaluations than ever in time explain the other one");
    }
}
