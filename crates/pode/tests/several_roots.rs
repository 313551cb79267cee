//! Case C6: several roots within a step.

use pode::{GuardId, GuardValue};

use crate::common::{ON_CROSSING, Timed, count};

#[track_caller]
fn check(guard: fn(GuardId, f64) -> GuardValue, effect: Effect, expected: &[f64]) {
    let timed = Timed { guards: &ON_CROSSING, guard, effect };
    // Rounding of the guard, 1e-16, over its slope at the root, 0.08 at least.
    timed.check_times("roots", [1, 3, 10, 1000], expected, 1e-14);
}

type Effect = fn(GuardId, &mut [f64; 3]) -> bool;

/// Negated, for a mode is valid while its guard is positive.
fn three(_: GuardId, t: f64) -> GuardValue {
    let (a, b, c) = (t - 0.2, t - 0.4, t - 0.8);
    GuardValue::new(-a * b * c, -(b * c + a * c + a * b))
}

#[test]
fn the_first_of_three_roots_is_the_event() {
    check(three, count, &[0.2, 0.8]);
}

fn pair(_: GuardId, t: f64) -> GuardValue {
    GuardValue::new(0.06 - t * (0.5 - t), -0.5 + 2.0 * t)
}

#[test]
fn a_pair_of_roots_inside_a_step_is_found() {
    check(pair, count, &[0.2]);
}

#[test]
fn a_pair_of_roots_leaves_a_mode_and_comes_back() {
    check(pair, crate::common::count_and_flip, &[0.2, 0.3]);
}
