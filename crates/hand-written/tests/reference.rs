//! Models A, B and C against trajectories from an independent program.

#![expect(
    clippy::expect_used,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a test fails aloud; counts of rows are small"
)]

use hand_written::{KeyHammerRigid, KeyHammerSprings, ReducedGrand, reduced_grand};
use models::Described;
use pode::State as _;
use pode::stepper::{Rk4, Taylor, Tolerance};

use crate::common::{Case, Trace, mode_name, run};

/// Largest event-time error of a run (s); panics unless the mode sequence is the same.
#[track_caller]
fn event_error<M: Described + Default>(case: &Case, trace: &Trace<M>, h: f64) -> f64 {
    let seen: Vec<_> = trace
        .events
        .iter()
        .map(|(_, guard, from, to)| (*guard, mode_name::<M>(*from), mode_name::<M>(*to)))
        .collect();
    let expected: Vec<_> = case
        .events
        .iter()
        .map(|event| (event.guard.as_str(), event.from.as_str(), event.to.as_str()))
        .collect();
    assert_eq!(seen, expected, "mode sequence at h = {h}");
    let errors =
        trace.events.iter().zip(&case.events).map(|(seen, event)| (seen.0 - event.t).abs());
    errors.fold(0.0, f64::max)
}

#[track_caller]
fn check_events<M: Described + Default>(name: &str) {
    let case = Case::load::<M>(name);
    let error = |h: f64| event_error(&case, &run::<M, _>(&case, Rk4, h), h);
    let (coarse, middle, fine, finest) = (error(1e-3), error(5e-4), error(2.5e-4), error(5e-5));
    // Order 4 of the method: halving the step divides by 16, within a factor 1.6.
    assert!(coarse / middle > 10.0 || coarse < 1e-12, "{coarse:e} / {middle:e}");
    assert!(middle / fine > 10.0 || middle < 1e-12, "{middle:e} / {fine:e}");
    assert!(finest < 1e-9, "event times are off by {finest:e} s");
}

#[test]
fn model_b_meets_figure_6() {
    check_events::<KeyHammerSprings>("model-b-figure6");
}

#[test]
fn model_b_ten_times_stiffer_keeps_all_20_events() {
    check_events::<KeyHammerSprings>("model-b-stiff-10");
}

#[test]
fn taylors_method_meets_model_b_in_one_tick_as_closely_as_it_is_asked_to() {
    for (name, sensitivity) in [("model-b-figure6", 3.0), ("model-b-stiff-10", 3000.0)] {
        let case = Case::load::<KeyHammerSprings>(name);
        for tolerance in [1e-8, 1e-10, 1e-12, 1e-14] {
            let method = Taylor::to(Tolerance::both(tolerance));
            let trace = run::<KeyHammerSprings, _>(&case, method, case.t_end);
            let error = event_error(&case, &trace, case.t_end);
            let most = sensitivity * tolerance + 1e-14;
            // The first step under a stroke that is yet to come is blind to it at this tolerance.
            let most = if tolerance > 1e-9 { 10.0 * most } else { most };
            assert!(error < most, "{name}, {tolerance:e}: {error:e} s");
        }
    }
}

#[test]
fn model_a_throws_and_catches_twice() {
    check_events::<KeyHammerRigid>("model-a-two-throws");
}

/// The forte of model C, with ticks of `h` (s): the largest error of an event's time.
fn forte_error(h: f64) -> f64 {
    let case = Case::load::<ReducedGrand>("model-c-forte");
    event_error(&case, &run::<ReducedGrand, _>(&case, Rk4, h), h)
}

#[test]
fn model_c_plays_a_forte_at_the_speed_of_a_keyboard() {
    // However long the tick, steps are a quarter of a radian of what moves: RK4 is off by
    // 0.25⁵/120 = 8e-6 of a radian in each, hence by 3e-9 s on the string (1/ω = 0.21 ms) and
    // 2e-8 s on the key (1/ω = 1.3 to 2.4 ms). Over a handful of steps that makes 1e-7 s.
    for h in [1e-3, 5e-4, 2.5e-4, 1e-4] {
        let error = forte_error(h);
        assert!(error < 2e-7, "at ticks of {h} s event times are off by {error:e} s");
    }
}

#[test]
fn model_c_converges_as_its_felts_allow() {
    // The string sets in as p^2.5, so RK4's fourth order is one of 3.5 in the steps where the
    // hammer comes and goes: a tenth of the step divides by 10^3.5 at least.
    let (coarse, fine) = (forte_error(2.5e-5), forte_error(2.5e-6));
    assert!(coarse / fine > 10.0_f64.powf(3.5), "{coarse:e} s, then {fine:e} s");
    assert!(fine < 1e-12, "event times are off by {fine:e} s");
}

#[test]
fn states_at_events_are_the_references() {
    check_states::<KeyHammerSprings>("model-b-figure6", 1e-4, 1e-8);
    // The string decelerates the head by some km/s²: 1e-12 s make 1e-8 m/s.
    check_states::<ReducedGrand>("model-c-forte", 1e-5, 1e-7);
    let case = Case::load::<KeyHammerSprings>("model-b-figure6");
    let first = &case.events[0];
    assert_eq!(first.before, first.after, "a release keeps the state");
}

/// Checks the states before and after each event.
#[track_caller]
fn check_states<M: Described + Default>(name: &str, h: f64, tolerance: f64) {
    let case = Case::load::<M>(name);
    let trace = run::<M, _>(&case, Rk4, h);
    for ((before, after), event) in trace.before.iter().zip(&trace.after).zip(&case.events) {
        let sides = [(before, &event.before), (after, &event.after)];
        for (a, b) in sides.iter().flat_map(|(got, it)| got.entries().iter().zip(*it)) {
            assert!((a - b).abs() < tolerance, "{} at {}: {a} is not {b}", event.guard, event.t);
        }
    }
}

#[test]
fn the_start_is_the_equilibrium() {
    check_start::<KeyHammerSprings>("model-b-figure6");
    check_start::<ReducedGrand>("model-c-forte");
}

#[track_caller]
fn check_start<M: Described + Default>(name: &str) {
    let case = Case::load::<M>(name);
    let model: M = case.model();
    let (mode, state) = case.start(&model);
    assert_eq!(mode_name::<M>(mode), case.rows[0][1]);
    for (name, value) in model.entry().states.iter().zip(state.entries()) {
        assert!((value - case.value(0, name)).abs() < 1e-15, "{name} = {value}");
    }
}

/// Checks a model's outputs against the trajectory's columns, away from events.
#[track_caller]
fn check_outputs<M: Described + Default>(name: &str, columns: &[&str], h: f64, tolerance: f64) {
    let case = Case::load::<M>(name);
    let trace = run::<M, _>(&case, Rk4, h);
    let model: M = case.model();
    let per_row = (case.value(1, "t") / h).round() as usize;
    let mut out = [0.0; 8];
    for row in 0..case.rows.len() {
        let t = case.value(row, "t");
        let (mode, state) = &trace.ends[row * per_row];
        assert_eq!(mode_name::<M>(*mode), case.rows[row][1], "mode at {t}");
        model.outputs(*mode, state, &case.input(t), &mut out);
        for column in columns {
            let index =
                model.entry().outputs.iter().position(|name| name == column).expect("an output");
            let expected = case.value(row, column);
            let scale = expected.abs().max(1.0);
            let error = (out[index] - expected).abs();
            assert!(error < tolerance * scale, "{column} at {t}: {} is not {expected}", out[index]);
        }
    }
}

#[test]
fn the_forces_of_the_rigid_contact_are_exact() {
    check_outputs::<KeyHammerRigid>("model-a-two-throws", &["F_KH", "T_KU"], 1e-3, 1e-9);
}

#[test]
fn outputs_of_model_b_follow_the_reference() {
    let columns = ["F_KH", "T_KU", "gap", "q4", "q3"];
    check_outputs::<KeyHammerSprings>("model-b-figure6", &columns, 1e-4, 1e-8);
}

#[test]
fn trajectory_and_force_of_model_c_follow_the_reference() {
    check_outputs::<ReducedGrand>("model-c-forte", &["F_KU"], 1e-5, 1e-7);
    let case = Case::load::<ReducedGrand>("model-c-forte");
    let trace = run::<ReducedGrand, _>(&case, Rk4, 1e-5);
    for row in 0..case.rows.len() {
        let (_, state) = &trace.ends[row * 500];
        for (name, value) in reduced_grand::ENTRY.states.iter().zip(state) {
            let error = (value - case.value(row, name)).abs();
            assert!(error < 1e-7, "{name} in row {row} is off by {error:e}");
        }
    }
}

#[test]
fn energy_is_accounted_for() {
    for name in ["model-b-figure6", "model-b-stiff-10"] {
        let case = Case::load::<KeyHammerSprings>(name);
        let audit = run::<KeyHammerSprings, _>(&case, Rk4, 1e-4).audit;
        assert!(audit.supplied.abs() > 1e-3, "the stroke supplies {} J", audit.supplied);
        assert!(audit.integration.abs() < 1e-9, "{name}: residual {:e} J", audit.integration);
    }
    // 30 mJ go into the string and come out of it again; Simpson's rule over the onset of
    // its p^2.5 is of order 3.5, as the motion is.
    let case = Case::load::<ReducedGrand>("model-c-forte");
    let residual = |h| run::<ReducedGrand, _>(&case, Rk4, h).audit.integration.abs();
    let (coarse, fine) = (residual(1e-3), residual(6.25e-6));
    assert!(coarse < 1e-6 && fine < 2e-10, "{coarse:e} J, then {fine:e} J");
}
