//! Repetition and return of a key after its stroke.

use pode::Motion;

use super::drive::{BEYOND_DIP, Drive};
use super::subject::PianoSubject;

/// Strokes of a repetition that must all sound.
const STROKES: u32 = 8;
/// Speed of the first press (m/s).
const FIRST: f64 = 0.15;
/// Length of a tick (s).
const TICK: f64 = 1e-4;

/// Returns the fastest repetition at which every stroke sounds (1/s), with the key rising by `part`
/// of its travel; 0 if there is none.
pub(super) fn quickest(subject: &PianoSubject<'_>, key: u8, part: f64) -> f64 {
    /// Rates that are tried, in halves (1/s).
    const HALVES: std::ops::RangeInclusive<u32> = 4..=50;
    let mut rates = HALVES.rev().map(|halves| 0.5 * f64::from(halves));
    rates.find(|rate| repeats(subject, key, (part, *rate))).unwrap_or(0.0)
}

pub(super) fn repeats(subject: &PianoSubject<'_>, key: u8, (part, rate): (f64, f64)) -> bool {
    let mut driven = subject.open(key);
    let held = subject.dip(key) + 0.5 * BEYOND_DIP;
    let drive = Drive::Repeated { speed: FIRST, held, up: (1.0 - part) * held, rate };
    let first = held / FIRST;
    let until = first + (f64::from(STROKES) + 0.5) / rate + TICK;
    // One strike in each period, which begins with the key down.
    let period = |n: u32| first + (f64::from(n) + 0.5) / rate;
    let (mut t, mut played) = (0.0, 0);
    while t < until {
        if !driven.advance(TICK, &|theta| drive.at(t + theta * TICK)) {
            return false;
        }
        t += TICK;
        if period(played + 1) <= t {
            let within = period(played)..period(played + 1);
            let sounds = driven.strikes().iter().filter(|it| it.sounds && within.contains(&it.t));
            if sounds.count() != 1 {
                return false;
            }
            played += 1;
        }
    }
    played >= STROKES
}

/// Returns the time from release with the key down until it is up to 1 mm (s), without force.
pub(super) fn return_time(subject: &PianoSubject<'_>, key: u8) -> Option<f64> {
    /// Hold before (s), and longest awaited return (s).
    const HELD: f64 = 0.3;
    const PATIENCE: f64 = 1.0;
    const UP: f64 = 1e-3;
    /// Tick (s), short since the finger follows the front one tick late.
    const SHORT: f64 = 2e-5;
    let mut driven = subject.open(key);
    let held = subject.dip(key) + 0.2 * BEYOND_DIP;
    let down = held / FIRST;
    let drive = |t: f64| Motion {
        position: (FIRST * t).min(held),
        rate: if t < down { FIRST } else { 0.0 },
        ..Motion::default()
    };
    let mut t = 0.0;
    while t < down + HELD {
        if !driven.advance(TICK, &|theta| drive(t + theta * TICK)) {
            return None;
        }
        t += TICK;
    }
    let gone = t;
    let mut before = driven.sample().travel;
    while t < gone + PATIENCE {
        let now = driven.sample().travel;
        let rate = (now - before) / SHORT;
        before = now;
        let front =
            |theta: f64| Motion { position: now + rate * SHORT * theta, rate, ..Motion::default() };
        if !driven.advance(SHORT, &front) {
            return None;
        }
        t += SHORT;
        if driven.sample().travel <= UP {
            return Some(t - gone);
        }
    }
    None
}
