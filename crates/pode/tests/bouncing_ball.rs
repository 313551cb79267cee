//! Case C1: a ball on a floor, whose bounces accumulate (Zeno).
//!
//! The flow is a parabola, which RK4 and its dense output follow exactly: what is
//! left is rounding, a few ulps of the time per bounce.

use pode::Limits;

use crate::common::{Ball, BallMode, G, all_completed, close, each_step_and_phase, no_input, run};

/// t1 = √(2/g), from 40-digit arithmetic.
const T1: f64 = 0.451_523_640_985_730_9;

/// The time of the `n`-th bounce from 1 m.
fn bounce(n: i32, e: f64) -> f64 {
    T1 * (1.0 + 2.0 * e * (1.0 - e.powi(n - 1)) / (1.0 - e))
}

#[test]
fn the_closed_form_agrees_with_the_given_digits() {
    assert!((bounce(10, 0.8) - 3.578_892_951_020_438).abs() < 1e-14);
    assert!((bounce(2, 0.9) - 1.264_266_194_760_046_5).abs() < 1e-14);
}

#[test]
fn the_first_ten_bounces_are_at_their_times() {
    for e in [0.5, 0.8, 0.9] {
        each_step_and_phase(|h, phase| check_bounces(e, h, phase));
    }
}

#[track_caller]
fn check_bounces(e: f64, h: f64, phase: f64) {
    let mut ball = Ball::dropped(e, 1.0, Limits::default());
    let settled = T1 * (1.0 + e) / (1.0 - e);
    let (recorder, ticks) = run(&mut ball, h, phase, settled + 1.0);
    for (n, seen) in (1..=10).zip(recorder.events()) {
        close(format_args!("e {e}, h {h}, phase {phase}: bounce {n}"), seen.t, bounce(n, e), 1e-12);
    }
    let last = &recorder.events()[recorder.events().len() - 1];
    assert_eq!((last.name, last.to), ("settled", BallMode::Rest), "e {e}, h {h}");
    close("settled", last.t, settled, 1e-9);
    all_completed(&ticks);
    // What the floor gave: every impact, then the weight.
    let impulse: f64 = ticks.iter().map(|tick| tick.impulse).sum();
    let expected = (2.0 * G).sqrt() * (1.0 + e) / (1.0 - e);
    close("impulse", impulse, expected, 1e-9 * expected);
    close("weight", ticks[ticks.len() - 1].mean_readout, G, 1e-15 * G);
    assert_eq!(ball.state().map(f64::to_bits), [0, 0], "at rest on the floor");
}

#[test]
fn the_ball_never_sinks() {
    let mut ball = Ball::dropped(0.8, 1.0, Limits::default());
    for _ in 0..5000 {
        let _ = ball.advance(1e-3, &no_input, &mut pode::Silent);
        assert!(ball.state()[0] >= -1e-14, "the ball is at {}", ball.state()[0]);
    }
}

#[test]
fn an_elastic_ball_keeps_its_energy_over_1e5_bounces() {
    let mut ball = Ball::dropped(1.0, 1.0, Limits::default());
    let mut bounces = 0;
    while bounces < 100_000 {
        bounces += ball.advance(7e-3, &no_input, &mut pode::Silent).work.events;
    }
    let [y, v] = *ball.state();
    let drift = (y * G + 0.5 * v * v) / G - 1.0;
    assert!(drift.abs() < 1e-10, "relative drift {drift:e}");
}
