//! The machine pauses: ticks are lost, and notes played meanwhile sound late.

use figures::rehearsal::RehearsedKey;
use haptics::{Gesture, Touch};
use pianist::{Pianist, Score, ScoreNote, Technique};
use scheduler::motion::KeyEvent;
use scheduler::port::{FinishedTick, TickObserver};

use engine::voice::VoiceBuilder;

use crate::stage::{Stage, key, keybed, scene, stroke};

const KEY: usize = 39;

const START: f64 = 0.5;

/// Strikes of all keys: key, time (s), and speed of the hammer (m/s).
#[derive(Default)]
struct Strikes(Vec<(usize, f64, f64)>);

impl TickObserver for &mut Strikes {
    fn observe(&mut self, seen: &FinishedTick<'_>) {
        for (key, turn) in seen.turns.iter().enumerate() {
            let strikes = turn.events.as_slice().iter().filter_map(|(at, event)| match event {
                KeyEvent::Strike { speed, .. } => Some((key, at.seconds(1e-3), *speed)),
                KeyEvent::DamperLift | KeyEvent::DamperFall { .. } | KeyEvent::Pressure { .. } => {
                    None
                }
            });
            self.0.extend(strikes);
        }
    }
}

fn strikes(name: &str, speed: f64, from: u64, lost: u64) -> Vec<(usize, f64, f64)> {
    let scene = scene(name, &[]);
    let mut bus = keybed(&scene);
    bus.play(key(KEY), vec![stroke(START, START + 0.6, Touch::Pressed, speed)]);
    let mut strikes = Strikes::default();
    let mut stage = Stage::new(&scene, bus).watched_by(&mut strikes);
    while stage.tick().tick < from {}
    stage.pause(lost);
    while stage.tick().tick < 1400 {}
    drop(stage);
    strikes.0
}

/// Forces are gone after 20 ms of a pause, so the key sinks by itself: a strike may be early.
#[test]
fn a_note_that_is_played_while_the_machine_pauses_sounds_late_and_about_as_loud() {
    let (mut pauses, mut extra) = (0, 0);
    for (name, touch) in [("default", 0.15), ("default", 0.4), ("springs", 0.15), ("springs", 0.4)]
    {
        let (_, usual, loudness) = strikes(name, touch, 10, 0)[0];
        for lost in [12, 33, 80] {
            for from in (500..560).step_by(12) {
                let situation = format!("{name}, {touch} m/s, {lost} ticks from {from}");
                let found = strikes(name, touch, from, lost);
                let (_, at, speed) = *found.first().expect(&situation);
                let late = at - usual;
                assert!(late <= 1e-3 * lost as f64 + 30e-3, "{situation}: {late} s late");
                let louder = speed / loudness;
                assert!((0.5..4.0).contains(&louder), "{situation}: {louder} times as loud");
                (pauses, extra) = (pauses + 1, extra + found.len() - 1);
            }
        }
    }
    // The key bounces where its force returns.
    assert!(extra <= pauses / 8, "{extra} more strikes than strokes in {pauses} pauses");
}

fn repeated(scene: &scene::Scene, key: usize, velocity: u8) -> Vec<Gesture> {
    let builder = VoiceBuilder::new(scene).expect("a good scene");
    let (_, voice) = builder.keys().next().expect("a key");
    let note = |onset, end, velocity| ScoreNote {
        key: u8::try_from(key).expect("one of 88"),
        onset,
        end,
        velocity,
        release: None,
    };
    let notes = vec![note(0.0, 0.625, velocity), note(0.625, 1.25, velocity - 3)];
    let score = Score { notes, ..Score::default() };
    let technique = Technique { hold: Gesture::hold_of(scene.rig.dip), ..Technique::default() };
    let pianist = Pianist { technique, ..Pianist::default() };
    let instrument = |_key| RehearsedKey::of_scene(&builder, key, voice).expect("a voice");
    let mut performance = pianist.prepare(&score, instrument, |_progress| {});
    assert_eq!(performance.predicted.len(), 2, "both can be played");
    std::mem::take(&mut performance.gestures[key])
}

#[test]
fn a_repeated_note_is_struck_although_a_tick_is_lost_before() {
    const D3: usize = 29;
    let scene = scene("default", &[("keys.0.range", "D3..D3")]);
    let mut missed = Vec::new();
    for velocity in [42, 46, 48, 52] {
        let gestures = repeated(&scene, D3, velocity);
        for from in (900..1640).step_by(37) {
            let mut bus = keybed(&scene);
            bus.play(key(D3), gestures.clone());
            let mut strikes = Strikes::default();
            let mut stage = Stage::new(&scene, bus).watched_by(&mut strikes);
            while stage.tick().tick < from {}
            stage.pause(1);
            while stage.tick().tick < 2000 {}
            drop(stage);
            if strikes.0.len() != 2 {
                missed.push((velocity, from, strikes.0.len()));
            }
        }
    }
    assert!(missed.is_empty(), "velocity, tick, strikes: {missed:?}");
}
