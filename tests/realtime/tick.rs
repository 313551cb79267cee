//! Ticks without faults: every model, every method, one lane and two.

use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

use engine::realtime::run::{Assembly, Timings, Until};
use engine::realtime::wake_fd::WakeFd;
use engine::realtime::{clock, run};
use host::adapters::observer::{LiveCounters, TickPublisher};
use host::adapters::tick_recorder::{TickRecorder, TickRecorderRings};
use midi::{NoteEvent as MidiEvent, PedalMove};
use rtrb::Consumer;
use scene::Scene;
use scheduler::motion::KEYS;
use scheduler::observation::FollowedKeys;
use scheduler::port::{FinishedTick, KeyBus, TickObserver};
use scheduler::time::Nanos;

use crate::marking::mark_lanes;
use crate::stage::{Stage, keybed, play_all, scene, voices};
use crate::trap;

pub(crate) const WARM_UP: u64 = 200;
/// Watched ticks: every key is struck at least five times.
pub(crate) const WATCHED: Range<u64> = WARM_UP..WARM_UP + 3000;

pub(crate) struct Audience {
    publisher: TickPublisher,
    /// Telemetry with rings that are never emptied, so that full ones are covered.
    tap: TickRecorder,
    tapped: TickRecorderRings,
    pub(crate) ring: Consumer<MidiEvent>,
    pub(crate) counters: Arc<LiveCounters>,
    active: [u32; KEYS],
    events: [u32; KEYS],
}

impl Audience {
    pub(crate) fn new(places: usize) -> Self {
        let (producer, ring) = rtrb::RingBuffer::new(places);
        let bell = Arc::new(WakeFd::new().expect("a descriptor"));
        let counters = Arc::new(LiveCounters::default());
        let pedal = midi::Pedal::Sustain;
        let moved = |n| (0.03 * f64::from(n), f64::from(n % 2));
        let pedals =
            (0..100).map(moved).map(|(at, depth)| PedalMove { pedal, at, depth }).collect();
        let publisher = TickPublisher::new(producer, bell, Arc::clone(&counters), pedals, 1e-3);
        let (tap, tapped) = TickRecorder::new();
        tapped.followed.store((1 << KEYS) - 1);
        Self { publisher, tap, tapped, ring, counters, active: [0; KEYS], events: [0; KEYS] }
    }
}

impl TickObserver for Audience {
    fn followed(&mut self) -> FollowedKeys {
        self.tap.followed()
    }

    fn observe(&mut self, seen: &FinishedTick<'_>) {
        self.publisher.observe(seen);
        self.tap.observe(seen);
        for (key, turn) in seen.turns.iter().enumerate() {
            self.active[key] += u32::from(!turn.idle);
            self.events[key] += turn.work.events;
        }
    }
}

pub(crate) fn stage<B: KeyBus>(scene: &Scene, bus: B, n_lanes: usize) -> Stage<B, Audience> {
    let mut voices = voices(scene);
    mark_lanes(&mut voices, &WATCHED);
    Stage::of(voices, scene.tick_hz, bus, n_lanes).watched_by(Audience::new(1 << 16))
}

pub(crate) fn run_watched<B: KeyBus>(stage: &mut Stage<B, Audience>) {
    for tick in 0..=WATCHED.end {
        if WATCHED.contains(&tick) {
            trap::within(|| stage.tick());
        } else {
            stage.tick();
        }
    }
}

#[track_caller]
fn check(scene: &Scene, n_lanes: usize) -> Audience {
    let watch = trap::watch();
    let mut bus = keybed(scene);
    play_all(&mut bus, WATCHED.end as f64 * 1e-3);
    let mut stage = stage(scene, bus, n_lanes);
    run_watched(&mut stage);
    assert_eq!(watch.caught(), (0, 0), "allocations and frees on {n_lanes} lanes");
    let audience = stage.observer;
    assert!(audience.active.iter().all(|ticks| 100 < *ticks), "every key was played");
    assert!(audience.ring.slots() > KEYS, "key events were published");
    assert!(KEYS < audience.tapped.rows.slots(), "rows were told");
    assert!(0 < audience.tapped.dropped.load(Relaxed));
    assert_eq!(audience.counters.dropped.load(Relaxed), 0);
    audience
}

const MODELS: [&str; 6] = [
    "key-hammer-springs",
    "key-hammer-rigid",
    "reduced-grand",
    "bouncing-ball",
    "cart-pendulum",
    "spring-wall",
];

#[test]
fn a_tick_of_every_model_leaves_the_heap_alone() {
    let scene = scene("mixed", &[]);
    for n_lanes in 1..=2 {
        let events = check(&scene, n_lanes).events;
        for name in MODELS {
            let keys = || {
                let all = scene.keys.iter().enumerate();
                all.filter(|(_, it)| it.as_ref().is_some_and(|it| it.model.name == name))
            };
            assert!(keys().count() > 0, "the scene has no {name}");
            assert!(keys().any(|(key, _)| 0 < events[key]), "no event of any {name}");
        }
    }
}

#[test]
fn a_tick_of_every_method_leaves_the_heap_alone() {
    for stepper in ["semi-implicit-euler", "heun", "bogacki-shampine"] {
        check(&scene("springs", &[("render.stepper", stepper)]), 1);
    }
}

#[test]
fn a_tick_of_every_input_path_leaves_the_heap_alone() {
    for reconstruction in ["hold", "linear", "quadratic", "late-hermite"] {
        check(&scene("springs", &[("render.reconstruction", reconstruction)]), 1);
    }
    check(&scene("springs", &[("render.estimator", "backward-difference")]), 1);
}

#[test]
fn the_loop_in_real_time_leaves_the_heap_alone() {
    let watch = trap::watch();
    let scene = scene("mixed", &[]);
    let mut bus = keybed(&scene);
    play_all(&mut bus, 1.0);
    let Stage { mut scheduler, mut bus, mut lanes, swaps: _, mut observer } = stage(&scene, bus, 2);
    let mut timings = Timings::new().expect("possible histograms");
    let mut assembly = Assembly {
        scheduler: &mut scheduler,
        bus: &mut bus,
        lanes: &mut lanes,
        observer: &mut observer,
    };
    let stop = AtomicBool::new(false);
    let (start, until) = (clock::monotonic(), Until { stop: &stop, ticks: Some(2000) });
    // The machine may skip ticks, so the lane stays marked until it ends with its last one.
    trap::within(|| {
        run::run(&mut assembly, start, until, &mut timings, |_pulse| {});
        run::ramp_down(&mut assembly);
    });
    assert_eq!(watch.caught(), (0, 0));
    // A pause of the machine for a tick or more skips ticks.
    let counters = timings.counters();
    assert!(2000 <= counters.ticks + counters.skipped, "{counters:?}");
    assert!(0 < counters.ticks, "{counters:?}");
    assert!(start.after(Nanos::from_millis(499)) <= clock::monotonic());
}
