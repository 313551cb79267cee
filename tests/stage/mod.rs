//! A scene's voices on a simulated keybed, run tick by tick in virtual time.
#![allow(dead_code, unreachable_pub, reason = "each test program uses its own part")]
#![allow(clippy::expect_used, reason = "helpers of tests, outside #[test]")]

pub mod broken_sensor;

use std::num::NonZeroUsize;
use std::sync::Arc;

use boards::sim::keybed::SimulatedKeybed;
use engine::realtime::pool::{BoxedVoice, ThreadedLanes, VoiceSwaps};
use engine::realtime::thread::ThreadPlan;
use engine::voice::AuditCell;
use engine::voice::VoiceBuilder;
use firmware_protocol::key::KeyIndex;
use haptics::{Gesture, Touch};
use scene::Scene;
use scheduler::motion::KEYS;
use scheduler::port::{FinishedTick, KeyBus, TickObserver};
use scheduler::tick::{Scheduler, TickReport};
use scheduler::time::{Nanos, Period, Timetable};

/// Returns a scene of ours with overrides, which is accepted.
pub fn scene(name: &str, overrides: &[(&str, &str)]) -> Scene {
    try_scene(name, overrides).expect("a good scene")
}

pub fn try_scene(name: &str, overrides: &[(&str, &str)]) -> Result<Scene, String> {
    let overrides: Vec<_> =
        overrides.iter().map(|(name, value)| (String::from(*name), String::from(*value))).collect();
    Scene::load(&scene::Library::default(), name, &overrides).map_err(|wrong| wrong.to_string())
}

pub fn voices(scene: &Scene) -> Vec<(usize, BoxedVoice)> {
    audited(scene, &std::array::from_fn(|_key| Arc::default()))
}

pub fn audited(scene: &Scene, audits: &[Arc<AuditCell>; KEYS]) -> Vec<(usize, BoxedVoice)> {
    let assembler = VoiceBuilder::new(scene).expect("a rate that can be kept");
    let voice = |(key, voice)| {
        let voice = assembler.voice(voice, Arc::clone(&audits[key])).expect("a known model");
        (key, voice as BoxedVoice)
    };
    assembler.keys().map(voice).collect()
}

pub fn keybed(scene: &Scene) -> SimulatedKeybed {
    let period = 1.0 / f64::from(scene.tick_hz);
    SimulatedKeybed::new(period, scene.rig.parameters()).expect("a possible period")
}

pub fn lanes(voices: Vec<(usize, BoxedVoice)>, n_lanes: usize) -> (ThreadedLanes, VoiceSwaps) {
    let n_lanes = NonZeroUsize::new(n_lanes).expect("a lane at least");
    ThreadedLanes::start(voices, n_lanes, &ThreadPlan::default()).expect("threads")
}

pub fn key(number: usize) -> KeyIndex {
    u8::try_from(number).ok().and_then(KeyIndex::new).expect("one of the 88 keys")
}

/// Returns a stroke from `start` to `release` (s) at `speed` (m/s).
pub fn stroke(start: f64, release: f64, touch: Touch, speed: f64) -> Gesture {
    Gesture { start, release, touch, speed, ..Gesture::USUAL }
}

/// Plays every key about twice a second until `end` (s): pressed and struck, soft and loud, no two
/// neighbours at once.
pub fn play_all(keybed: &mut SimulatedKeybed, end: f64) {
    for number in 0..KEYS {
        keybed.play(key(number), strokes(number, end));
    }
}

fn strokes(number: usize, end: f64) -> Vec<Gesture> {
    let first = 0.01 + 0.007 * (number * 37 % 71) as f64;
    let strokes = (0_u32..).map(|n| {
        let start = first + 0.55 * f64::from(n);
        let (touch, speed) = match (number + n as usize) % 3 {
            0 => (Touch::Pressed, 0.15),
            1 => (Touch::Pressed, 0.5),
            _ => (Touch::Struck, 1.5),
        };
        stroke(start, start + 0.2, touch, speed)
    });
    strokes.take_while(|gesture| gesture.start < end).collect()
}

#[derive(Debug)]
pub struct Nobody;

impl TickObserver for Nobody {
    fn observe(&mut self, _seen: &FinishedTick<'_>) {}
}

#[derive(Debug)]
pub struct Stage<B, O> {
    pub scheduler: Box<Scheduler>,
    pub bus: B,
    pub lanes: ThreadedLanes,
    pub swaps: VoiceSwaps,
    pub observer: O,
}

impl<B: KeyBus> Stage<B, Nobody> {
    pub fn new(scene: &Scene, bus: B) -> Self {
        Self::on_lanes(scene, bus, 1)
    }

    pub fn on_lanes(scene: &Scene, bus: B, n_lanes: usize) -> Self {
        Self::playing(scene, voices(scene), bus, n_lanes)
    }

    pub fn playing(
        scene: &Scene,
        voices: Vec<(usize, BoxedVoice)>,
        bus: B,
        n_lanes: usize,
    ) -> Self {
        let limits = (scene.tick_hz, scene.render.slew_limit);
        let mut stage = Self::limited(voices, limits, bus, n_lanes);
        stage.scheduler.set_overload(scene.overload);
        stage
    }

    /// Like `playing`, with forces that are sent however fast they change.
    pub fn of(voices: Vec<(usize, BoxedVoice)>, tick_hz: u32, bus: B, n_lanes: usize) -> Self {
        Self::limited(voices, (tick_hz, f64::INFINITY), bus, n_lanes)
    }

    fn limited(
        voices: Vec<(usize, BoxedVoice)>,
        (tick_hz, slew): (u32, f64),
        bus: B,
        n_lanes: usize,
    ) -> Self {
        let (lanes, swaps) = lanes(voices, n_lanes);
        let period = Period::from_hz(tick_hz).expect("a rate that can be kept");
        let scheduler = engine::realtime::run::scheduler(Timetable::new(Nanos::ZERO, period), slew);
        Self { scheduler, bus, lanes, swaps, observer: Nobody }
    }

    pub fn watched_by<O>(self, observer: O) -> Stage<B, O> {
        let Self { scheduler, bus, lanes, swaps, observer: Nobody } = self;
        Stage { scheduler, bus, lanes, swaps, observer }
    }
}

impl<B: KeyBus, O: TickObserver> Stage<B, O> {
    pub fn tick(&mut self) -> TickReport {
        let due = self.scheduler.next_due();
        let Self { scheduler, bus, lanes, observer, .. } = self;
        scheduler.poll(due, bus, lanes, observer).expect("due")
    }

    pub fn pause(&mut self, lost: u64) -> TickReport {
        let period = self.scheduler.timetable().period();
        let now = self.scheduler.next_due().after(period.span(lost));
        let Self { scheduler, bus, lanes, observer, .. } = self;
        scheduler.poll(now, bus, lanes, observer).expect("due")
    }

    pub fn forces(&self) -> &[f64; KEYS] {
        self.scheduler.forces()
    }
}
