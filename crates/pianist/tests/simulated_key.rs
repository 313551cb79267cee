//! A piece rehearsed on an independent key with mass, a springy finger and a let-off: a few lines
//! of mechanics that answer late, swing and rebound.

use std::fs;
use std::path::PathBuf;

use haptics::plant::Gesture;
use pianist::{
    Assessment, Damped, DamperFall, Pianist, PlayOutcome, Rehearsal, Score, ScoreNote, Strike,
    Struck, assess, read,
};

/// Step of the simulation (s).
const STEP: f64 = 1e-4;

/// Mass that the finger feels (kg).
const MASS: f64 = 0.25;

/// Force that lifts the key (N): it rises in 50 ms, a little slower than a grand's.
const RETURN: f64 = 2.0;

/// Dip of the key (m).
const DIP: f64 = 0.010;

/// Depths of let-off (m) and of the jack's reset (m).
const LET_OFF: (f64, f64) = (0.009, 0.006);

/// Depth at which the damper falls (m).
const DAMPER: f64 = 0.004;

/// A key, pushed by a finger on a spring and a damper.
#[derive(Clone, Debug, Default)]
struct Key {
    n_steps: u64,
    /// Depth (m) and speed (m/s), down positive.
    depth: f64,
    speed: f64,
    is_let_off: bool,
}

impl Key {
    fn now(&self) -> f64 {
        self.n_steps as f64 * STEP
    }

    fn force(&self, gestures: &[Gesture]) -> f64 {
        let now = self.now();
        let finger = gestures.iter().rev().find(|gesture| gesture.is_active(now));
        let push = finger.map_or(0.0, |finger| {
            400.0 * (finger.position(now) - self.depth) + 4.0 * (finger.velocity(now) - self.speed)
        });
        let bottom = (self.depth - DIP).max(0.0) * 3e4 * (1.0 + 2.0 * self.speed).max(0.0);
        let rail = (-self.depth).max(0.0) * 1e4 * (1.0 - 2.0 * self.speed).max(0.0);
        push.max(0.0) - RETURN - bottom + rail - 0.3 * self.speed
    }

    fn step(&mut self, gestures: &[Gesture], outcome: &mut PlayOutcome) {
        let before = self.depth;
        self.speed += self.force(gestures) / MASS * STEP;
        self.depth += self.speed * STEP;
        let (now, after) = (self.now(), self.depth);
        let passes = |height| (before - height) * (after - height) <= 0.0;
        let at = |height: f64| now + STEP * (height - before) / (after - before);
        if passes(LET_OFF.0) && self.speed > 0.04 && !self.is_let_off {
            self.is_let_off = true;
            outcome.strikes.push(Strike { at: at(LET_OFF.0), speed: 5.0 * self.speed });
        }
        if passes(LET_OFF.1) && self.speed < 0.0 {
            self.is_let_off = false;
        }
        if passes(DAMPER) && self.speed < 0.0 {
            outcome.damper_fall = Some(DamperFall { at: at(DAMPER), speed: -self.speed });
        }
        self.n_steps += 1;
    }
}

impl Rehearsal for Key {
    fn play(&mut self, gestures: &[Gesture], until: f64) -> PlayOutcome {
        let mut outcome = PlayOutcome::default();
        while self.now() < until {
            self.step(gestures, &mut outcome);
        }
        outcome
    }

    fn depth(&self) -> f64 {
        self.depth
    }

    fn period(&self) -> f64 {
        STEP
    }
}

#[track_caller]
fn check(piece: &str) {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../configs/performances");
    let score = read(&fs::read(folder.join(piece)).expect("the piece")).expect("a score");
    let heard = heard(&score);
    assert_eq!((heard.missed, heard.extra), (0, 0), "{heard}");
    assert!(heard.onset_error_ms.p99 < 1.0, "{heard}");
    assert!(heard.velocity_error.p99 <= 1.0, "{heard}");
    assert!(heard.end_error_ms.p50 < 3.0, "{heard}");
}

fn heard(score: &Score) -> Assessment {
    let pianist = Pianist::default();
    let performance = pianist.prepare(score, |_| Key::default(), |_| ());
    let (mut struck, mut damped) = (Vec::new(), Vec::new());
    for (key, gestures) in (0..).zip(&performance.gestures) {
        let mut played = Key::default();
        while played.now() < performance.end() + 0.5 {
            let outcome = played.play(gestures, played.now() + 0.01);
            struck.extend(outcome.strikes.iter().map(|strike| Struck {
                key,
                at: strike.at,
                velocity: pianist.curve.velocity(strike.speed).get(),
            }));
            let fall = |it: DamperFall| Damped { key, at: it.at, release: 64 };
            damped.extend(outcome.damper_fall.map(fall));
        }
    }
    assess(&performance.expected, &struck, &damped)
}

#[test]
fn the_prelude_is_played_to_the_design_s_figures() {
    check("bach-bwv-846.mid");
}

#[test]
fn the_ode_is_played_to_the_design_s_figures() {
    check("beethoven-ode-to-joy.mid");
}

#[test]
fn a_key_is_repeated_seven_times_a_second_from_where_it_is() {
    // The jack resets at 6 mm, and the full path up and down takes longer than a repetition.
    let soft_to_loud = [50, 60, 70, 80, 90];
    let notes = (0_u32..).zip(soft_to_loud).flat_map(|(row, velocity)| {
        (0..10_u32).map(move |n| {
            let onset = f64::from(3 * row) + f64::from(n) / 7.0;
            ScoreNote { key: 39, onset, end: onset + 0.05, velocity, release: None }
        })
    });
    let heard = heard(&Score { notes: notes.collect(), ..Score::default() });
    assert_eq!((heard.missed, heard.extra), (0, 0), "{heard}");
    // The loudest are a few milliseconds late, or softer: within the limits of `Shortfall`.
    assert!(heard.onset_error_ms.max < 10.0, "{heard}");
    assert!(heard.velocity_error.p50 <= 1.0 && heard.velocity_error.max < 10.0, "{heard}");
}
