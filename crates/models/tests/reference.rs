//! Models A and B against trajectories from an independent program.

#![expect(
    clippy::expect_used,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a test fails aloud; counts of rows are small"
)]

mod common;

use common::{Case, Trace, mode_name, run};
use models::{Described, KeyHammerRigid, KeyHammerSprings};
use pode::stepper::Rk4;

/// Largest event-time error of a run [s]; panics unless the mode sequence is the same.
#[track_caller]
fn event_error<M: Described>(case: &Case, trace: &Trace<M>, h: f64) -> f64 {
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
fn check_events<M: Described>(name: &str) {
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
fn model_a_throws_and_catches_twice() {
    check_events::<KeyHammerRigid>("model-a-two-throws");
}

#[test]
fn states_at_events_are_the_references() {
    let case = Case::load::<KeyHammerSprings>("model-b-figure6");
    let trace = run::<KeyHammerSprings, _>(&case, Rk4, 1e-4);
    for (state, event) in trace.after.iter().zip(&case.events) {
        for (a, b) in state.iter().zip(&event.after) {
            assert!((a - b).abs() < 1e-8, "{} at {}: {a} is not {b}", event.guard, event.t);
        }
    }
    let first = &case.events[0];
    assert_eq!(first.before, first.after, "a release keeps the state");
}

#[test]
fn the_start_is_the_equilibrium() {
    let case = Case::load::<KeyHammerSprings>("model-b-figure6");
    let (_, state) = case.model::<KeyHammerSprings>().at_rest(&case.input(0.0));
    for (name, value) in KeyHammerSprings::STATES.iter().zip(state) {
        assert!((value - case.value(0, name)).abs() < 1e-15, "{name} = {value}");
    }
}

/// Checks a model's outputs against the trajectory's columns, away from events.
#[track_caller]
fn check_outputs<M: Described>(name: &str, columns: &[&str], h: f64, tolerance: f64) {
    let case = Case::load::<M>(name);
    let trace = run::<M, _>(&case, Rk4, h);
    let model: M = case.model();
    let per_row = (0.01 / h).round() as usize;
    let mut out = [0.0; 8];
    for row in 0..case.rows.len() {
        let t = case.value(row, "t");
        let (mode, state) = &trace.ends[row * per_row];
        assert_eq!(mode_name::<M>(*mode), case.rows[row][1], "mode at {t}");
        model.outputs(*mode, state, &case.input(t), &mut out);
        for column in columns {
            let index = M::OUTPUTS.iter().position(|name| name == column).expect("an output");
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
fn energy_is_accounted_for() {
    for name in ["model-b-figure6", "model-b-stiff-10"] {
        let case = Case::load::<KeyHammerSprings>(name);
        let audit = run::<KeyHammerSprings, _>(&case, Rk4, 1e-4).audit;
        assert!(audit.supplied.abs() > 1e-3, "the stroke supplies {} J", audit.supplied);
        assert!(audit.residual().abs() < 1e-9, "{name}: residual {:e} J", audit.residual());
    }
}
