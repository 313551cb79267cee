//! A model from a table.

use instruments::equations::{DoesNotFit, EquationModel, ModeNumber};
use pode::stepper::Rk4;
use pode::{
    Auditor, EquationKind, GuardBound, GuardId, Guarded as _, Limits, Model as _, Motion,
    Resets as _, Simulator,
};

use crate::equations::swing::Swing;

const SWING: ModeNumber = ModeNumber(0);

fn swing<const N: usize>(parameters: &[f64]) -> EquationModel<Swing, N, 8> {
    EquationModel::new(Swing, parameters).unwrap()
}

fn still(position: f64) -> Motion {
    Motion { position, ..Motion::default() }
}

#[test]
fn a_table_that_is_too_large_is_refused_with_what_it_needs() {
    let states = EquationModel::<_, 1, 8>::new(Swing, &[]).unwrap_err();
    assert_eq!(states, DoesNotFit::States(2));
    let constants = EquationModel::<_, 2, 2>::new(Swing, &[]).unwrap_err();
    assert_eq!(constants, DoesNotFit::Constants(3));
}

#[test]
fn entries_beyond_the_tables_stay_zero() {
    let (small, large) = (swing::<2>(&[]), swing::<5>(&[]));
    let input = still(0.3);
    let (mode, x) = small.at_rest(&input);
    let (same, padded) = large.at_rest(&input);
    assert_eq!((mode, same), (SWING, SWING));
    assert_eq!(padded, [x[0], x[1], 0.0, 0.0, 0.0]);
    let rates = large.derivative(SWING, &[0.1, 0.2, 0.0, 0.0, 0.0], &input);
    let expected = small.derivative(SWING, &[0.1, 0.2], &input);
    assert_eq!(rates, [expected[0], expected[1], 0.0, 0.0, 0.0]);
    let columns = |x: &[f64; 5]| pode::Matrix::apply(&large.jacobian(SWING, x, &input), x);
    let found = columns(&[0.1, 0.2, 0.0, 0.0, 0.0]);
    assert_eq!(found, [0.2, -(20.0 + 5.0 * 0.1_f64.cos()) * 0.1, 0.0, 0.0, 0.0]);
}

#[test]
fn the_rate_is_that_of_the_pose_at_rest() {
    let model = swing::<4>(&[]);
    let nature = model.nature(SWING);
    assert_eq!(nature.kind, EquationKind::Conservative);
    assert!((nature.rate - 5.0).abs() < 1e-9, "√(20 + 5) at rest, not {}", nature.rate);
    assert!((nature.longest_step - 0.15).abs() < 1e-9);
}

#[test]
fn a_stop_throws_it_back_with_its_impulse() {
    let model = swing::<4>(&[]);
    let reset = model.reset(SWING, GuardId(3), &[0.5, 2.0, 0.0, 0.0], &still(0.0));
    assert_eq!((reset.mode, reset.state, reset.impulse), (SWING, [0.5, -2.0, 0.0, 0.0], 7.0));
    assert_eq!(reset.rests, None);
    assert_eq!(model.sounding(GuardId(3), &[0.5, -2.0, 0.0, 0.0]), Some(2.0));
    assert_eq!(model.sounding(GuardId(2), &[0.5, -2.0, 0.0, 0.0]), None);
    let value = model.guard(SWING, GuardId(3), &[0.1, 2.0, 0.0, 0.0], &still(0.0));
    assert_eq!((value.value, value.rate), (0.4, -2.0));
    assert!(model.guard(SWING, GuardId(9), &[0.0; 4], &still(0.0)).value.is_nan());
}

#[test]
fn without_a_bound_nothing_is_known_of_a_step() {
    let over = pode::Enclosure {
        h: 1e-3,
        start: [0.0; 2],
        moves: [0.0; 2],
        speeds: [0.0; 2],
        bends: [0.0; 2],
        input_start: still(0.0),
        input: None,
    };
    let bound = swing::<2>(&[]).guard_bound(SWING, GuardId(3), &over);
    assert_eq!(bound, GuardBound::UNKNOWN);
}

#[test]
fn energy_is_accounted_for_over_a_swing() {
    let model = swing::<2>(&[]);
    let input = |t: f64| Motion {
        position: 0.2 * t.sin(),
        rate: 0.2 * t.cos(),
        acceleration: -0.2 * t.sin(),
        jerk: -0.2 * t.cos(),
    };
    let (mode, x) = model.at_rest(&input(0.0));
    let mut simulator = Simulator::new(model, Rk4, Limits::default(), mode, x);
    let mut audit = Auditor::default();
    assert!(simulator.run(3.0, 1e-3, input, &mut audit).is_completed());
    assert!(audit.sums.supplied.abs() > 1e-3, "{}", audit.sums.supplied);
    assert!(audit.sums.integration.abs() < 1e-11, "{:e}", audit.sums.integration);
}
