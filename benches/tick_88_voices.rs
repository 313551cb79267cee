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

#[path = "setting/mod.rs"]
mod setting;
#[path = "../tests/stage/mod.rs"]
mod stage;

use std::sync::Arc;

use boards::sim::key::SimulatedKey;
use criterion::{BatchSize, Criterion};
use engine::realtime::wake_fd::WakeFd;
use engine::voice::RehearsableVoice;
use engine::voice::VoiceBuilder;
use haptics::RigParameters;
use host::adapters::observer::{LiveCounters, TickPublisher};
use host::adapters::tick_recorder::{TickRecorder, TickRecorderRings};
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::observation::{FollowedKeys, VoiceObservation};
use scheduler::port::{FinishedTick, KeyBus, Lanes, TickInput, TickObserver, TickOutput};
use scheduler::slot::Slot;
use scheduler::tick::Scheduler;
use scheduler::time::{Nanos, Period, Timetable};
use scheduler::voice::{Voice, VoiceOutput};
use setting::{TICKS, swing};
use stage::{Stage, scene, stroke};

const HZ: u32 = 1000;

/// Default slew limit of a scene (N/s).
const SLEW: f64 = 20e3;

fn main() {
    let mut criterion = setting::criterion();
    idle(&mut criterion);
    active(&mut criterion);
    event(&mut criterion, "default", "tick_88_voices/event");
    springs(&mut criterion);
    criterion.final_summary();
}

struct Tables {
    positions: Vec<[f64; TICKS]>,
    next: usize,
}

impl KeyBus for Tables {
    fn receive(&mut self, _tick: u64, samples: &mut [KeySample; KEYS]) {
        for (sample, table) in samples.iter_mut().zip(&self.positions) {
            *sample = KeySample::fresh(table[self.next]);
        }
        self.next = (self.next + 1) % TICKS;
    }

    fn send(&mut self, _tick: u64, forces: &[f64; KEYS], slopes: &[KeySlope; KEYS]) {
        std::hint::black_box((forces, slopes));
    }
}

/// Keys that are all held at one position (m).
struct Held(f64);

impl KeyBus for Held {
    fn receive(&mut self, _tick: u64, samples: &mut [KeySample; KEYS]) {
        *samples = [KeySample::fresh(self.0); KEYS];
    }

    fn send(&mut self, _tick: u64, forces: &[f64; KEYS], slopes: &[KeySlope; KEYS]) {
        std::hint::black_box((forces, slopes));
    }
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

struct Copied(Box<dyn RehearsableVoice>);

impl Clone for Copied {
    fn clone(&self) -> Self {
        Self(self.0.copy())
    }
}

impl Voice for Copied {
    fn tick(&mut self, tick: u64, sample: &KeySample, turn: &mut VoiceOutput) {
        self.0.tick(tick, sample, turn);
    }

    fn observe(&self, seen: &mut VoiceObservation) {
        self.0.observe(seen);
    }

    fn reset(&mut self, sample: &KeySample) {
        self.0.reset(sample);
    }
}

fn event(criterion: &mut Criterion, of: &str, name: &str) {
    let (slot, tick, position) = just_before_a_strike(of);
    let slots: Vec<_> = (0..KEYS).map(|_| slot.clone()).collect();
    let (mut bus, mut published) = (Held(position), Published::new(ALL_KEYS));
    criterion.bench_function(name, |bencher| {
        bencher.iter_batched_ref(
            || (scheduler_at(tick), Copies(slots.clone())),
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

struct Copies(Vec<Slot<Copied>>);

impl Lanes for Copies {
    fn run(&mut self, input: &TickInput<'_>, output: &mut TickOutput<'_>) {
        let keys = output.turns.iter_mut().zip(output.observed.iter_mut());
        for ((slot, sample), (turn, seen)) in self.0.iter_mut().zip(input.samples).zip(keys) {
            slot.tick(input.tick, sample, turn);
            slot.observe(input.followed, turn, seen);
        }
    }
}

fn scheduler_at(tick: u64) -> Box<Scheduler> {
    let period = Period::from_hz(HZ).expect("a rate that can be kept");
    let mut scheduler = engine::realtime::run::scheduler(Timetable::new(Nanos::ZERO, period), SLEW);
    let (due, mut nothing) = (scheduler.timetable().due(tick - 1), Copies(Vec::new()));
    scheduler.poll(due, &mut Held(0.0), &mut nothing, &mut stage::Nobody);
    scheduler
}

fn just_before_a_strike(of: &str) -> (Slot<Copied>, u64, f64) {
    let scene = scene(of, &[]);
    let assembler = VoiceBuilder::new(&scene).expect("a scene of ours");
    let described = scene.keys[39].as_ref().expect("a voice");
    let voice = assembler.voice(described, Arc::default()).expect("a model of ours");
    let mut slot = Slot::new(39, Copied(voice));
    let mut key = SimulatedKey::new(1e-3, RigParameters::default()).expect("a period");
    key.play(vec![stroke(0.1, 0.3, haptics::Touch::Pressed, 0.5)]);
    let mut turn = VoiceOutput::default();
    for tick in 0..1000 {
        let (sample, before) = (key.receive(tick), slot.clone());
        slot.tick(tick, &sample, &mut turn);
        key.send(turn.force, &turn.slope);
        if 0 < turn.events.strikes() {
            return (before, tick, sample.position);
        }
    }
    unreachable!("no stroke of 0.5 m/s is silent")
}
