//! Times of ticks: the loop's wait-free end.

use rtrb::{Consumer, Producer, RingBuffer};
use scheduler::deadline::{MissCause, Outcome};

use engine::realtime::run::TickTiming;

/// Ticks that may wait: 1 s at 1 kHz.
const TICKS: usize = 1024;

/// Times of a tick.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PulseRow {
    pub tick: u64,
    /// Time from due to woken (ns).
    pub lateness: u64,
    /// Time from samples in to forces out (ns).
    pub turnaround: u64,
    /// CPU time (ns).
    pub work: u64,
    pub outcome: Outcome,
    pub evaluations: u32,
    /// `true` if voices waited although the tick had time.
    pub is_starved: bool,
}

/// Sender of the times of ticks; those without room in the ring are dropped.
#[derive(Debug)]
pub struct Pulses(Producer<PulseRow>);

impl Pulses {
    /// Returns the loop's end and the receiver.
    pub fn new() -> (Self, Consumer<PulseRow>) {
        let (rows, out) = RingBuffer::new(TICKS);
        (Self(rows), out)
    }

    /// Sends one tick's times.
    ///
    /// # Real-time
    /// One push into a ring.
    pub fn take(&mut self, pulse: &TickTiming) {
        let (report, times) = (&pulse.report, &pulse.times);
        let work = report.voices.work;
        let _full_is_left_out = self.0.push(PulseRow {
            tick: report.tick,
            lateness: times.lateness().as_u64(),
            turnaround: times.turnaround().as_u64(),
            work: times.work.as_u64(),
            outcome: pulse.outcome,
            evaluations: work.evaluations(),
            is_starved: pulse.is_starved,
        });
    }
}

pub(super) const fn number(outcome: Outcome) -> u8 {
    match outcome {
        Outcome::Met => 0,
        Outcome::Missed(MissCause::WokenLate) => 1,
        Outcome::Missed(MissCause::Preempted) => 2,
        Outcome::Missed(MissCause::OwnWork) => 3,
    }
}

pub(super) const fn words(outcome: Outcome) -> Option<&'static str> {
    match outcome {
        Outcome::Met => None,
        Outcome::Missed(MissCause::WokenLate) => Some(
            "woken too late by the system: give the host real-time priority, or a quieter machine",
        ),
        Outcome::Missed(MissCause::Preempted) => {
            Some("interrupted by the system: give the host a processor of its own")
        }
        Outcome::Missed(MissCause::OwnWork) => Some(
            "the voices took longer than a tick: give a lower rate, more lanes or a lighter model",
        ),
    }
}
