use core::f64::consts::TAU;

use haptics::{
    FingerParameters, Gesture, Grasp, KeyParameters, KeyRig, MuscleCommand, RigParameters, Touch,
};
use proptest::prelude::*;

/// Period of the tick (s).
const PERIOD: f64 = 1e-3;

fn gesture(touch: Touch, speed: f64, release: f64) -> Gesture {
    Gesture { start: 0.01, release, touch, speed, ..Gesture::USUAL }
}

fn run(rig: &mut KeyRig, from: u32, to: u32, force: f64, gesture: Option<&Gesture>) {
    for tick in from..to {
        rig.advance(f64::from(tick) * PERIOD, PERIOD, force, gesture);
    }
}

#[test]
fn without_a_finger_an_upward_force_keeps_the_key_at_its_rest() {
    let mut rig = KeyRig::new(RigParameters::default());
    run(&mut rig, 0, 200, 0.5, None);
    assert!((-0.62 / 6e4..=-0.38 / 6e4).contains(&rig.position()), "{}", rig.position());
    assert!(rig.is_still());
}

#[test]
fn a_key_that_is_still_is_not_changed_by_a_tick() {
    let mut rig = KeyRig::new(RigParameters::default());
    let press = gesture(Touch::Pressed, 0.3, 0.2);
    let mut still = 0;
    for tick in 0..600 {
        let before = rig;
        let skip = rig.is_still();
        let playing = press.is_active(f64::from(tick) * PERIOD);
        rig.advance(f64::from(tick) * PERIOD, PERIOD, 0.5, playing.then_some(&press));
        if skip && tick > 0 && !playing {
            assert_eq!(rig, before, "tick {tick}");
            still += 1;
        }
    }
    assert!(still > 200, "{still} still ticks");
}

#[test]
fn a_held_key_lies_on_its_bottom_under_two_newtons() {
    let mut rig = KeyRig::new(RigParameters::default());
    run(&mut rig, 0, 800, 0.5, Some(&gesture(Touch::Pressed, 0.3, 2.0)));
    assert!(rig.velocity() == 0.0);
    assert!((10.16e-3..10.20e-3).contains(&rig.position()), "{}", rig.position());
    // Muscle and pulp in series, from the hold depth to the key's position.
    let series = 1.0 / (1.0 / 400.0 + 1.0 / 4000.0);
    let expected = series * (Gesture::HOLD - rig.position());
    assert!((rig.finger_force() - expected).abs() < 1e-6, "{}", rig.finger_force());
}

#[test]
fn a_finger_that_lifts_fast_leaves_the_key_behind() {
    let mut rig = KeyRig::new(RigParameters::default());
    let press = gesture(Touch::Pressed, 0.3, 0.5);
    run(&mut rig, 0, 500, 0.3, Some(&press));
    assert!(rig.finger_force() > 1.0);
    run(&mut rig, 500, 525, 0.3, Some(&press));
    // Without the finger's push 0.6 N less friction lift 40 g by 3.9 mm in 25 ms at most.
    assert!(rig.finger_force() == 0.0, "{}", rig.finger_force());
    assert!(rig.position() > 10.16e-3 - 3.9e-3 && rig.velocity() < 0.0, "{rig:?}");
    run(&mut rig, 525, 1000, 0.3, Some(&press));
    assert!(rig.is_still() && rig.position() < 0.0);
}

/// Returns the time of the key from its bottom to 1 mm below its rest under `force` (N) (s).
fn return_time(force: f64) -> f64 {
    let mut rig = KeyRig::new(RigParameters::default());
    let press = Gesture { lift: 0.01, ..gesture(Touch::Pressed, 0.3, 0.5) };
    run(&mut rig, 0, 500, force, Some(&press));
    let mut left_bottom = None;
    for step in 0..2000_u32 {
        let (t, h) = (0.5 + f64::from(step) * 1e-4, 1e-4);
        rig.advance(t, h, force, press.is_active(t).then_some(&press));
        if left_bottom.is_none() && rig.position() < 10.16e-3 {
            left_bottom = Some(t);
        }
        if rig.position() < 1e-3 {
            return t - left_bottom.unwrap_or(0.5);
        }
    }
    f64::INFINITY
}

#[test]
fn a_key_that_is_let_go_returns_nearly_as_fast_as_a_grand_s() {
    // Measured on grands: 35 ms, under a return force of at least 0.2 N.
    for (force, time) in [(0.2, 0.050), (0.35, 0.042), (0.5, 0.037)] {
        let found = return_time(force);
        assert!((0.03..time).contains(&found), "{found} s under {force} N");
    }
}

#[test]
fn a_struck_finger_meets_the_key_at_nearly_its_speed() {
    for speed in [0.1, 0.5, 1.0, 3.0] {
        let mut rig = KeyRig::new(RigParameters::default());
        let strike = gesture(Touch::Struck, speed, 10.0);
        let touched = (0..4000).find(|&tick| {
            run(&mut rig, tick, tick + 1, 0.5, Some(&strike));
            rig.finger_force() > 0.0
        });
        // The muscle lags behind a fast run-up: up to a tick and 1.5 mm late.
        let late = f64::from(touched.unwrap() + 1) * PERIOD - strike.arrival();
        assert!((0.0..PERIOD + 1.5e-3 / speed).contains(&late), "{late} s late at {speed} m/s");
    }
}

#[test]
fn another_gesture_is_another_finger() {
    let mut rig = KeyRig::new(RigParameters::default());
    run(&mut rig, 0, 300, 0.5, Some(&gesture(Touch::Pressed, 0.3, f64::INFINITY)));
    assert!(rig.finger_force() > 1.0);
    let next = Gesture { start: 0.3, ..gesture(Touch::Struck, 0.3, f64::INFINITY) };
    run(&mut rig, 300, 301, 0.5, Some(&next));
    assert!(rig.finger_force() == 0.0 && rig.velocity() < 0.0, "{rig:?}");
    run(&mut rig, 301, 1000, 0.5, Some(&next));
    assert!(rig.finger_force() > 1.0);
    let released = Gesture { release: 1.0, ..next };
    run(&mut rig, 1000, 1051, 0.5, Some(&released));
    assert!(rig.finger_force() == 0.0);
    run(&mut rig, 1051, 1500, 0.5, None);
    assert!(rig.is_still());
}

/// Returns the speed of a key of `mass` (kg) at 9 mm, where an action lets off (m/s).
fn speed_at_let_off(mass: f64, touch: Touch, speed: f64) -> f64 {
    let ordinary = RigParameters::default();
    // An action loses as much by itself, and lifts its key.
    let key = KeyParameters { mass, damping: 2.0, weight: 0.0, ..ordinary.key };
    let mut rig = KeyRig::new(RigParameters { key, ..ordinary });
    let stroke = gesture(touch, speed, 1e3);
    for tick in 0..40_000_u32 {
        let h = 0.1 * PERIOD;
        rig.advance(f64::from(tick) * h, h, 0.5, Some(&stroke));
        if rig.position() > 9e-3 {
            return rig.velocity();
        }
    }
    0.0
}

#[track_caller]
fn check_rising(mass: f64, touch: Touch, slowest: f64) {
    let speeds = (0..=60).map(|i| slowest * (3.0 / slowest).powf(f64::from(i) / 60.0));
    let reached: Vec<f64> = speeds.map(|speed| speed_at_let_off(mass, touch, speed)).collect();
    assert!(reached.is_sorted_by(|slow, fast| slow < fast), "{mass} kg, {touch:?}: {reached:?}");
    // Pressed touch reaches about 4 m/s at the hammer, five times the key's.
    assert!(reached[0] < 1.5 * slowest && reached[60] > 0.8, "{mass} kg, {touch:?}: {reached:?}");
}

#[test]
fn a_key_as_heavy_as_an_action_is_faster_the_faster_it_is_pressed_or_struck() {
    for mass in [0.15, 0.28, 0.35] {
        check_rising(mass, Touch::Pressed, 0.02);
        check_rising(mass, Touch::Struck, 0.1);
    }
}

#[test]
fn a_copy_replays_the_same_bits() {
    let mut rig = KeyRig::new(RigParameters::default());
    let strike = gesture(Touch::Struck, 1.3, 0.15);
    let feel = |rig: &KeyRig| 0.5 + 40.0 * rig.position() + 3.0 * rig.velocity();
    let play = |rig: &mut KeyRig, ticks: core::ops::Range<u32>| -> Vec<[u64; 3]> {
        ticks
            .map(|tick| {
                rig.advance(f64::from(tick) * PERIOD, PERIOD, feel(rig), Some(&strike));
                [rig.position(), rig.velocity(), rig.finger_force()].map(f64::to_bits)
            })
            .collect()
    };
    play(&mut rig, 0..37);
    let mut rehearsal = rig;
    assert_eq!(play(&mut rehearsal, 37..400), play(&mut rig, 37..400));
    assert_eq!(rehearsal, rig);
}

#[test]
fn fingers_of_every_stiffness_come_to_rest_on_the_key() {
    for finger in [FingerParameters::STIFF, FingerParameters::LIMP] {
        let mut rig = KeyRig::new(RigParameters { finger, ..RigParameters::default() });
        run(&mut rig, 0, 3000, 0.02, Some(&gesture(Touch::Pressed, 0.3, 10.0)));
        assert!(rig.velocity() == 0.0 && rig.finger_force() > 0.0, "{rig:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn the_finger_never_pulls_and_the_key_stays_between_its_felts(
        speed in 0.02..3.0_f64,
        held in 0.0..0.4_f64,
        force in -2.0..20.0_f64,
        struck: bool,
    ) {
        let touch = if struck { Touch::Struck } else { Touch::Pressed };
        let stroke = gesture(touch, speed, 0.01 + held);
        let mut rig = KeyRig::new(RigParameters::default());
        for tick in 0..600 {
            run(&mut rig, tick, tick + 1, force, Some(&stroke));
            prop_assert!(rig.finger_force() >= 0.0);
            // Felts give way by speed · √(m/k), and by 50 N of push: 4 mm for 4 m/s.
            prop_assert!((-4e-3..14.2e-3).contains(&rig.position()), "{}", rig.position());
        }
    }
}

#[test]
fn a_hand_that_grips_leads_the_key_along_a_path_both_ways() {
    let grips = FingerParameters { grasp: Grasp::Grips, ..FingerParameters::STIFF };
    // A slow swing around the middle of the dip, 4 mm to both sides, after a second at rest there.
    let path = |t: f64| {
        let phase = TAU * (t - 1.0).max(0.0);
        let velocity = if t < 1.0 { 0.0 } else { 4e-3 * TAU * phase.cos() };
        MuscleCommand { position: 5e-3 + 4e-3 * phase.sin(), velocity }
    };
    let led = |finger: FingerParameters| {
        let mut rig = KeyRig::new(RigParameters { finger, ..RigParameters::default() });
        let mut astray = 0.0_f64;
        let mut pulled = 0.0_f64;
        for tick in 0..3000 {
            let t = f64::from(tick) * PERIOD;
            rig.follow(t, PERIOD, -1.0, path);
            if 1.0 < t {
                astray = astray.max((rig.position() - path(t + PERIOD).position).abs());
                pulled = pulled.min(rig.finger_force());
            }
        }
        (astray, pulled)
    };
    // The motor pulls down by 1 N, the return spring up by 0.3 N; friction and damping, 0.13 N,
    // help one in turn. The key lags by the remaining force over muscle and pulp in series.
    let (astray, pulled) = led(grips);
    assert!(astray < 0.85 / 981.0 && pulled < -0.5, "{astray} m, {pulled} N");
    assert!(led(FingerParameters::STIFF).1 >= 0.0);
}
