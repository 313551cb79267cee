//! Ticks with faults, a full ring, or a late lane.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use engine::realtime::pool::{BoxedVoice, LaneCounters, VoiceChange, WaitLimit};
use scene::KeyVoice;
use scheduler::motion::{KEYS, KeySample};
use scheduler::port::{FinishedTick, TickObserver};
use scheduler::slot::lane_of;
use scheduler::time::Nanos;
use scheduler::values::ModelValues;
use scheduler::voice::{Voice, VoiceOutput};

use crate::marking::mark_lanes;
use crate::stage::broken_sensor::BrokenSensor;
use crate::stage::{Stage, keybed, play_all, scene, voices};
use crate::tick::{Audience, WARM_UP, WATCHED, run_watched, stage};
use crate::trap;

const ELSEWHERE: usize = 42;

#[test]
fn the_key_of_these_tests_is_not_on_the_ticks_own_lane() {
    assert_eq!(lane_of(ELSEWHERE, 2), 1);
}

#[test]
fn a_voice_that_faults_leaves_the_heap_alone() {
    for n_lanes in 1..=2 {
        let watch = trap::watch();
        let scene = scene("springs", &[]);
        let mut keybed = keybed(&scene);
        play_all(&mut keybed, 4.0);
        let bus = BrokenSensor { keybed, key: ELSEWHERE, ticks: 1000..1500 };
        let mut stage = stage(&scene, bus, n_lanes);
        run_watched(&mut stage);
        assert_eq!(watch.caught(), (0, 0), "{n_lanes} lanes");
        assert_eq!(stage.observer.counters.faults.load(Ordering::Relaxed), 500);
    }
}

#[test]
fn a_full_ring_drops_and_leaves_the_heap_alone() {
    let watch = trap::watch();
    let scene = scene("springs", &[]);
    let mut bus = keybed(&scene);
    play_all(&mut bus, 4.0);
    let mut voices = voices(&scene);
    mark_lanes(&mut voices, &WATCHED);
    let mut stage = Stage::of(voices, scene.tick_hz, bus, 2).watched_by(Audience::new(2));
    run_watched(&mut stage);
    assert_eq!(watch.caught(), (0, 0));
    assert_eq!(stage.observer.ring.slots(), 2);
    assert!(100 < stage.observer.counters.dropped.load(Ordering::Relaxed));
}

#[test]
fn a_voice_that_is_replaced_is_freed_outside_the_tick() {
    const CHANGES: [fn(BoxedVoice) -> VoiceChange; 2] =
        [VoiceChange::Succeed, VoiceChange::Replace];
    let watch = trap::watch();
    let scene = scene("springs", &[]);
    let mut bus = keybed(&scene);
    play_all(&mut bus, 4.0);
    let mut stage = stage(&scene, bus, 2);
    let mut others: Vec<_> =
        voices(&scene).into_iter().filter(|(key, _)| lane_of(*key, 2) == 0).collect();
    let n_others = others.len();
    let mut replaced = 0;
    for tick in 0..=WATCHED.end {
        if WATCHED.contains(&tick) {
            if let Some((key, voice)) = others.pop() {
                // Every other one continues from the state before.
                let change = CHANGES[others.len() % 2];
                stage.swaps.send(key, change(voice)).expect("room for it");
            }
            trap::within(|| stage.tick());
            replaced += stage.swaps.drain();
        } else {
            stage.tick();
        }
    }
    assert_eq!(watch.caught(), (0, 0));
    assert_eq!(replaced, n_others);
}

struct FreshTurns(usize);

impl TickObserver for FreshTurns {
    fn observe(&mut self, seen: &FinishedTick<'_>) {
        self.0 += seen.turns.iter().filter(|turn| turn.fresh).count();
    }
}

#[test]
fn a_voice_that_is_retuned_leaves_the_heap_alone() {
    for instrument in ["grand-springs", "grand-reduced", "spring-wall"] {
        let watch = trap::watch();
        let scene = scene("springs", &[("keys.instrument", instrument)]);
        let mut bus = keybed(&scene);
        play_all(&mut bus, 4.0);
        let stage = Stage::of(voices(&scene), scene.tick_hz, bus, 1);
        let mut stage = stage.watched_by(FreshTurns(0));
        for _ in 0..WARM_UP {
            stage.tick();
        }
        stage.observer.0 = 0;
        for (key, voice) in scene.keys.iter().enumerate() {
            let KeyVoice { model, values, .. } = voice.as_ref().expect("a voice on each key");
            let values = ModelValues::new(model.id(), 1, values).expect("not too many");
            stage.swaps.send(key, VoiceChange::Retune(values)).expect("room for it");
        }
        for _ in 0..WARM_UP {
            trap::within(|| stage.tick());
        }
        assert_eq!(watch.caught(), (0, 0), "{instrument}");
        assert_eq!((stage.observer.0, stage.swaps.drain()), (KEYS, 0), "{instrument}");
    }
}

/// A voice whose lane cannot continue from tick `from` before `reached` is `until`.
struct Delayed {
    from: u64,
    until: u64,
    reached: Arc<AtomicU64>,
}

impl Voice for Delayed {
    fn tick(&mut self, tick: u64, _sample: &KeySample, turn: &mut VoiceOutput) {
        while self.from <= tick && self.reached.load(Ordering::Acquire) < self.until {
            std::thread::yield_now();
        }
        turn.force = 1.0;
    }

    fn reset(&mut self, _sample: &KeySample) {}
}

#[test]
fn a_lane_that_is_late_leaves_the_heap_alone() {
    let watch = trap::watch();
    let scene = scene("springs", &[]);
    let mut bus = keybed(&scene);
    play_all(&mut bus, 4.0);
    let reached = Arc::new(AtomicU64::new(0));
    let mut voices = voices(&scene);
    let (from, until) = (WARM_UP + 100, WARM_UP + 200);
    voices[ELSEWHERE].1 = Box::new(Delayed { from, until, reached: Arc::clone(&reached) });
    mark_lanes(&mut voices, &WATCHED);
    let mut stage = Stage::of(voices, scene.tick_hz, bus, 2).watched_by(Audience::new(1 << 16));
    // Any real wait for the delayed lane would never end.
    let none = WaitLimit::Until { time: Nanos::ZERO, share: Nanos::ZERO };
    for tick in 0..=WATCHED.end {
        let patience = if (from..until).contains(&tick) { none } else { WaitLimit::Endless };
        stage.lanes.set_patience(patience);
        reached.store(tick, Ordering::Release);
        if WATCHED.contains(&tick) {
            let report = trap::within(|| stage.tick());
            assert_eq!(0 < report.voices.late, (from..until).contains(&tick), "tick {tick}");
        } else {
            stage.tick();
        }
    }
    assert_eq!(watch.caught(), (0, 0));
    // Late once with tick `from`, then behind; keys at rest, if there were any, had passed.
    let LaneCounters { late, passed, .. } = stage.lanes.counters();
    assert!(late == until - from && passed <= 1, "{late} late, {passed} passed");
}

#[test]
fn the_trap_sees_the_threads_of_the_lanes() {
    struct Hoarding(Vec<u64>);
    impl Voice for Hoarding {
        fn tick(&mut self, tick: u64, _sample: &KeySample, _turn: &mut VoiceOutput) {
            self.0 = vec![tick];
        }
        fn reset(&mut self, _sample: &KeySample) {}
    }
    for n_lanes in 1..=2 {
        let watch = trap::watch();
        let scene = scene("springs", &[]);
        let mut voices = voices(&scene);
        voices[ELSEWHERE].1 = Box::new(Hoarding(Vec::new()));
        mark_lanes(&mut voices, &WATCHED);
        let bus = keybed(&scene);
        let mut stage = Stage::of(voices, 1000, bus, n_lanes).watched_by(Audience::new(16));
        run_watched(&mut stage);
        let n = WATCHED.end - WATCHED.start;
        assert_eq!(watch.caught(), (n, n), "{n_lanes} lanes");
    }
}
