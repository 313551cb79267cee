//! Case C5: guards that are zero, or nearly so, at the start.
//!
//! Error model: a guard counts as zero within 16 roundings at its size. A guard without a first or
//! second derivative is seen to turn only where tᵖ leaves that band: (16 ε)^⅓ for t³, which is
//! 1.5e-5. Any other root is located to 2⁻⁴⁰ of the tick.

use pode::{Advance, GuardId, GuardValue, RunRecorder};

use crate::common::{ONE, Timed, close, count, count_and_flip, no_input};

const TICKS: [u32; 4] = [1, 10, 143, 1000];

const LOCATED: f64 = 9.1e-13;

fn v(value: f64, rate: f64) -> GuardValue {
    GuardValue::new(value, rate)
}

/// A guard, and the times of its events with their tolerance.
type Row = (&'static str, fn(GuardId, f64) -> GuardValue, &'static [f64], f64);

#[test]
fn a_guard_that_is_zero_at_the_start_fires_where_it_falls() {
    let visible = (16.0 * f64::EPSILON).cbrt();
    let rows: [Row; 11] = [
        ("on its way up: silent", |_, t| v(t, 1.0), &[], 0.0),
        ("on its way down: at once", |_, t| v(-t, -1.0), &[0.0], 0.0),
        ("a parabola that opens upwards", |_, t| v(t * t, 2.0 * t), &[], 0.0),
        ("a parabola that opens downwards", |_, t| v(-t * t, -2.0 * t), &[0.0], 0.0),
        ("a cubic that rises", |_, t| v(t.powi(3), 3.0 * t * t), &[], 0.0),
        ("a cubic that falls", |_, t| v(-t.powi(3), -3.0 * t * t), &[0.0], 1.01 * visible),
        ("rises and falls", |_, t| v(t * (0.5 - t), 0.5 - 2.0 * t), &[0.5], LOCATED),
        ("rests and rises", |_, t| v((t - 0.1).max(0.0), f64::from(t > 0.1)), &[], 0.0),
        ("rests and falls", |_, t| v(-(t - 0.1).max(0.0), -f64::from(t > 0.1)), &[0.1], LOCATED),
        ("negative by rounding, and rises", |_, t| v(-1e-17 + t, 1.0), &[], 0.0),
        ("positive by rounding, and falls", |_, t| v(1e-17 - t, -1.0), &[0.0], 1e-17),
    ];
    for (what, guard, expected, tolerance) in rows {
        let timed = Timed { guards: &ONE, guard, effect: count };
        timed.check_times(what, TICKS, expected, tolerance);
    }
}

/// Moves to the negated guard, t − 0.5, two roundings below its zero.
fn land_short(id: GuardId, x: &mut [f64; 3]) -> bool {
    x[0] = 0.5 - 2.0 * f64::EPSILON;
    count_and_flip(id, x)
}

#[test]
fn a_reset_that_leaves_its_guard_two_ulps_short_does_not_fire_again() {
    let guard = |_: GuardId, t: f64| GuardValue::new(0.5 - t, -1.0);
    let timed = Timed { guards: &ONE, guard, effect: land_short };
    timed.check_times("two ulps short", TICKS, &[0.5], 1e-12);
}

#[test]
fn a_guard_entered_below_zero_that_rises_and_dips_within_a_step_fires_at_the_dip() {
    const FALLS: [pode::GuardSpec; 1] = [ONE[0].on_crossing()];
    // (t − .2)(t − .4)(t − .8): below, above from 0.2 on, below from 0.4 to 0.8, above.
    let guard = |_: GuardId, t: f64| {
        let (a, b, c) = (t - 0.2, t - 0.4, t - 0.8);
        GuardValue::new(a * b * c, b * c + a * c + a * b)
    };
    let timed = Timed { guards: &FALLS, guard, effect: count };
    timed.check_times("the dip", TICKS, &[0.4], 1e-14);
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
