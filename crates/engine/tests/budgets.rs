//! The real pool, scheduler and loop under disturbances: no voice waits while there is time.
//!
//! Voices use processor time by their thread's clock, so other programs do not affect the results;
//! a hypervisor does, so voices measure how long it lets them wait.
#![expect(clippy::unwrap_used, reason = "a test may stop here")]

use std::cell::Cell;
use std::num::NonZeroUsize;
use std::ops::{ControlFlow, Range};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use engine::realtime::clock;
use engine::realtime::pool::{BoxedVoice, ThreadedLanes, VoiceChange, VoiceSwaps};
use engine::realtime::run::{Assembly, Timings, Until, run, scheduler};
use engine::realtime::thread::ThreadPlan;
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::{FinishedTick, KeyBus, TickObserver};
use scheduler::time::{Nanos, Period, Timetable};
use scheduler::voice::{TurnRules, Voice, VoiceFault, VoiceInternals, VoiceOutput};
use scheduler::work::VoiceKind;

const HZ: u32 = 1000;

/// Ticks after a disturbance until no voice may wait.
const RECOVERY: u64 = 100;

const DISTURBED: usize = 40;

/// Time of a thread (ns) that neither a voice nor the pool uses between two looks at the clock.
/// A hypervisor's theft looks like it: a thread's clock continues meanwhile.
const STALL: f64 = 100_000.0;

/// Force (N) of a turn during or before which the machine stalled, and of all others.
const STALLED: f64 = 2.0;
const UNDISTURBED: f64 = 1.0;

thread_local! {
    /// When this thread's last turn ended, and its tick.
    static LAST_TURN: Cell<Option<(u64, Nanos)>> = const { Cell::new(None) };
}

/// Uses `time` of the calling thread's processor time (ns), and returns `false` if the machine
/// stalled since the thread's last turn of this tick.
fn burn(tick: u64, time: f64) -> bool {
    let start = clock::thread_cpu();
    let last_end = LAST_TURN.get().filter(|(of, _)| *of == tick).map_or(start, |(_, end)| end);
    let mut end = start;
    let mut longest = start.since(last_end).as_u64();
    while (end.since(start).as_u64() as f64) < time {
        std::hint::spin_loop();
        let now = clock::thread_cpu();
        longest = longest.max(now.since(end).as_u64());
        end = now;
    }
    LAST_TURN.set(Some((tick, end)));
    (longest as f64) < STALL
}

type Burden = Arc<dyn Fn(u64) -> (u32, f64) + Send + Sync>;

struct Burner {
    kind: u32,
    burden: Burden,
    limit: u32,
}

impl Voice for Burner {
    fn tick(&mut self, tick: u64, _sample: &KeySample, turn: &mut VoiceOutput) {
        let (units, time) = (self.burden)(tick);
        let is_capped = self.limit < units;
        let done = units.min(self.limit);
        let time = time * f64::from(done) / f64::from(units.max(1));
        turn.force = if burn(tick, time) { UNDISTURBED } else { STALLED };
        if is_capped {
            turn.fail(VoiceFault::Capped { handled: 0 });
        }
        turn.work.units = done;
    }

    fn restrict(&mut self, rules: TurnRules) {
        self.limit = rules.limit.early;
    }

    fn internals(&self) -> VoiceInternals<'_> {
        VoiceInternals { kind: VoiceKind(self.kind), memory: None }
    }

    fn reset(&mut self, _sample: &KeySample) {}
}

fn burner(kind: u32, burden: impl Fn(u64) -> (u32, f64) + Send + Sync + 'static) -> BoxedVoice {
    Box::new(Burner { kind, burden: Arc::new(burden), limit: u32::MAX })
}

struct StillKeys;

impl KeyBus for StillKeys {
    fn receive(&mut self, _tick: u64, samples: &mut [KeySample; KEYS]) {
        *samples = [KeySample::fresh(0.0); KEYS];
    }

    fn send(&mut self, _tick: u64, _forces: &[f64; KEYS], _slopes: &[KeySlope; KEYS]) {}
}

#[derive(Default)]
struct TurnLog {
    ticks: usize,
    /// Ticks and the number of voices that waited in each.
    waits: Vec<(u64, usize)>,
    failed: Vec<(u64, u32)>,
    muted: Vec<u64>,
    /// Ticks in which the machine stalled.
    stalls: Vec<Range<u64>>,
}

impl TickObserver for TurnLog {
    fn observe(&mut self, seen: &FinishedTick<'_>) {
        self.ticks += 1;
        let waited = seen.turns.iter().filter(|turn| turn.waited).count();
        if 0 < waited {
            self.waits.push((seen.tick, waited));
        }
        if seen.turns.iter().any(|turn| !turn.waited && UNDISTURBED < turn.force) {
            self.stalls.push(seen.tick..seen.tick + 1);
        }
        let turn = &seen.turns[DISTURBED];
        match turn.fault {
            Some(VoiceFault::Muted) => self.muted.push(seen.tick),
            Some(_) => self.failed.push((seen.tick, turn.work.units)),
            None => {}
        }
    }
}

impl TurnLog {
    #[track_caller]
    fn check(&self, disturbances: &[Range<u64>], situation: &str) {
        let is_expected = |tick: &u64| {
            let mut all = disturbances.iter().chain(&self.stalls);
            all.any(|it| it.start <= *tick && *tick < it.end + RECOVERY)
        };
        let wrong = self.waits.iter().filter(|(tick, _)| !is_expected(tick));
        let wrong: Vec<_> = wrong.take(5).collect();
        assert!(wrong.is_empty(), "{situation}: tick and voices that waited: {wrong:?}");
    }
}

/// Runs `voices` in real time for `ticks`, or until `between`, called after each tick, breaks.
fn log(
    voices: Vec<(usize, BoxedVoice)>,
    n_lanes: usize,
    ticks: u64,
    mut between: impl FnMut(u64, &mut VoiceSwaps) -> ControlFlow<()>,
) -> TurnLog {
    let n_lanes = NonZeroUsize::new(n_lanes).unwrap();
    let (mut lanes, mut swaps) =
        ThreadedLanes::start(voices, n_lanes, &ThreadPlan::default()).unwrap();
    let timetable = Timetable::new(Nanos::ZERO, Period::from_hz(HZ).unwrap());
    let mut scheduler = scheduler(timetable, f64::INFINITY);
    let (mut bus, mut log) = (StillKeys, TurnLog::default());
    let mut assembly = Assembly {
        scheduler: &mut scheduler,
        bus: &mut bus,
        lanes: &mut lanes,
        observer: &mut log,
    };
    let start = clock::monotonic().after(Nanos::from_millis(5));
    let stop = AtomicBool::new(false);
    let until = Until { stop: &stop, ticks: Some(ticks) };
    let mut timings = Timings::new().unwrap();
    run(&mut assembly, start, until, &mut timings, |timing| {
        assert!(!timing.is_starved, "tick {}", timing.report.tick);
        stop.fetch_or(between(timing.report.tick, &mut swaps).is_break(), Ordering::Relaxed);
    });
    log
}

/// Returns voices of 2 units of 500 ns on all keys; the disturbed one has `burden`.
fn light_but(
    burden: impl Fn(u64) -> (u32, f64) + Send + Sync + 'static,
) -> Vec<(usize, BoxedVoice)> {
    let light = |key| (key, burner(1, |_tick| (2, 1000.0)));
    let mut voices: Vec<_> = (0..KEYS).map(light).collect();
    voices[DISTURBED].1 = burner(1, burden);
    voices
}

const fn left_alone(_tick: u64, _swaps: &mut VoiceSwaps) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

#[test]
fn one_slow_tick_in_a_quiet_moment_starves_no_voice() {
    for n_lanes in 1..=2 {
        for (index, slow) in [0.5e6, 0.6e6, 1e6, 2e6, 5e6, 20e6].into_iter().enumerate() {
            let at = [0, 250][index % 2];
            let voices = light_but(move |tick| (2, if tick == at { slow } else { 1000.0 }));
            let log = log(voices, n_lanes, 500, left_alone);
            log.check(
                std::slice::from_ref(&(at..at + 1)),
                &format!("{n_lanes} lanes, {slow} ns in tick {at}"),
            );
        }
    }
}

#[test]
fn a_machine_that_is_slow_for_a_while_starves_no_voice_when_it_is_quick_again() {
    for n_lanes in 1..=2 {
        // At the start all takes ten times as long, and later twice as long as fits.
        let factor = |tick| match tick {
            0..40 => 10.0,
            300..400 => 25.0,
            _ => 1.0,
        };
        let voice = |key| (key, burner(1, move |tick| (2, 1000.0 * factor(tick))));
        let log = log((0..KEYS).map(voice).collect(), n_lanes, 900, left_alone);
        log.check(&[0..40, 300..400], &format!("{n_lanes} lanes"));
        let is_overloaded = |(tick, _): &&(u64, usize)| (300..400).contains(tick);
        let waits = log.waits.iter().filter(is_overloaded).count();
        assert!(0 < waits, "2.2 ms of work in a tick on {n_lanes} lanes, and no voice waited");
    }
}

#[test]
fn a_voice_that_fails_in_each_turn_gets_a_tenth_of_its_lane_and_makes_none_wait() {
    for n_lanes in 1..=2 {
        let voices = light_but(|tick| if 200 <= tick { (40_000, 20e6) } else { (2, 1000.0) });
        let log = log(voices, n_lanes, 500, left_alone);
        log.check(&[], &format!("{n_lanes} lanes"));
        let (failed, muted) = (log.failed.first().unwrap().0, log.muted.first().unwrap());
        assert!(log.failed.len() <= 4 && muted - failed <= 50, "{:?}", log.failed);
        // A unit takes 500 ns and a turn some time to begin, so no more than 180 units fit.
        for (tick, units) in &log.failed {
            assert!(*units <= 180, "{units} units in tick {tick}");
        }
    }
}

#[test]
fn a_thousand_changes_of_instruments_starve_no_voice() {
    /// Units and time (ns) of a turn of each instrument.
    const TURNS: [(u32, f64); 4] = [(2, 1000.0), (400, 2000.0), (1, 2500.0), (20, 500.0)];
    for n_lanes in 1..=2 {
        let mut changes: u32 = 0;
        let mut change = |tick: u64, swaps: &mut VoiceSwaps| {
            if tick < 100 {
                return ControlFlow::Continue(());
            }
            if 1000 <= changes {
                return ControlFlow::Break(());
            }
            let kind = changes % 30;
            let turn = TURNS[kind as usize % TURNS.len()];
            let voice = burner(kind, move |_tick| turn);
            let is_succeeding = changes.is_multiple_of(3);
            let change = if is_succeeding {
                VoiceChange::Succeed(voice)
            } else {
                VoiceChange::Replace(voice)
            };
            changes += u32::from(swaps.send((changes as usize * 37) % KEYS, change).is_ok());
            ControlFlow::Continue(())
        };
        let log = log(light_but(|_tick| (2, 1000.0)), n_lanes, 100_000, &mut change);
        assert_eq!(changes, 1000);
        log.check(&[], &format!("{n_lanes} lanes"));
    }
}

#[test]
fn a_voice_for_which_a_lane_has_no_time_waits_its_turn() {
    let voice = |key| (key, burner(1, |_tick| (2, 40_000.0)));
    let log = log((0..KEYS).map(voice).collect(), 1, 200, left_alone);
    // 0.9 ms are 22 turns.
    let most = log.waits.iter().map(|(_, waited)| *waited).max().unwrap();
    assert!((KEYS - 26..KEYS).contains(&most), "{most} wait");
    assert!(0.9 * log.ticks as f64 <= log.waits.len() as f64, "in {} ticks", log.waits.len());
}
