//! One whole tick of 88 keys: receive, voices, safety, send, publish.
//!
//! The keys play the scene `default`, a mechanism of five bodies each, or in cases with `springs`
//! in their names the scene `springs`, model B at a key's size. The bus is memory, so that the
//! simulated keys are not measured.
//!
//! | case | keys |
//! |---|---|
//! | idle | all at rest |
//! | active | all move, so all equations run: steps and guards, no event |
//! | event | all 88 hammers are in free flight and meet their strings within this one tick |
#![expect(clippy::expect_used, reason = "a bench may stop here")]

#[path = "setting/keys.rs"]
mod keys;
#[path = "setting/mod.rs"]
mod setting;
#[path = "../tests/stage/mod.rs"]
mod stage;

use std::sync::Arc;

use criterion::{BatchSize, Criterion};
use engine::realtime::wake_fd::WakeFd;
use haptics::RigParameters;
use host::adapters::observer::{LiveCounters, TickPublisher};
use host::adapters::tick_recorder::{TickRecorder, TickRecorderRings};
use keys::{Copies, Held, Tables, just_before_a_strike, scheduler_at};
use scheduler::motion::KEYS;
use scheduler::observation::FollowedKeys;
use scheduler::port::{FinishedTick, TickObserver};
use setting::{TICKS, swing};
use stage::{Stage, scene};

const HZ: u32 = 1000;

fn main() {
    let mut criterion = setting::criterion();
    idle(&mut criterion);
    active(&mut criterion);
    event(&mut criterion, "default", "tick_88_voices/event");
    springs(&mut criterion);
    criterion.final_summary();
}

struct Published {
    publisher: TickPublisher,
    ring: rtrb::Consumer<midi::NoteEvent>,
    tap: Option<(TickRecorder, TickRecorderRings)>,
}

/// Keys of a recording.
const ALL_KEYS: u128 = (1 << KEYS) - 1;

/// Keys of a window that shows a chord.
const FOUR_KEYS: u128 = 1 << 27 | 1 << 39 | 1 << 43 | 1 << 46;

impl Published {
    fn new(keys: u128) -> Self {
        let (producer, ring) = rtrb::RingBuffer::new(4096);
        let bell = Arc::new(WakeFd::new().expect("a descriptor"));
        let counters = Arc::new(LiveCounters::default());
        let publisher = TickPublisher::new(producer, bell, counters, Box::default(), 1e-3);
        let (tap, tapped) = TickRecorder::new();
        tapped.followed.store(keys);
        Self { publisher, ring, tap: Some((tap, tapped)) }
    }

    fn untapped() -> Self {
        Self { tap: None, ..Self::new(0) }
    }
}

impl TickObserver for Published {
    fn followed(&mut self) -> FollowedKeys {
        self.tap.as_mut().map_or(FollowedKeys::NONE, |(tap, _tapped)| tap.followed())
    }

    fn observe(&mut self, seen: &FinishedTick<'_>) {
        self.publisher.observe(seen);
        let Some((tap, tapped)) = &mut self.tap else { return };
        tap.observe(seen);
        // As the telemetry thread does, or the rings would be full and nothing pushed.
        if let Ok(rows) = tapped.rows.read_chunk(tapped.rows.slots()) {
            rows.commit_all();
        }
        if let Ok(happenings) = tapped.happenings.read_chunk(tapped.happenings.slots()) {
            happenings.commit_all();
        }
    }
}

fn ticks(
    criterion: &mut Criterion,
    (of, name): (&str, &str),
    positions: Vec<[f64; TICKS]>,
    idle: usize,
    observer: impl TickObserver,
) {
    let bus = Tables { positions, next: 0 };
    let mut stage = Stage::new(&scene(of, &[]), bus).watched_by(observer);
    for _ in 0..8 * TICKS {
        stage.tick();
    }
    assert_eq!(stage.tick().voices.idle as usize, idle, "{name}");
    criterion.bench_function(name, |bencher| bencher.iter(|| stage.tick()));
    assert_eq!(stage.tick().voices.idle as usize, idle, "{name}");
}

fn still() -> Vec<[f64; TICKS]> {
    vec![[0.0; TICKS]; KEYS]
}

fn swings() -> Vec<[f64; TICKS]> {
    let quantum = RigParameters::default().quantum;
    (0..KEYS).map(|key| swing(key as f64 / KEYS as f64, quantum)).collect()
}

fn idle(criterion: &mut Criterion) {
    let mut case = |name, observer| ticks(criterion, ("default", name), still(), KEYS, observer);
    case("tick_88_voices/idle", Published::new(ALL_KEYS));
    case("tick_88_voices/idle_untapped", Published::untapped());
}

fn active(criterion: &mut Criterion) {
    let mut case = |name, observer| ticks(criterion, ("default", name), swings(), 0, observer);
    case("tick_88_voices/active", Published::new(ALL_KEYS));
    case("tick_88_voices/active_4_followed", Published::new(FOUR_KEYS));
    case("tick_88_voices/active_untapped", Published::untapped());
    let unwatched = ("default", "tick_88_voices/active_unwatched");
    ticks(criterion, unwatched, swings(), 0, stage::Nobody);
}

fn springs(criterion: &mut Criterion) {
    let mut case = |name, positions, idle| {
        ticks(criterion, ("springs", name), positions, idle, Published::new(ALL_KEYS));
    };
    case("tick_88_voices/springs/idle", still(), KEYS);
    case("tick_88_voices/springs/active", swings(), 0);
    event(criterion, "springs", "tick_88_voices/springs/event");
}

fn event(criterion: &mut Criterion, of: &str, name: &str) {
    let scene = scene(of, &[]);
    let (slot, tick, position) = just_before_a_strike(&scene);
    let slots: Vec<_> = (0..KEYS).map(|_| slot.clone()).collect();
    let (mut bus, mut published) = (Held(position), Published::new(ALL_KEYS));
    criterion.bench_function(name, |bencher| {
        bencher.iter_batched_ref(
            || (scheduler_at(tick, HZ), Copies(slots.clone())),
            |(scheduler, lanes)| {
                let due = scheduler.next_due();
                let report = scheduler.poll(due, &mut bus, lanes, &mut published);
                let events = report.map_or(0, |report| report.voices.work.events);
                assert!(KEYS <= events as usize, "{events} events");
                while published.ring.pop().is_ok() {}
            },
            BatchSize::PerIteration,
        );
    });
}
