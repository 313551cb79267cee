//! Case C5: guards that are zero, or nearly so, at the start.
//!
//! Error model: a guard counts as zero within 16 roundings at its size. A guard without a first or
//! second derivative is seen to turn only where tᵖ leaves that band: (16 ε)^⅓ for t³, which is
//! 1.5e-5. Any other root is located to 2⁻⁴⁰ of the tick.

use pode::{Advance, GuardId, GuardValue, RunRecorder};

use crate::common::{ONE, Timed, close, count, count_and_flip, no_input};

const TICKS: [u32; 4] = [1, 10, 143, 1000];

const LOCATED: f64 = 9.1e-13;

#[track_caller]
fn check(guard: fn(GuardId, f64) -> GuardValue, expected: &[f64], tolerance: f64) {
    for n in TICKS {
        let times = fired(guard, n);
        assert_eq!(times.len(), expected.len(), "{n} ticks: {times:?} instead of {expected:?}");
        for (t, expected) in times.iter().zip(expected) {
            close(format_args!("{n} ticks"), *t, *expected, tolerance);
        }
    }
}

fn fired(guard: fn(GuardId, f64) -> GuardValue, n: u32) -> Vec<f64> {
    let h = 1.0 / f64::from(n);
    let mut timed = Timed { guards: &ONE, guard, effect: count }.start();
    let mut recorder = RunRecorder::new(h);
    for _ in 0..n {
        let tick = timed.advance(h, &no_input, &mut recorder);
        assert_eq!(tick.advance, Advance::Completed);
    }
    recorder.times()
}

#[test]
fn a_guard_on_its_way_up_is_silent() {
    check(|_, t| GuardValue::new(t, 1.0), &[], 0.0);
}

#[test]
fn a_guard_on_its_way_down_fires_at_once() {
    check(|_, t| GuardValue::new(-t, -1.0), &[0.0], 0.0);
}

#[test]
fn a_parabola_that_opens_upwards_is_silent() {
    check(|_, t| GuardValue::new(t * t, 2.0 * t), &[], 0.0);
}

#[test]
fn a_parabola_that_opens_downwards_fires_at_once() {
    check(|_, t| GuardValue::new(-t * t, -2.0 * t), &[0.0], 0.0);
}

#[test]
fn a_cubic_that_rises_is_silent() {
    check(|_, t| GuardValue::new(t.powi(3), 3.0 * t * t), &[], 0.0);
}

#[test]
fn a_cubic_that_falls_fires_where_rounding_lets_it_be_seen() {
    let visible = (16.0 * f64::EPSILON).cbrt();
    check(|_, t| GuardValue::new(-t.powi(3), -3.0 * t * t), &[0.0], 1.01 * visible);
}

#[test]
fn a_guard_that_rises_and_falls_fires_at_the_fall() {
    check(|_, t| GuardValue::new(t * (0.5 - t), 0.5 - 2.0 * t), &[0.5], LOCATED);
}

#[test]
fn a_guard_that_rests_at_zero_and_rises_is_silent() {
    check(|_, t| GuardValue::new((t - 0.1).max(0.0), f64::from(t > 0.1)), &[], 0.0);
}

#[test]
fn a_guard_that_rests_at_zero_and_falls_fires_at_the_fall() {
    check(|_, t| GuardValue::new(-(t - 0.1).max(0.0), -f64::from(t > 0.1)), &[0.1], LOCATED);
}

#[test]
fn a_guard_that_is_negative_by_rounding_and_rises_is_silent() {
    check(|_, t| GuardValue::new(-1e-17 + t, 1.0), &[], 0.0);
}

#[test]
fn a_guard_that_is_positive_by_rounding_and_falls_fires_at_once() {
    check(|_, t| GuardValue::new(1e-17 - t, -1.0), &[0.0], 1e-17);
}

/// Moves to the negated guard, t − 0.5, two roundings below its zero.
fn land_short(id: GuardId, x: &mut [f64; 3]) -> bool {
    x[0] = 0.5 - 2.0 * f64::EPSILON;
    count_and_flip(id, x)
}

#[test]
fn a_reset_that_leaves_its_guard_two_ulps_short_does_not_fire_again() {
    for n in TICKS {
        let guard = |_: GuardId, t: f64| GuardValue::new(0.5 - t, -1.0);
        let mut timed = Timed { guards: &ONE, guard, effect: land_short }.start();
        let mut recorder = RunRecorder::new(1.0 / f64::from(n));
        for _ in 0..n {
            let _ = timed.advance(1.0 / f64::from(n), &no_input, &mut recorder);
        }
        assert_eq!(recorder.events().len(), 1, "{n} ticks: {:?}", recorder.events());
    }
}

#[test]
fn a_guard_entered_below_zero_that_rises_and_dips_within_a_step_fires_at_the_dip() {
    const FALLS: [pode::GuardSpec; 1] = [ONE[0].on_crossing()];
    // (t − .2)(t − .4)(t − .8): below, above from 0.2 on, below from 0.4 to 0.8, above.
    let guard = |_: GuardId, t: f64| {
        let (a, b, c) = (t - 0.2, t - 0.4, t - 0.8);
        GuardValue::new(a * b * c, b * c + a * c + a * b)
    };
    for n in TICKS {
        let mut timed = Timed { guards: &FALLS, guard, effect: count }.start();
        let mut recorder = RunRecorder::new(1.0 / f64::from(n));
        for _ in 0..n {
            let _ = timed.advance(1.0 / f64::from(n), &no_input, &mut recorder);
        }
        assert_eq!(recorder.events().len(), 1, "{n} ticks: {:?}", recorder.times());
        close(format_args!("{n} ticks"), recorder.events()[0].t, 0.4, 1e-14);
    }
}

#[test]
fn hops_lower_than_rounding_take_time_and_no_cascade() {
    // e = 1 and 2e-7 m/s: 2e-15 m high, below 16 ε of 1 m, and 41 ns long.
    let speed = 2e-7;
    let hop = 2.0 * speed / crate::common::G;
    let mut ball = crate::common::Ball::dropped(1.0, 0.0, pode::Limits::default());
    ball.place(crate::common::BallMode::Flight, [0.0, speed]);
    let mut recorder = RunRecorder::new(1e-7);
    for _ in 0..10 {
        assert_eq!(ball.advance(1e-7, &no_input, &mut recorder).advance, Advance::Completed);
    }
    close("the first hop", recorder.events()[0].t, hop, 1e-9 * hop);
    // A tick that ends in the air ends within rounding of the floor: the fall is seen at 16 ε
    // below, up to half a hop late.
    let (number, most) = (recorder.events().len() as f64, 1e-6 / hop);
    assert!(0.5 * most < number && number <= most, "{number} of {most}");
}
