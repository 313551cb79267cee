//! Row by row through the table, then properties of any sequence of ticks.

#![expect(clippy::large_stack_arrays, reason = "all turns; a test has the stack")]

use super::*;
use crate::voice::VoiceFault;
use proptest::prelude::*;

/// Ticks of the fade in these tests: 20 ms at 200 Hz.
const N: u32 = 4;

/// Fade of [`N`] ticks, without a slew limit towards the voice.
const RAMPS: Ramps = Ramps { fade_ticks: N, reach: f64::INFINITY };

/// Steps a key through `ticks` of (trust, voice's force) and returns what was sent.
fn sent<const T: usize>(mut key: KeySafety, ticks: [(Trust, f64); T]) -> [f64; T] {
    ticks.map(|(trust, force)| key.step(trust, (force, 0.0), RAMPS, 1.0))
}

/// Returns a key that follows its voice and was last sent `force` (N).
fn following(force: f64) -> KeySafety {
    KeySafety { state: SafetyState::Following, sent: force, position: 0.0 }
}

#[track_caller]
fn check<const T: usize>(key: KeySafety, ticks: [(Trust, f64); T], expected: [f64; T]) {
    // Quarters and eighths are exact in binary, so these compare exactly.
    assert_eq!(
        sent(key, ticks).map(f64::to_bits),
        expected.map(f64::to_bits),
        "{:?}",
        sent(key, ticks)
    );
}

use Trust::{Fault, Fresh, NotThere, Trusted};

#[test]
fn every_trouble_sends_the_forces_of_its_row() {
    let four = following(4.0);
    // An outage is held one tick, and then faded to the safe force.
    check(four, [(NotThere, 9.0); 6], [4.0, 3.0, 2.0, 1.0, 0.0, 0.0]);
    // One missing tick is bridged, and the voice met half-way.
    check(four, [(NotThere, 4.0), (Trusted, 6.0), (Trusted, 7.0)], [4.0, 5.0, 7.0]);
    // The return takes as long as the outage and a tick, but no longer than the fade.
    let ticks = [(NotThere, 0.0), (NotThere, 0.0), (Trusted, 0.0), (Trusted, 0.0), (Trusted, 8.0)];
    check(four, ticks, [4.0, 3.0, 2.0, 1.0, 8.0]);
    check(KeySafety::SILENT, [(Trusted, 4.0); 5], [1.0, 2.0, 3.0, 4.0, 4.0]);
    // A fault reaches the safe force before the voice is felt again.
    let mut ticks = [(Trusted, 4.0); 10];
    ticks[0] = (Fault, f64::NAN);
    check(four, ticks, [4.0, 3.0, 2.0, 1.0, 0.0, 1.0, 2.0, 3.0, 4.0, 4.0]);
    // A fault within an outage continues its fade.
    let ticks = [(NotThere, 4.0), (NotThere, 4.0), (Fault, 4.0), (Trusted, 4.0), (NotThere, 4.0)];
    check(four, ticks, [4.0, 3.0, 2.0, 1.0, 0.0]);
    // A fresh voice is blended in from what was felt before.
    check(four, [(Fresh, 0.0), (Trusted, 0.0)], [3.0, 2.0]);
    check(four, [(NotThere, 0.0), (Fresh, 0.0), (Trusted, 0.0)], [4.0, 3.0, 2.0]);
    // Forces too large to blend become the safe force.
    check(following(f64::MAX), [(Fresh, -f64::MAX)], [0.0]);
}

#[test]
fn trouble_on_the_way_back_starts_from_what_is_felt_and_goes_on_no_faster() {
    let back = |done, sent| {
        let state = SafetyState::Returning { from: 0.0, done, of: 4 };
        KeySafety { state, sent, position: 0.0 }
    };
    check(back(2, 4.0), [(NotThere, 8.0), (NotThere, 8.0)], [4.0, 3.0]);
    check(back(2, 4.0), [(Fault, 8.0), (Trusted, 8.0)], [4.0, 3.0]);
    check(back(2, 4.0), [(Fresh, 8.0), (Trusted, 8.0)], [5.0, 6.0]);
    check(back(2, 4.0), [(Trusted, 8.0), (Trusted, 8.0)], [6.0, 8.0]);
    // A return that was cut short.
    let ticks = [(NotThere, 8.0), (Trusted, 8.0), (Trusted, 8.0), (Trusted, 8.0)];
    check(back(1, 2.0), ticks, [2.0, 4.0, 6.0, 8.0]);
}

#[test]
fn a_held_force_hands_out_no_more_than_a_spring_stores_however_fast_the_key_comes_up() {
    let ramps = Ramps { fade_ticks: 20, reach: f64::INFINITY };
    for (force, speed) in [(1.0, 0.05), (5.0, 1.0), (25.0, 0.2), (25.0, 3.0), (-25.0, -1.0)] {
        let mut key = KeySafety { position: 0.01, ..following(force) };
        let (mut given, mut last, mut position) = (0.0, force, 0.01);
        for _ in 0..30 {
            position -= speed * 1e-3;
            // The force sent is felt until the next tick.
            given += last * speed * 1e-3;
            let sent = key.step(NotThere, (9.0, position), ramps, 1.0);
            assert!(sent * force >= 0.0 && sent.abs() <= last.abs());
            last = sent;
        }
        let stored = force * force / (2.0 * RELAXATION);
        let of_a_tick = force * speed * 1e-3;
        assert!(given <= stored + of_a_tick, "{force} N at {speed} m/s: {given} J of {stored} J");
        assert_eq!(last.to_bits(), 0.0_f64.copysign(last).to_bits());
    }
}

#[test]
fn a_held_force_against_which_the_key_moves_falls_by_the_time_alone() {
    let mut key = following(4.0);
    let sent = [1e-3, 2e-3, 3e-3].map(|down| key.step(NotThere, (0.0, down), RAMPS, 1.0));
    assert_eq!(sent.map(f64::to_bits), [4.0, 3.0, 2.0].map(f64::to_bits));
    assert!((key.step(NotThere, (0.0, f64::NAN), RAMPS, 1.0) - 1.0).abs() < 1e-12);
}

#[test]
fn a_voice_that_moved_on_during_an_outage_is_met_at_the_slew_limit() {
    // The voice went from 10 N to -25 N, 20 N a tick, while one sample was missing: half-way
    // back is 17.5 N away, and the rest must not come in one tick with the voice's own change.
    let ramps = Ramps { fade_ticks: N, reach: 20.0 };
    let mut key = following(25.0);
    let ticks = [(NotThere, 5.0), (Trusted, -15.0), (Trusted, -25.0), (Trusted, -25.0)];
    let sent = ticks.map(|(trust, force)| key.step(trust, (force, 0.0), ramps, 1.0));
    assert_eq!(sent.map(f64::to_bits), [25.0, 5.0, -15.0, -25.0].map(f64::to_bits), "{sent:?}");
}

fn safety() -> Safety {
    Safety::new(Period::from_hz(200).unwrap(), f64::INFINITY)
}

/// The force sent to key 7 for `turn` and a sample of `age`, after it followed 4 N.
fn sent_for(turn: &VoiceOutput, age: u32, skipped: u64) -> f64 {
    let mut safety = safety();
    let mut samples = [KeySample::default(); KEYS];
    let mut turns = [VoiceOutput::default(); KEYS];
    let mut forces = [0.0; KEYS];
    turns[7].force = 4.0;
    for _ in 0..=N {
        safety.apply(0, &samples, &turns, &mut forces);
    }
    samples[7].age = age;
    turns[7] = *turn;
    safety.apply(skipped, &samples, &turns, &mut forces);
    forces[7]
}

#[track_caller]
fn check_sent(turn: &VoiceOutput, age: u32, skipped: u64, expected: f64) {
    let force = sent_for(turn, age, skipped);
    assert!((force - expected).abs() == 0.0, "sent {force} N, expected {expected} N");
}

#[test]
fn what_is_known_of_a_turn_decides_its_row() {
    let eight = VoiceOutput { force: 8.0, ..VoiceOutput::default() };
    check_sent(&eight, 0, 0, 8.0);
    check_sent(&eight, MAX_EXTRAPOLATED, 0, 8.0);
    check_sent(&eight, MAX_EXTRAPOLATED + 1, 0, 4.0);
    check_sent(&VoiceOutput { late: true, ..eight }, 0, 0, 4.0);
    check_sent(&VoiceOutput { fresh: true, ..eight }, 0, 0, 5.0);
    check_sent(&VoiceOutput { fault: Some(VoiceFault::BadSample), ..eight }, 0, 0, 4.0);
    check_sent(&VoiceOutput { force: f64::NAN, ..eight }, 0, 0, 4.0);
    check_sent(&VoiceOutput { force: f64::INFINITY, ..eight }, 0, 0, 4.0);
}

#[test]
fn a_disarmed_keybed_fades_and_comes_back_when_armed() {
    let mut safety = safety();
    let samples = [KeySample::default(); KEYS];
    let turns = [VoiceOutput { force: 4.0, ..VoiceOutput::default() }; KEYS];
    let mut forces = [0.0; KEYS];
    let mut after = |safety: &mut Safety, ticks: u32| {
        (0..ticks).for_each(|_| {
            safety.apply(0, &samples, &turns, &mut forces);
        });
        forces
    };
    assert_eq!(after(&mut safety, N).map(f64::to_bits), [4.0; KEYS].map(f64::to_bits));
    safety.disarm();
    assert_eq!(after(&mut safety, N + 1).map(f64::to_bits), [0.0; KEYS].map(f64::to_bits));
    safety.arm();
    assert_eq!(after(&mut safety, N).map(f64::to_bits), [4.0; KEYS].map(f64::to_bits));
}

/// Largest force of a voice in the properties below (N).
const LIMIT: f64 = 10.0;

fn any_trust() -> impl Strategy<Value = Trust> {
    prop_oneof![6 => Just(Trusted), 1 => Just(Fresh), 2 => Just(NotThere), 1 => Just(Fault)]
}

fn any_force() -> impl Strategy<Value = f64> {
    prop_oneof![
        8 => -LIMIT..LIMIT,
        1 => prop_oneof![Just(f64::NAN), Just(f64::INFINITY), Just(f64::NEG_INFINITY)],
    ]
}

proptest! {
    #[test]
    fn what_is_sent_is_finite_and_no_larger_than_the_voice_allows(
        ticks in prop::collection::vec((any_trust(), any_force()), 1..200),
    ) {
        let mut key = KeySafety::SILENT;
        for (trust, force) in ticks {
            let trust = if force.is_finite() { trust } else { Fault };
            let sent = key.step(trust, (force, 0.0), RAMPS, 1.0);
            assert!(sent.is_finite());
            // Two roundings of a blend may leave the range by two units in the last place.
            assert!(sent.abs() <= LIMIT * (1.0 + 2.0 * f64::EPSILON));
        }
    }

    #[test]
    fn no_trouble_makes_the_force_faster_than_the_slew_limit_or_the_fade(
        ticks in prop::collection::vec((any_trust(), -LIMIT..LIMIT), 1..200),
        reach in 0.01..5.0_f64,
        fade_ticks in 2..40_u32,
    ) {
        let mut key = KeySafety::SILENT;
        let mut last = 0.0;
        for (trust, force) in ticks {
            let sent = key.step(trust, (force, 0.0), Ramps { fade_ticks, reach }, 1.0);
            let allowed = reach.max(LIMIT / f64::from(fade_ticks));
            assert!((sent - last).abs() <= allowed + 1e-12, "{last} N to {sent} N, allowed {allowed} N");
            last = sent;
        }
    }

    #[test]
    fn lasting_trouble_is_at_the_safe_force_within_the_fade(
        before in prop::collection::vec((any_trust(), -LIMIT..LIMIT), 0..50),
        hz in 50..10_000_u32,
        fault_first in any::<bool>(),
    ) {
        let period = Period::from_hz(hz).unwrap();
        let ramps = Ramps::new(period, 1e3);
        let fade_ticks = ramps.fade_ticks;
        assert!(period.span(u64::from(fade_ticks)) <= FADE);
        let mut key = KeySafety::SILENT;
        for (trust, force) in before {
            key.step(trust, (force, 0.0), ramps, 1.0);
        }
        for tick in 0..fade_ticks {
            let fault = fault_first != (tick % 3 == 2);
            key.step(if fault { Fault } else { NotThere }, (5.0, 0.0), ramps, 1.0);
        }
        let sent = key.step(NotThere, (5.0, 0.0), ramps, 1.0);
        assert!(sent.abs() == 0.0, "{sent} N after the fade");
    }
}
