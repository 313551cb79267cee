//! The loop from end to end with toy voices; no assertion depends on timing.

use std::num::NonZeroUsize;
use std::sync::atomic::AtomicBool;

use scheduler::deadline::Outcome;
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::{FinishedTick, KeyBus, TickObserver};
use scheduler::time::{Nanos, Period, Timetable};
use scheduler::voice::{Voice, VoiceOutput};

use super::baseline::Baseline;
use super::pool::{BoxedVoice, ThreadedLanes};
use super::run::{Assembly, Timings, Until, ramp_down, run};
use super::thread::ThreadPlan;
use super::{clock, virtual_time};

const HZ: u32 = 10_000;

struct Spring;

impl Voice for Spring {
    fn tick(&mut self, _tick: u64, sample: &KeySample, turn: &mut VoiceOutput) {
        turn.force = 500.0 * sample.position;
    }

    fn reset(&mut self, _sample: &KeySample) {}
}

/// Keys that are held down 5 mm; records the sent forces.
struct HeldKeys {
    sent: Vec<(u64, u64)>,
}

impl KeyBus for HeldKeys {
    fn receive(&mut self, _tick: u64, samples: &mut [KeySample; KEYS]) {
        *samples = [KeySample::fresh(0.005); KEYS];
    }

    fn send(&mut self, tick: u64, forces: &[f64; KEYS], _slopes: &[KeySlope; KEYS]) {
        self.sent.push((tick, forces[60].to_bits()));
    }
}

struct Nobody;

impl TickObserver for Nobody {
    fn observe(&mut self, _seen: &FinishedTick<'_>) {}
}

fn timetable(start: Nanos) -> Timetable {
    Timetable::new(start, Period::from_hz(HZ).unwrap())
}

fn with_assembly(
    n_lanes: usize,
    test: impl FnOnce(&mut Assembly<'_, HeldKeys, Nobody>),
) -> Vec<(u64, u64)> {
    let voices = (0..KEYS).map(|key| (key, Box::new(Spring) as BoxedVoice)).collect();
    let n_lanes = NonZeroUsize::new(n_lanes).unwrap();
    let (mut lanes, _swaps) =
        ThreadedLanes::start(voices, n_lanes, &ThreadPlan::default()).unwrap();
    let mut scheduler = super::run::scheduler(timetable(Nanos::ZERO), f64::INFINITY);
    let mut bus = HeldKeys { sent: Vec::new() };
    test(&mut Assembly {
        scheduler: &mut scheduler,
        bus: &mut bus,
        lanes: &mut lanes,
        observer: &mut Nobody,
    });
    bus.sent
}

static NEVER: AtomicBool = AtomicBool::new(false);

fn ticks(n: u64) -> Until<'static> {
    Until { stop: &NEVER, ticks: Some(n) }
}

#[test]
fn virtual_time_skips_nothing_and_does_not_know_how_many_lanes_there_are() {
    let run = |n_lanes| {
        with_assembly(n_lanes, |assembly| {
            virtual_time::run(assembly, ticks(500), |report| assert_eq!(report.skipped, 0));
        })
    };
    let one = run(1);
    assert_eq!(one.last(), Some(&(499, 2.5_f64.to_bits())));
    assert_eq!(run(3), one);
}

#[test]
fn a_run_that_is_told_to_stop_stops_before_the_next_tick() {
    let stop = AtomicBool::new(true);
    let until = Until { stop: &stop, ticks: None };
    assert_eq!(with_assembly(1, |assembly| virtual_time::run(assembly, until, |_| {})), []);
}

#[test]
fn every_tick_of_a_run_in_real_time_is_measured_and_accounted_for() {
    for n_lanes in [1, 2] {
        let mut timings = Timings::new().unwrap();
        let (mut seen, mut missed, mut last) = (0, 0, 0);
        with_assembly(n_lanes, |assembly| {
            let start = clock::monotonic().after(Nanos::from_millis(1));
            run(assembly, start, ticks(30), &mut timings, |pulse| {
                assert!(pulse.times.due <= pulse.times.woken);
                assert_eq!(
                    pulse.outcome == Outcome::Met,
                    pulse.times.finished <= pulse.times.deadline
                );
                seen += 1;
                missed += u64::from(pulse.outcome != Outcome::Met);
                last = pulse.report.tick;
            });
        });
        let counters = timings.counters();
        assert_eq!(seen, counters.ticks);
        assert!(counters.ticks + counters.skipped >= 30, "{counters:?}");
        assert_eq!(counters.missed, missed + counters.skipped);
        assert_eq!(counters.ticks + counters.skipped, last + 1);
        for histogram in [&timings.lateness, &timings.turnaround, &timings.work] {
            assert_eq!(histogram.len(), seen);
        }
    }
}

#[test]
fn a_ramp_ends_at_the_safe_force() {
    let sent = with_assembly(1, |assembly| {
        virtual_time::run(assembly, ticks(300), |_| {});
        assembly.scheduler.resume_at(clock::monotonic());
        ramp_down(assembly);
    });
    let zero = 0.0_f64.to_bits();
    assert!(sent[299].1 != zero, "there was a force");
    assert_eq!(sent.last().map(|(_tick, force)| *force), Some(zero));
}

#[test]
fn the_bare_timer_records_one_beat_at_least() {
    let baseline = Baseline::start(timetable(clock::monotonic()), ThreadPlan::default()).unwrap();
    let measured = baseline.stop().unwrap();
    assert!(!measured.lateness.is_empty());
}
