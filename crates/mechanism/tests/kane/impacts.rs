use pode::{Model as _, Motion};

use crate::kane::runnable::{BALL, CART, WALL, guard, mode};
use crate::kane::stroke::{bells, run, sine, still};

const T1: f64 = 0.451_523_640_985_730_9;

#[track_caller]
fn check_drop(e: f64, h: f64, floor: f64) {
    let model = BALL.model::<2>("default", 0, &[("restitution", e)]);
    let start = model.at_rest(&still(floor));
    assert_eq!(start, (mode(&model, "flight"), [floor + 1.0, 0.0]));
    let end = T1 * (1.0 + e) / (1.0 - e);
    let (audited, ball) = run(&model, start, (h, end + 0.5), |_| still(floor));
    for (n, event) in (1..=10).zip(&audited.events) {
        let expected = T1 * (1.0 + 2.0 * e * (1.0 - e.powi(n - 1)) / (1.0 - e));
        let error = (event.t - expected).abs();
        assert!(error < 1e-12, "e {e}, h {h}: bounce {n} is off by {error:e} s");
    }
    let last = audited.events.last().expect("an end");
    assert_eq!((last.name, last.after.0), ("settled", mode(&model, "rest")));
    assert!((last.t - end).abs() < 1e-9, "settled at {} instead of {end}", last.t);
    let impulse: f64 = audited.events.iter().map(|event| event.impulse).sum();
    let expected = (2.0 * 9.81_f64).sqrt() * (1.0 + e) / (1.0 - e);
    assert!((impulse / expected - 1.0).abs() < 1e-9, "impulse {impulse}, not {expected}");
    assert_eq!(ball.state(), &[floor, 0.0]);
    assert_eq!(audited.ticks.last().expect("a tick").mean_readout, 9.81);
}

#[test]
fn a_dropped_ball_bounces_at_its_times_and_comes_to_rest() {
    for e in [0.5, 0.8, 0.9] {
        for h in [1e-4, 1e-3, 7e-3] {
            check_drop(e, h, 0.0);
        }
    }
    check_drop(0.8, 1e-3, 0.01);
}

/// Case C2: amplitude (m) and angular frequency (rad/s) of the shaker.
const SHAKER: (f64, f64) = (2e-3, 40.0 * core::f64::consts::PI);

#[test]
fn a_shaken_ball_lifts_off_and_lands_at_the_given_times() {
    for h in [1e-4, 1e-3, 7e-3] {
        let model = BALL.model::<2>("default", 0, &[("y0", 0.0)]);
        let input = |t| sine(SHAKER.0, SHAKER.1, t);
        let (audited, _) = run(&model, (mode(&model, "rest"), [0.0, 0.0]), (h, 0.056), input);
        assert_eq!(audited.names()[..2], ["lift", "floor"], "h {h}");
        let (lift, landing) = (&audited.events[0], &audited.events[1]);
        let speed = landing.before.1[1] - landing.input.rate;
        assert!((lift.t - 0.002_513_355_797_052_246).abs() < 1e-14, "lift-off at {}", lift.t);
        // The flight is a parabola: the error is the rounding of lift-off, grown over a flight of
        // 50 ms from a guard with a triple zero.
        assert!((landing.t - 0.051_865_286_988_733_95).abs() < 1e-13, "landing at {}", landing.t);
        assert!((speed + 0.489_701_201_981_647_3).abs() < 1e-11, "landing at {speed} m/s");
    }
}

#[test]
fn a_ball_on_a_shaker_is_never_below_it_and_no_impact_makes_energy() {
    for e in [0.0, 0.3, 0.8, 1.0] {
        let model = BALL.model::<2>("default", 0, &[("y0", 0.0), ("restitution", e)]);
        let input = |t| sine(SHAKER.0, SHAKER.1, t);
        let (audited, _) = run(&model, (mode(&model, "rest"), [0.0, 0.0]), (1e-3, 5.0), input);
        assert!(audited.generated < 1e-14, "an impact made {:e} J", audited.generated);
        for event in &audited.events {
            let gap = event.after.1[0] - event.input.position;
            assert!(gap > -1e-13, "e {e}: the ball is {gap:e} m deep at {}", event.t);
        }
    }
}

#[test]
fn a_floor_that_jumps_into_the_ball_carries_it() {
    let model = BALL.model::<2>("key", 0, &[]);
    let input = |t: f64| still(if t > 0.010_5 { 0.02 } else { 0.0 });
    let (audited, ball) = run(&model, (mode(&model, "rest"), [0.0, 0.0]), (1e-3, 0.1), input);
    assert_eq!((ball.mode(), *ball.state()), (mode(&model, "rest"), [0.02, 0.0]));
    let (landed, flight) = run(&model, (mode(&model, "flight"), [0.01, 0.5]), (1e-3, 1.0), |t| {
        still(if t > 0.0 { 0.02 } else { 0.0 })
    });
    assert!(audited.generated <= 0.0 || audited.events.is_empty());
    assert_eq!((flight.mode(), *flight.state()), (mode(&model, "rest"), [0.02, 0.0]));
    assert_eq!(landed.events.last().expect("an end").name, "settled");
}

#[test]
fn a_ball_weighs_half_a_newton_on_the_finger() {
    let model = BALL.model::<2>("key", 0, &[]);
    let (mode, x) = model.at_rest(&still(0.0));
    let force = model.readout(mode, &x, &still(0.0)) * model.input_per_metre();
    assert!((force - 0.4905).abs() < 1e-12, "{force} N");
}

#[test]
fn the_wall_pushes_back_and_never_pulls() {
    let model = WALL.model::<1>("default", 0, &[("K", 2000.0), ("B", 30.0)]);
    let input = |t| bells(&[[0.012, 0.1, 0.03]], t);
    let (audited, _) = run(&model, (mode(&model, "free"), [0.0]), (1e-3, 0.2), input);
    assert_eq!(audited.names(), ["touch", "leave"]);
    let half = 0.03 * (0.012_f64 / 0.005).ln().sqrt();
    for (event, expected) in audited.events.iter().zip([0.1 - half, 0.1 + half]) {
        assert!((event.t - expected).abs() < 1e-14, "{} at {}", event.name, event.t);
    }
    assert!(audited.ticks.iter().all(|tick| tick.mean_readout >= 0.0 && tick.end_readout >= 0.0));
    let peak = audited.ticks.iter().map(|tick| tick.end_readout).fold(0.0, f64::max);
    assert!(peak > 14.0, "{peak} N at least: 7 mm into 2 kN/m");
    // The finger's work went into the damper, and none is left in the wall. The force has a kink
    // where it would begin to pull, over which Simpson's rule is of second order.
    assert!(audited.audit.dissipated > 0.0);
    assert!(audited.audit.integration.abs() < 1e-6, "residual {:e} J", audited.audit.integration);
    assert!(audited.audit.stored.abs() < 1e-15);
}

#[test]
fn a_cart_without_a_pendulum_to_speak_of_settles_like_a_ball() {
    // The spring pulls with k (s − x) = 10 N at the wall, and hardly less on the way.
    let changes = [("bob_mass", 1e-9), ("k", 1e-3), ("g", 0.0), ("right", 0.05)];
    let model = CART.model::<4>("default", 0, &changes);
    let start = (mode(&model, "free"), [0.0; 4]);
    let (audited, cart) = run(&model, start, (1e-3, 1.0), |_| still(1e4));
    let last = audited.events.last().expect("an end");
    assert_eq!((last.name, cart.mode()), ("settled", mode(&model, "right")));
    let fall = (2.0_f64 * 0.05 / 10.0).sqrt();
    let expected = fall * 1.7 / 0.3;
    // s, 10 km away, pulls by 5e-6 parts less at the wall than at the start.
    assert!((last.t - expected).abs() < 1e-5 * expected, "settled at {}", last.t);
    assert!((cart.state()[0] - 0.05).abs() < 1e-15);
}

#[test]
fn a_held_cart_comes_off_when_the_spring_lets_it() {
    let model = CART.model::<4>("key", 0, &[("b", 0.0)]);
    let start = model.at_rest(&still(0.05));
    assert_eq!(start.0, mode(&model, "right"));
    // s falls linearly through the wall's position at 0.1 s; the pendulum hangs still.
    let input = |t: f64| Motion { position: 0.05 - 0.1 * t, rate: -0.1, ..Motion::default() };
    let (audited, cart) = run(&model, start, (1e-3, 0.15), input);
    assert_eq!(audited.names(), ["off"]);
    assert!((audited.events[0].t - 0.1).abs() < 1e-14, "off at {}", audited.events[0].t);
    assert_eq!(cart.mode(), mode(&model, "free"));
}

#[test]
fn a_cart_that_is_pressed_against_a_wall_does_not_chatter() {
    let model = CART.model::<4>("key", 0, &[]);
    // The key moves to its bottom and back, once a second.
    let input = |t: f64| {
        let wave = sine(0.025, 2.0 * core::f64::consts::PI, t);
        Motion { position: wave.position + 0.025, ..wave }
    };
    let start = (mode(&model, "free"), [0.025, 0.0, 0.0, 0.0]);
    let (audited, _) = run(&model, start, (1e-3, 5.0), input);
    assert!(audited.generated < 1e-15, "an impact made {:e} J", audited.generated);
    // The move to the end of the bounces takes a part of a tick, in which the pendulum swings on
    // by a parabola: third order in that part.
    assert!(audited.generated_settling < 1e-9, "settling made {:e} J", audited.generated_settling);
    assert!(audited.events.len() < 2000, "{} events in 5 s", audited.events.len());
    assert!(audited.names().contains(&"settled"), "it never came to rest at the wall");
    assert!(audited.names().contains(&"off"), "it never came off the wall");
}

#[test]
fn only_the_carts_walls_sound() {
    let model = CART.model::<4>("key", 0, &[]);
    for (name, of, expected) in [
        ("left", "free", Some(1.5)),
        ("right", "free", Some(1.5)),
        ("off", "left", None),
        ("off", "right", None),
    ] {
        let id = guard(&model, mode(&model, of), name);
        assert_eq!(model.sounding(id, &[0.0, 0.0, -1.5, 0.0]), expected, "{name} of {of}");
    }
}
