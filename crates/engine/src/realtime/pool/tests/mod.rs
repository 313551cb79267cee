//! No test depends on timing: a lane that must be late waits for the test.

use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::time::Duration;

use super::worker::boxed_array;
use super::*;
use crate::realtime::thread::ThreadPlan;
use scheduler::motion::{KeyEvent, KeySample, Loudness, Moment};
use scheduler::observation::{FollowedKeys, VoiceObservation};
use scheduler::overload::Simplifications;
use scheduler::port::TickRules;
use scheduler::voice::{Voice, VoiceFault, VoiceOutput};

/// Voice with a force that depends on every sample since the start, and varying work.
struct Echo {
    key: usize,
    sum: f64,
}

impl Voice for Echo {
    fn tick(&mut self, tick: u64, sample: &KeySample, turn: &mut VoiceOutput) {
        self.sum = 0.99 * self.sum + sample.position * (1.0 + self.key as f64).sqrt();
        turn.force = self.sum.sin() + tick as f64;
        let part = tick / 50 + self.key as u64;
        turn.work.units = 10 * u32::try_from(part % 7).unwrap().pow(3);
        turn.idle = part.is_multiple_of(3);
    }

    fn observe(&self, seen: &mut VoiceObservation) {
        seen.snapshot.show(&[self.sum]);
    }

    fn reset(&mut self, sample: &KeySample) {
        self.sum = sample.position;
    }
}

/// Waits for the other side of a test, which never answers if the test has failed.
fn wait_for(other: &Receiver<()>) -> Result<(), RecvTimeoutError> {
    other.recv_timeout(Duration::from_secs(20))
}

/// Voice that reports its start `at` a tick, then waits for the test, and strikes.
struct Blocking {
    at: u64,
    begun: Sender<()>,
    go_on: Receiver<()>,
    last: u64,
}

impl Voice for Blocking {
    fn tick(&mut self, tick: u64, _sample: &KeySample, turn: &mut VoiceOutput) {
        (self.last, turn.force) = (tick, 100.0 + tick as f64);
        if tick == self.at {
            self.begun.send(()).unwrap();
            wait_for(&self.go_on).unwrap();
            let moment = Moment { tick, theta: 0.5 };
            turn.events
                .push(moment, KeyEvent::Strike { speed: 2.0, loudness: Loudness::of_hammer(2.0) });
        }
    }

    fn observe(&self, seen: &mut VoiceObservation) {
        seen.snapshot.show(&[self.last as f64]);
    }

    fn reset(&mut self, _sample: &KeySample) {}
}

struct Turn<F>(F);

impl<F: FnMut(u64, &mut VoiceOutput)> Voice for Turn<F> {
    fn tick(&mut self, tick: u64, _sample: &KeySample, turn: &mut VoiceOutput) {
        (self.0)(tick, turn);
    }

    fn reset(&mut self, _sample: &KeySample) {}
}

fn voice(turn: impl FnMut(u64, &mut VoiceOutput) + Send + 'static) -> BoxedVoice {
    Box::new(Turn(turn))
}

fn panicking() -> BoxedVoice {
    voice(|tick, turn| {
        assert_ne!(tick, 3, "a bug");
        turn.force = 5.0;
    })
}

struct Dropping(Sender<()>);

impl Voice for Dropping {
    fn tick(&mut self, _tick: u64, _sample: &KeySample, turn: &mut VoiceOutput) {
        turn.force = 7.0;
    }

    fn reset(&mut self, _sample: &KeySample) {}
}

impl Drop for Dropping {
    fn drop(&mut self) {
        self.0.send(()).unwrap_or_default();
    }
}

fn echoes() -> Vec<(usize, BoxedVoice)> {
    (0..KEYS).map(|key| (key, Box::new(Echo { key, sum: 0.0 }) as BoxedVoice)).collect()
}

fn echoes_but(key: usize, voice: impl Voice + Send + 'static) -> Vec<(usize, BoxedVoice)> {
    let mut voices = echoes();
    voices[key].1 = Box::new(voice);
    voices
}

fn start(voices: Vec<(usize, BoxedVoice)>, n_lanes: usize) -> (ThreadedLanes, VoiceSwaps) {
    ThreadedLanes::start(voices, NonZeroUsize::new(n_lanes).unwrap(), &ThreadPlan::default())
        .unwrap()
}

struct Run {
    lanes: ThreadedLanes,
    turns: Box<[VoiceOutput; KEYS]>,
    observed: Box<[VoiceObservation; KEYS]>,
    followed: FollowedKeys,
}

impl Run {
    fn new(lanes: ThreadedLanes) -> Self {
        let followed = FollowedKeys::ALL;
        Self { lanes, turns: boxed_array(), observed: boxed_array(), followed }
    }

    fn tick(&mut self, tick: u64) -> &[VoiceOutput; KEYS] {
        let position = |key: usize| 0.01 * ((tick as f64) * 0.3 + key as f64).sin();
        let samples = std::array::from_fn(|key| KeySample::fresh(position(key)));
        let Self { lanes, turns, observed, followed } = self;
        let rules = TickRules { simplified: Simplifications::NONE, hz: 1000 };
        let input = TickInput { tick, samples: &samples, followed: *followed, rules };
        lanes.run(&input, &mut TickOutput { turns, observed });
        &self.turns
    }

    fn seen(&self, key: usize) -> (u32, f64) {
        (self.observed[key].ran, self.observed[key].snapshot.state[0])
    }

    fn force_bits(&mut self, tick: u64) -> Vec<u64> {
        self.tick(tick).iter().map(|turn| turn.force.to_bits()).collect()
    }
}

#[test]
fn any_number_of_lanes_gives_the_same_bits() {
    let [mut one, mut two, mut three] =
        [1, 2, 3].map(|n_lanes| Run::new(start(echoes(), n_lanes).0));
    for tick in (0..300).chain(310..400) {
        let expected = one.force_bits(tick);
        assert_eq!(two.force_bits(tick), expected, "tick {tick}");
        assert_eq!(three.force_bits(tick), expected, "tick {tick}");
        assert_eq!(two.observed, one.observed, "tick {tick}");
        assert_eq!(three.observed, one.observed, "tick {tick}");
    }
    assert_eq!(three.lanes.counters(), LaneCounters::default());
}

/// No patience: a share that is not back at the first check is late.
const NONE: WaitLimit = WaitLimit::Until { time: Nanos::ZERO, share: Nanos::ZERO };

const ELSEWHERE: usize = 40;
const INLINE: usize = 39;

#[test]
fn the_keys_of_these_tests_are_on_the_lanes_they_say() {
    assert_eq!((lane_of(ELSEWHERE, 2), lane_of(INLINE, 2)), (1, 0));
}

#[test]
fn a_late_lane_holds_its_forces_and_its_notes_arrive_with_the_next_tick() {
    let (begun, has_begun) = channel();
    let (go, go_on) = channel();
    let voice = Blocking { at: 1, begun, go_on, last: 0 };
    let (lanes, _swaps) = start(echoes_but(ELSEWHERE, voice), 2);
    let mut run = Run::new(lanes);
    run.tick(0);

    run.lanes.set_patience(NONE);
    let turn = run.tick(1)[ELSEWHERE];
    assert!(turn.late && (turn.force - 100.0).abs() == 0.0, "{turn:?}");
    assert!(!run.turns[INLINE].late, "lane 0 is not held up");
    wait_for(&has_begun).unwrap();

    run.lanes.set_patience(WaitLimit::Endless);
    go.send(()).unwrap();
    let turn = run.tick(2)[ELSEWHERE];
    assert!(!turn.late && (turn.force - 102.0).abs() == 0.0, "{turn:?}");
    assert_eq!(turn.events.as_slice().len(), 1);
    assert_eq!(turn.events.as_slice()[0].0, Moment { tick: 1, theta: 0.5 });
    assert!(run.tick(3)[ELSEWHERE].events.is_empty());
    // Keys at rest waited behind it: their share had passed, or was run late as well.
    let LaneCounters { late, late_own_work, passed } = run.lanes.counters();
    assert!(late == 1 && 0 < late_own_work && late_own_work + passed <= 2);
}

fn steady(work: u32) -> BoxedVoice {
    voice(move |_tick, turn| (turn.force, turn.work.units) = (1.0, work))
}

#[test]
fn a_late_lane_costs_keys_at_rest_before_those_that_move() {
    let (begun, has_begun) = channel();
    let (go, go_on) = channel();
    let mut voices: Vec<_> = (0..KEYS).map(|key| (key, steady(0))).collect();
    // At rest, it reports tick 2 and waits.
    voices[ELSEWHERE].1 = voice(move |tick, turn| {
        turn.idle = true;
        if tick == 2 {
            begun.send(()).unwrap();
            wait_for(&go_on).unwrap();
        }
    });
    // It holds lane 0 at tick 2 until the other one reports.
    voices[INLINE].1 = voice(move |tick, _turn| {
        if tick == 2 {
            wait_for(&has_begun).unwrap();
        }
    });
    let mut run = Run::new(start(voices, 2).0);
    run.tick(0);
    run.tick(1);
    run.lanes.set_patience(NONE);
    let turns = run.tick(2);
    let late: Vec<_> = (0..KEYS).filter(|key| turns[*key].late).collect();
    assert_eq!(late, [ELSEWHERE]);
    go.send(()).unwrap();
    run.lanes.set_patience(WaitLimit::Endless);
    assert!(run.tick(3).iter().all(|turn| !turn.late));
    assert_eq!(run.lanes.counters().late, 1);
}

#[test]
fn lanes_become_equal_wherever_the_work_is() {
    for n_lanes in 2..=4 {
        let work =
            |key| if lane_of(key, n_lanes) == 1 { 50 + u32::try_from(key).unwrap() } else { 0 };
        let voices = (0..KEYS).map(|key| (key, steady(work(key)))).collect();
        let mut run = Run::new(start(voices, n_lanes).0);
        for tick in 0..200 {
            assert!(run.tick(tick).iter().all(|turn| (turn.force - 1.0).abs() == 0.0));
        }
        let ThreadedLanes { inline, remotes, measured, .. } = &run.lanes;
        let others = remotes.iter().map(|lane| lane.load(measured).unwrap());
        let loads: Vec<_> = others.chain([measured.of(inline)]).collect();
        let (most, least) = (loads.iter().max().unwrap(), loads.iter().min().unwrap());
        assert!(8 * (most - least) <= *most, "{n_lanes} lanes: {loads:?}");
    }
}

#[test]
fn a_lane_that_was_held_up_joins_the_present_and_tells_which_ticks_it_ran() {
    let (begun, has_begun) = channel();
    let (go, go_on) = channel();
    let (lanes, _swaps) =
        start(echoes_but(ELSEWHERE, Blocking { at: 1, begun, go_on, last: 0 }), 2);
    let mut run = Run::new(lanes);
    run.tick(0);
    assert_eq!(run.seen(ELSEWHERE), (0b1, 0.0));
    run.lanes.set_patience(NONE);
    run.tick(1);
    wait_for(&has_begun).unwrap();
    for tick in 2..10 {
        assert!(run.tick(tick)[ELSEWHERE].late, "tick {tick}");
        assert_eq!(run.seen(ELSEWHERE), (0, 0.0), "tick {tick}: as it was");
    }
    // Tick 1 is still running, and 2 to 9 were not sent.
    go.send(()).unwrap();
    run.lanes.set_patience(WaitLimit::Endless);
    let turn = run.tick(10)[ELSEWHERE];
    assert!(!turn.late && (turn.force - 110.0).abs() == 0.0, "{turn:?}");
    assert_eq!(turn.events.as_slice().len(), 1, "the strike of tick 1");
    assert_eq!(run.seen(ELSEWHERE), (0b110_0000_0001, 10.0), "ticks 0, 1 and 10 were run");
    assert_eq!(run.lanes.counters().late, 9);
}

#[test]
fn a_lane_that_is_late_again_tells_which_ticks_its_events_are_of() {
    let (go, go_on) = channel();
    // It strikes in each tick but the first, once the test lets it.
    let gated = voice(move |tick, turn| {
        if 0 < tick {
            // At its end the test sends nothing more.
            wait_for(&go_on).unwrap_or_default();
            let strike = KeyEvent::Strike { speed: 2.0, loudness: Loudness::of_hammer(2.0) };
            turn.events.push(Moment { tick, theta: 0.5 }, strike);
        }
    });
    // The only voice, or it would be moved to a lane with less work.
    let (lanes, _swaps) = start(vec![(ELSEWHERE, gated)], 2);
    let mut run = Run::new(lanes);
    run.tick(0);
    run.lanes.set_patience(NONE);
    // Dropped before the lanes, which wait for their voices.
    let go = go;
    assert!(run.tick(1)[ELSEWHERE].late);
    let (mut tick, mut last) = (1, 0);
    for _ in 0..3 {
        go.send(()).unwrap();
        loop {
            tick += 1;
            let turn = run.tick(tick)[ELSEWHERE];
            let ran = run.seen(ELSEWHERE).0;
            let of = turn.events.as_slice().first().map(|(at, _strike)| at.tick);
            last = of.unwrap_or(last);
            // All is known if it came back, run or passed, or was in time; otherwise nothing.
            let newest = 1_u32.checked_shl(u32::try_from(tick - last).unwrap()).unwrap_or(0);
            let newer = newest.wrapping_sub(1);
            assert!(ran == 0 && of.is_none() || ran & (newest | newer) == newest | 1, "{ran:b}");
            if of.is_some() {
                break;
            }
            thread::yield_now();
        }
    }
}

#[test]
fn a_key_that_is_not_followed_is_not_looked_at() {
    for n_lanes in 1..=2 {
        let mut run = Run::new(start(echoes(), n_lanes).0);
        run.followed = FollowedKeys::new(1 << ELSEWHERE, 0);
        run.tick(3);
        let nothing = VoiceObservation::default();
        let shown = (0..KEYS).filter(|key| run.observed[*key] != nothing);
        assert_eq!(shown.collect::<Vec<_>>(), [ELSEWHERE], "{n_lanes} lanes");
    }
}

#[test]
fn a_voice_that_panics_is_faulty_for_good_and_alone() {
    for n_lanes in 1..=3 {
        let mut healthy = Run::new(start(echoes(), 1).0);
        let mut voices = echoes();
        voices[ELSEWHERE].1 = panicking();
        let mut run = Run::new(start(voices, n_lanes).0);
        for tick in 0..10 {
            let expected = healthy.force_bits(tick);
            let forces = run.force_bits(tick);
            let same = |key: &usize| expected[*key] == forces[*key];
            assert!((0..KEYS).filter(|&key| key != ELSEWHERE).all(|key| same(&key)));
            let fault = (3 <= tick).then_some(VoiceFault::Panicked);
            assert_eq!(run.turns[ELSEWHERE].fault, fault, "tick {tick}, {n_lanes} lanes");
        }
    }
}

#[test]
fn a_voice_is_replaced_between_ticks_and_freed_outside() {
    for n_lanes in 1..=3 {
        let (dropped, was_dropped) = channel();
        let (lanes, mut swaps) = start(echoes_but(ELSEWHERE, Dropping(dropped)), n_lanes);
        let mut run = Run::new(lanes);
        run.tick(0);
        assert!((run.tick(1)[ELSEWHERE].force - 7.0).abs() == 0.0);

        swaps
            .send(ELSEWHERE, VoiceChange::Replace(Box::new(Echo { key: ELSEWHERE, sum: 0.0 })))
            .unwrap();
        let turn = run.tick(2)[ELSEWHERE];
        assert!(turn.fresh && (turn.force - 7.0).abs() != 0.0, "{turn:?}");
        assert!(was_dropped.try_recv().is_err(), "freed by the tick");
        assert_eq!(swaps.drain(), 1);
        assert!(was_dropped.try_recv().is_ok());
    }
}

#[test]
fn a_whole_instrument_is_replaced_in_some_ticks_and_the_next_waits_for_it_not_for_ever() {
    let (lanes, mut swaps) = start(echoes(), 2);
    let mut run = Run::new(lanes);
    let every_key: Vec<_> = (0..KEYS).collect();
    assert_eq!(swaps.wait_for_room(&every_key), Ok(()));
    for key in 0..KEYS {
        swaps.send(key, VoiceChange::Replace(panicking())).unwrap();
    }
    let refused = swaps.wait_for_room(&[3]).unwrap_err();
    assert!(refused.contains("too many voices are waiting"), "no tick runs: {refused}");
    let waiting = thread::spawn(move || swaps.wait_for_room(&every_key));
    // After tick 3, at which this voice would panic; four keys at a time.
    for tick in 4..26 {
        run.tick(tick);
    }
    assert!(run.tick(26).iter().all(|turn| (turn.force - 5.0).abs() == 0.0));
    assert_eq!(waiting.join().unwrap(), Ok(()));
}

#[test]
fn a_voice_for_a_key_without_one_is_given_back() {
    let (_lanes, mut swaps) = start(vec![(3, panicking())], 1);
    let refused = swaps.send(4, VoiceChange::Replace(panicking()));
    assert!(matches!(refused, Err(Refused::NoSuchVoice(_))));
    assert!(swaps.send(88, VoiceChange::Replace(panicking())).is_err());
    for _ in 0..KEYS {
        swaps.send(3, VoiceChange::Replace(panicking())).unwrap();
    }
    assert!(matches!(swaps.send(3, VoiceChange::Replace(panicking())), Err(Refused::Full(_))));
}

#[test]
fn work_is_the_ticks_own_without_waiting_and_what_a_slower_lane_took_more() {
    let (mut lanes, _swaps) = start(echoes(), 1);
    let nanos = Nanos::new;
    lanes.times = LaneTimes { inline: nanos(30), waiting: nanos(50), slowest: nanos(45) };
    assert_eq!(lanes.work_of_tick(nanos(100)), nanos(50 + 15));
    lanes.times.slowest = nanos(20);
    assert_eq!(lanes.work_of_tick(nanos(100)), nanos(50));
}
