//! A guard's forecast, carried from tick to tick (`[GC93]` 5.1): fewer evaluations in every tick,
//! the worst one included, and events where the method is most exact.

#![allow(
    clippy::fn_params_excessive_bools,
    clippy::expect_used,
    clippy::cast_possible_truncation,
    reason = "a test asks both ways, and fails aloud"
)]

use pode::stepper::Rk4;
use pode::{EquationKind, GuardSpec, GuardValue, Limits, Nature, Silent, Simulator, Work};

use crate::common::head::{CONTACTS, Head};
use crate::common::{G, OneMode, no_input, run};

/// A pendulum between a wall at its lowest point and seven more that it never reaches: angle (rad)
/// and its rate. |θ''| ≤ ω0² everywhere, which bounds every guard's curvature.
fn walled(is_bounded: bool) -> OneMode<(), 2> {
    const WALLS: [GuardSpec; 8] = {
        let mut walls = [GuardSpec::new(0, "wall").of_state(); 8];
        let mut n = 1;
        while n < 8 {
            walls[n] = GuardSpec::new(n as u8, "far wall").of_state();
            n += 1;
        }
        walls
    };
    OneMode {
        nature: Nature::new(EquationKind::Conservative, G.sqrt()),
        guards: &WALLS,
        guard: |(), id, x| match id.0 {
            0 => GuardValue::new(x[0], x[1]),
            _ => GuardValue::new(1.3 - x[0], -x[1]),
        },
        is_bounded,
        reset: |(), _, x| [0.0, -0.9 * x[1]],
        ..OneMode::new((), |(), x| [x[1], -G * x[0].sin()])
    }
}

/// Returns every event's time in 5 s at 1 ms, the work of the worst tick, and that of all.
fn swing(is_bounded: bool) -> (Vec<f64>, Work, Work) {
    let mut pendulum = walled(is_bounded).start(Rk4, [1.2, 0.0]);
    let (recorder, ticks) = run(&mut pendulum, 1e-3, 0.0, 5.0);
    crate::common::all_completed(&ticks);
    let worst = ticks.iter().skip(1).max_by_key(|tick| tick.work.guards).expect("a tick");
    let sum = ticks.iter().fold(Work::default(), |sum, tick| sum.plus(tick.work));
    (recorder.times(), worst.work, sum)
}

#[test]
fn far_guards_are_left_alone_and_every_tick_is_cheaper_the_worst_one_too() {
    let (times, worst, sum) = swing(true);
    let (plain_times, plain_worst, plain_sum) = swing(false);
    assert_eq!((times.len(), plain_times.len()), (5, 5));
    for (time, plain) in times.iter().zip(&plain_times) {
        crate::common::close("an impact", *time, *plain, 1e-12);
    }
    // Eight guards a tick, 5000 ticks; with a bound, each when its worst parabola comes near.
    assert!(plain_sum.guards > 40_000 && sum.guards < 2_000, "{plain_sum:?}\n{sum:?}");
    // The tick with the impact: all guards are evaluated again after it; before it and at the end
    // of the tick only the wall itself, with its two evaluations.
    assert!(plain_worst.guards >= 8 + 8 + 8 + 2, "{plain_worst:?}");
    assert!(worst.guards <= 1 + 3 + 8 + 1, "{worst:?}");
    assert_eq!(worst.derivatives, plain_worst.derivatives);
}

#[test]
fn bounded_guards_certify_their_steps() {
    let (_, _, sum) = swing(true);
    assert!(sum.unknown <= 5 && sum.certain > 4990, "{sum:?}");
    let (_, _, sum) = swing(false);
    assert_eq!(sum.certain, 0);
}

/// Returns the error of the exit speed of a contact of 1e5 N/m from `start` (s) before, in steps of
/// `radians`, and its derivatives.
fn exit_speed(radians: f64, start: f64, forecast: bool) -> (f64, u32) {
    let head = Head { k: CONTACTS[1][0] };
    let h = radians / head.omega();
    let limits = Limits { forecast, longest_step: h, ..Limits::default() };
    let (t, v) = (start * h, 1.0 - G * start * h);
    let at = [v * t + 0.5 * G * t * t, -v];
    let mut head = Simulator::new(head, Rk4, limits, crate::common::head::Mode::Flight, at);
    let mut recorder = pode::RunRecorder::new(h);
    let mut derivatives = 0;
    while recorder.events().len() < 3 {
        let tick = head.advance(h, &no_input, &mut recorder);
        derivatives += tick.work.derivatives;
    }
    ((recorder.events()[2].before[1] - 1.0).abs(), derivatives)
}

#[test]
fn an_expected_event_lies_at_a_steps_end_and_costs_no_more() {
    // RK4's third-order dense output takes (ωh)⁴/69 of the amplitude at an event in the middle of a
    // step; at the step's end a fiftieth of that is left.
    for radians in [0.05, 0.04] {
        let (mut with, mut without) = ((0.0_f64, 0), (0.0_f64, 0));
        for n in 0..20 {
            let start = f64::from(n) / 20.0 + 0.01;
            let sum = |sum: (f64, u32), it: (f64, u32)| (sum.0.max(it.0), sum.1 + it.1);
            with = sum(with, exit_speed(radians, start, true));
            without = sum(without, exit_speed(radians, start, false));
        }
        assert!(with.0 < 0.2 * without.0, "{radians}: {:e}, without {:e}", with.0, without.0);
        let more = f64::from(with.1) / f64::from(without.1);
        assert!(more < 1.02, "{radians}: {} derivatives, without {}", with.1, without.1);
    }
}

#[test]
fn a_bound_that_is_exact_hides_nothing() {
    const FLOOR: [GuardSpec; 1] = [GuardSpec::new(0, "floor").of_state().on_crossing()];
    // A parabola that touches its bound everywhere: thrown up so that it returns late.
    let tossed = OneMode {
        guards: &FLOOR,
        guard: |(), _, x| GuardValue::new(x[0], x[1]),
        is_bounded: true,
        reset: |(), _, _| [0.0, 0.0],
        ..OneMode::new((), |(), x| [x[1], if x[1] == 0.0 { 0.0 } else { -G }])
    };
    for h in crate::common::STEPS {
        let mut ball = tossed.start(Rk4, [0.0, 9.81]);
        let (recorder, ticks) = run(&mut ball, h, 0.0, 2.5);
        crate::common::all_completed(&ticks);
        assert_eq!(recorder.events().len(), 1, "h {h}");
        crate::common::close("back on the floor", recorder.events()[0].t, 2.0, 1e-12);
        let guards: u32 = ticks.iter().map(|tick| tick.work.guards).sum();
        assert!(f64::from(guards) < 20.0 + 0.55 / h, "h {h}: {guards} guards");
    }
}

#[test]
fn nothing_is_forecast_where_that_is_switched_off() {
    let limits = Limits { forecast: false, ..Limits::default() };
    let mut pendulum = Simulator::new(walled(true), Rk4, limits, (), [1.2, 0.0]);
    let _ = pendulum.advance(1e-3, &no_input, &mut Silent);
    assert_eq!(pendulum.advance(1e-3, &no_input, &mut Silent).work.guards, 8);
}
