//! Buses in memory, and copies of one voice, for benches of whole ticks.
#![allow(dead_code, unreachable_pub, reason = "each bench uses its own part")]
#![allow(clippy::expect_used, reason = "a bench may stop here")]

use std::sync::Arc;

use boards::sim::key::SimulatedKey;
use engine::voice::{CopiedVoice, VoiceBuilder};
use haptics::RigParameters;
use scene::Scene;
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::{KeyBus, Lanes, TickInput, TickOutput};
use scheduler::slot::Slot;
use scheduler::tick::Scheduler;
use scheduler::time::{Nanos, Period, Timetable};
use scheduler::voice::VoiceOutput;

use crate::setting::TICKS;
use crate::stage::{Nobody, stroke};

/// Default slew limit of a scene (N/s).
const SLEW: f64 = 20e3;

pub struct Tables {
    pub positions: Vec<[f64; TICKS]>,
    pub next: usize,
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
pub struct Held(pub f64);

impl KeyBus for Held {
    fn receive(&mut self, _tick: u64, samples: &mut [KeySample; KEYS]) {
        *samples = [KeySample::fresh(self.0); KEYS];
    }

    fn send(&mut self, _tick: u64, forces: &[f64; KEYS], slopes: &[KeySlope; KEYS]) {
        std::hint::black_box((forces, slopes));
    }
}

pub struct Copies(pub Vec<Slot<CopiedVoice>>);

impl Lanes for Copies {
    fn run(&mut self, input: &TickInput<'_>, output: &mut TickOutput<'_>) {
        let keys = output.turns.iter_mut().zip(output.observed.iter_mut());
        for ((slot, sample), (turn, seen)) in self.0.iter_mut().zip(input.samples).zip(keys) {
            slot.tick(input.tick, sample, turn);
            slot.observe(input.followed, turn, seen);
        }
    }
}

pub fn scheduler_at(tick: u64, hz: u32) -> Box<Scheduler> {
    let period = Period::from_hz(hz).expect("a rate that can be kept");
    let mut scheduler = engine::realtime::run::scheduler(Timetable::new(Nanos::ZERO, period), SLEW);
    let (due, mut nothing) = (scheduler.timetable().due(tick - 1), Copies(Vec::new()));
    scheduler.poll(due, &mut Held(0.0), &mut nothing, &mut Nobody);
    scheduler
}

pub fn just_before_a_strike(scene: &Scene) -> (Slot<CopiedVoice>, u64, f64) {
    let assembler = VoiceBuilder::new(scene).expect("a scene of ours");
    let described = scene.keys[39].as_ref().expect("a voice");
    let voice = assembler.voice(described, Arc::default()).expect("a model of ours");
    let mut slot = Slot::new(39, CopiedVoice(voice));
    let mut key = SimulatedKey::new(1.0 / f64::from(scene.tick_hz), RigParameters::default())
        .expect("a period");
    key.play(vec![stroke(0.1, 0.3, haptics::Touch::Pressed, 0.5)]);
    let mut turn = VoiceOutput::default();
    for tick in 0..u64::from(scene.tick_hz) {
        let (sample, before) = (key.receive(tick), slot.clone());
        slot.tick(tick, &sample, &mut turn);
        key.send(turn.force, &turn.slope);
        if 0 < turn.events.strikes() {
            return (before, tick, sample.position);
        }
    }
    unreachable!("no stroke of 0.5 m/s is silent")
}
