//! The described models A, B and C against trajectories from an independent program.

mod case;

use crate::kane::runnable::{GRAND, RIGID, SPRINGS, ShippedModel, mode_name, output};

pub(crate) use case::Case;
use case::Trace;

/// Returns the largest event-time error of a run (s); checks the mode sequence.
#[track_caller]
fn event_error<const N: usize>(case: &Case<N>, trace: &Trace<N>, h: f64) -> f64 {
    let seen: Vec<_> = trace.events.iter().map(|it| (it.guard, it.modes)).collect();
    let events = case.events.iter();
    let expected: Vec<_> =
        events.map(|it| (it.guard.as_str(), [it.from.as_str(), it.to.as_str()])).collect();
    assert_eq!(seen, expected, "mode sequence at h = {h}");
    let errors =
        trace.events.iter().zip(&case.events).map(|(seen, event)| (seen.t - event.t).abs());
    errors.fold(0.0, f64::max)
}

#[track_caller]
fn check_events<const N: usize>(shipped: &ShippedModel, name: &str) {
    let case = Case::<N>::load(shipped, name);
    let error = |h: f64| event_error(&case, &case.run(h), h);
    let (coarse, middle, fine, finest) = (error(1e-3), error(5e-4), error(2.5e-4), error(5e-5));
    // Order 4 of the method: halving the step divides by 16, within a factor 1.6.
    assert!(coarse / middle > 10.0 || coarse < 1e-12, "{coarse:e} / {middle:e}");
    assert!(middle / fine > 10.0 || middle < 1e-12, "{middle:e} / {fine:e}");
    assert!(finest < 1e-9, "event times are off by {finest:e} s");
}

#[test]
fn model_b_meets_figure_6() {
    check_events::<4>(&SPRINGS, "model-b-figure6");
}

#[test]
fn model_b_ten_times_stiffer_keeps_all_20_events() {
    check_events::<4>(&SPRINGS, "model-b-stiff-10");
}

#[test]
fn model_a_throws_and_catches_twice() {
    check_events::<2>(&RIGID, "model-a-two-throws");
}

/// Plays the forte of model C with ticks of `h` (s); returns the largest error of an event's time.
fn forte_error(h: f64) -> f64 {
    let case = Case::<4>::load(&GRAND, "model-c-forte");
    event_error(&case, &case.run(h), h)
}

#[test]
fn model_c_plays_a_forte_at_the_speed_of_a_keyboard() {
    // However long the tick, steps are at most 0.75 rad of the fastest motion: RK4 is off by
    // 0.75⁵/120 = 2e-3 rad in each, hence by 4e-7 s on the string (1/ω = 0.21 ms) and 5e-6 s on
    // the key (1/ω = 1.3 to 2.4 ms); shorter ticks improve by more than their cube.
    for h in [1e-3, 5e-4, 2.5e-4, 1e-4_f64] {
        let (error, bound) = (forte_error(h), 1e-5 * (h / 1e-3).powi(3));
        assert!(error < bound, "at ticks of {h} s event times are off by {error:e} s");
    }
}

#[test]
fn model_c_converges_as_its_felts_allow() {
    // The string force begins as p^2.5, so RK4's fourth order is one of 3.5 in the steps where the
    // hammer meets and leaves it: a tenth of the step divides by 10^3.5 at least.
    let (coarse, fine) = (forte_error(2.5e-5), forte_error(2.5e-6));
    assert!(coarse / fine > 10.0_f64.powf(3.5), "{coarse:e} s, then {fine:e} s");
    assert!(fine < 1e-12, "event times are off by {fine:e} s");
}

#[test]
fn states_at_events_are_the_references() {
    check_states::<4>(&SPRINGS, "model-b-figure6", 1e-4, 1e-8);
    // The string decelerates the head by some km/s²: 1e-12 s are 1e-8 m/s.
    check_states::<4>(&GRAND, "model-c-forte", 1e-5, 1e-7);
    let case = Case::<4>::load(&SPRINGS, "model-b-figure6");
    let first = &case.events[0];
    assert_eq!(first.before, first.after, "a release keeps the state");
}

#[track_caller]
fn check_states<const N: usize>(shipped: &ShippedModel, name: &str, h: f64, tolerance: f64) {
    let case = Case::<N>::load(shipped, name);
    for (met, event) in case.run(h).events.iter().zip(&case.events) {
        let sides = met.states.iter().zip([&event.before, &event.after]);
        for (a, b) in sides.flat_map(|(found, expected)| found.iter().zip(expected)) {
            assert!((a - b).abs() < tolerance, "{} at {}: {a} is not {b}", event.guard, event.t);
        }
    }
}

#[test]
fn the_first_presets_are_what_the_references_state() {
    check_preset::<4>(&SPRINGS, "model-b-figure6");
    check_preset::<4>(&GRAND, "model-c-forte");
}

#[track_caller]
fn check_preset<const N: usize>(shipped: &ShippedModel, name: &str) {
    let case = Case::<N>::load(shipped, name);
    for (found, expected) in shipped.values(0, 0).iter().zip(case.model.parameters()) {
        assert!((found - expected).abs() <= 1e-12 * expected.abs(), "{name}: {found}, {expected}");
    }
}

#[test]
fn the_start_is_the_equilibrium() {
    check_start::<4>(&SPRINGS, "model-b-figure6");
    check_start::<4>(&GRAND, "model-c-forte");
}

#[track_caller]
fn check_start<const N: usize>(shipped: &ShippedModel, name: &str) {
    let case = Case::<N>::load(shipped, name);
    let (mode, state) = case.start();
    assert_eq!(mode_name(&case.model, mode), case.rows[0][1]);
    for (name, value) in case.states.iter().zip(state) {
        assert!((value - case.value(0, name)).abs() < 1e-15, "{name} = {value}");
    }
}

#[track_caller]
fn check_outputs<const N: usize>(
    (shipped, name): (&ShippedModel, &str),
    columns: &[&str],
    h: f64,
    tolerance: f64,
) -> (Case<N>, Trace<N>) {
    let case = Case::<N>::load(shipped, name);
    let trace = case.run(h);
    for row in 0..case.rows.len() {
        let t = case.value(row, "t");
        let (mode, state) = &trace.ends[row * per_row(&case, h)];
        assert_eq!(mode_name(&case.model, *mode), case.rows[row][1], "mode at {t}");
        for column in columns {
            let found = output(&case.model, *mode, (state, &case.input(t)), column);
            let expected = case.value(row, column);
            let error = (found - expected).abs();
            let bound = tolerance * expected.abs().max(1.0);
            assert!(error < bound, "{column} at {t}: {found} is not {expected}");
        }
    }
    (case, trace)
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small count")]
fn per_row<const N: usize>(case: &Case<N>, h: f64) -> usize {
    (case.value(1, "t") / h).round() as usize
}

#[test]
fn the_forces_of_the_rigid_contact_are_exact() {
    check_outputs::<2>((&RIGID, "model-a-two-throws"), &["F_KH", "T_KU"], 1e-3, 1e-9);
}

#[test]
fn outputs_of_model_b_follow_the_reference() {
    let columns = ["F_KH", "T_KU", "gap", "q4", "q3"];
    check_outputs::<4>((&SPRINGS, "model-b-figure6"), &columns, 1e-4, 1e-8);
}

#[test]
fn trajectory_and_force_of_model_c_follow_the_reference() {
    const H: f64 = 1e-5;
    let (case, trace) = check_outputs::<4>((&GRAND, "model-c-forte"), &["F_KU"], H, 1e-7);
    for row in 0..case.rows.len() {
        let (_, state) = &trace.ends[row * per_row(&case, H)];
        for (name, value) in case.states.iter().zip(state) {
            let error = (value - case.value(row, name)).abs();
            assert!(error < 1e-7, "{name} in row {row} is off by {error:e}");
        }
    }
}

#[test]
fn energy_is_accounted_for() {
    for name in ["model-b-figure6", "model-b-stiff-10"] {
        let audit = Case::<4>::load(&SPRINGS, name).run(1e-4).audit;
        assert!(audit.supplied.abs() > 1e-3, "the stroke supplies {} J", audit.supplied);
        assert!(audit.integration.abs() < 1e-9, "{name}: residual {:e} J", audit.integration);
    }
    // 30 mJ go into the string and return; Simpson's rule over the onset of its p^2.5 is of order
    // 3.5, like the motion.
    let case = Case::<4>::load(&GRAND, "model-c-forte");
    let residual = |h| case.run(h).audit.integration.abs();
    let (coarse, fine) = (residual(1e-3), residual(6.25e-6));
    assert!(coarse < 1e-6 && fine < 2e-10, "{coarse:e} J, then {fine:e} J");
}
