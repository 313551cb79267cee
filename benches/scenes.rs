//! Whole ticks of named scenes beside the error of their forces, as rows of the README's table.
//!
//! | column | measured |
//! |---|---|
//! | 88 keys move | least time of a tick on one lane, all keys between 1 and 9 mm |
//! | ten strike | least time of a tick in which ten hammers meet their strings, on one lane |
//! | error | RMS of one key's force over a loud stroke, against steps of 20 µs of RK4 |
#![expect(clippy::expect_used, clippy::print_stdout, reason = "a bench prints, and may stop here")]

#[path = "setting/keys.rs"]
mod keys;
#[path = "setting/mod.rs"]
mod setting;
#[path = "../tests/stage/mod.rs"]
mod stage;

use std::sync::Arc;
use std::time::Instant;

use engine::voice::VoiceBuilder;
use figures::tick_cost::loud_stroke;
use haptics::RigParameters;
use keys::{Copies, Held, Tables, just_before_a_strike, scheduler_at};
use scene::Scene;
use scheduler::motion::{KEYS, KeySample};
use scheduler::voice::VoiceOutput;
use setting::{TICKS, swing_between};
use stage::{Nobody, Stage, scene};

const SCENES: [(&str, u32); 4] =
    [("springs", 1000), ("default", 1000), ("default", 2000), ("default", 4000)];

const CHORD: usize = 10;

/// Number of rounds: the fastest one is reported.
const ROUNDS: usize = 40;

fn main() {
    for (name, hz) in SCENES {
        let rate = hz.to_string();
        let at =
            |more: &[(&str, &str)]| scene(name, &[&[("tick_hz", rate.as_str())], more].concat());
        let fine = at(&[("render.stepper", "rk4"), ("render.longest_step", "2e-5")]);
        let own = at(&[]);
        println!(
            "| `{name}`, {} kHz | {:.0} us of {} | {:.0} us | {:.0} mN |",
            hz / 1000,
            moving(&own),
            1_000_000 / hz,
            chord(&own),
            1e3 * error(&own, &fine),
        );
    }
}

/// Returns the mean time of a tick (us) in which all keys move: of each tick the least over rounds.
fn moving(scene: &Scene) -> f64 {
    let mut stage = Stage::new(scene, Tables { positions: swings(), next: 0 });
    let mut least = [f64::INFINITY; TICKS];
    for _ in 0..ROUNDS {
        for time in &mut least {
            let start = Instant::now();
            let report = stage.tick();
            *time = time.min(1e6 * start.elapsed().as_secs_f64());
            assert_eq!(report.voices.idle, 0, "a key sleeps");
        }
    }
    least.iter().sum::<f64>() / TICKS as f64
}

/// Positions (m) of all keys between 1 and 9 mm, each in one to three swings of the whole table.
fn swings() -> Vec<[f64; TICKS]> {
    let quantum = RigParameters::default().quantum;
    let one = |key: usize| {
        let phase = key as f64 / KEYS as f64;
        swing_between((1e-3, 9e-3), 1 + key % 3, phase, quantum)
    };
    (0..KEYS).map(one).collect()
}

/// Returns the least time of a tick (us) in which ten hammers strike.
fn chord(scene: &Scene) -> f64 {
    let (slot, tick, position) = just_before_a_strike(scene);
    let one = || {
        let mut lanes = Copies((0..CHORD).map(|_| slot.clone()).collect());
        let mut scheduler = scheduler_at(tick, scene.tick_hz);
        let due = scheduler.next_due();
        let start = Instant::now();
        let report = scheduler.poll(due, &mut Held(position), &mut lanes, &mut Nobody);
        let time = start.elapsed();
        let events = report.map_or(0, |it| it.voices.work.events);
        assert!(CHORD <= events as usize, "{events} events");
        1e6 * time.as_secs_f64()
    };
    (0..10 * ROUNDS).map(|_| one()).fold(f64::INFINITY, f64::min)
}

/// Returns the RMS difference of the forces (N) in a loud stroke.
fn error(own: &Scene, fine: &Scene) -> f64 {
    let [own, fine] = [own, fine].map(forces);
    let squares: f64 = own.iter().zip(&fine).map(|(a, b)| (a - b).powi(2)).sum();
    (squares / own.len() as f64).sqrt()
}

/// Returns the forces (N) of a key in a loud stroke.
fn forces(scene: &Scene) -> Vec<f64> {
    let builder = VoiceBuilder::new(scene).expect("a scene of ours");
    let key = scene.keys[39].as_ref().expect("a voice");
    let mut voice = builder.voice(key, Arc::default()).expect("a model of ours");
    voice.reset(&KeySample::fresh(0.0));
    let force = |(tick, sample)| {
        let mut turn = VoiceOutput::default();
        voice.tick(tick, &sample, &mut turn);
        assert!(turn.fault.is_none(), "{:?}", turn.fault);
        turn.force
    };
    loud_stroke(scene.tick_hz).map(force).collect()
}
