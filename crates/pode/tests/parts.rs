//! Computations that a mode does not need are skipped: modes without degrees of freedom, slaved
//! entries, and parts independent of each other.

use pode::stepper::{Any, Controlled, Dop853, Exact, Rk4};
use pode::{
    EquationKind, Guarded, Limits, Matrix, Model, Motion, Nature, Part, Resets, Silent, Simulator,
    State as _, Stepper, Work,
};

use crate::common::close;

/// Two independent oscillators, slow (1 rad/s) and fast (30 rad/s), the fast one driven:
/// coordinates, then speeds, each with three that rest, so that parts are stepped apart.
#[derive(Clone, Copy, Debug)]
struct Pair {
    parts: &'static [Part],
}

const SLOW: f64 = 1.0;
const FAST: f64 = 30.0;
const WHOLE: [Part; 1] = [Part::WHOLE];
const APART: [Part; 2] =
    [Part::of(&[0, 5]).with_nature(Nature::new(EquationKind::Linear, SLOW)), Part::of(&[1, 6])];

impl Model for Pair {
    type Mode = ();
    type State = [f64; 10];
    type Input = Motion;
    const COORDS: usize = 5;

    fn parts(&self, (): ()) -> &[Part] {
        self.parts
    }

    fn derivative(&self, (): (), x: &[f64; 10], s: &Motion) -> [f64; 10] {
        let (slow, fast) = (-SLOW * SLOW * x[0], FAST * FAST * (s.position - x[1]));
        [x[5], x[6], 0.0, 0.0, 0.0, slow, fast, 0.0, 0.0, 0.0]
    }

    fn readout(&self, (): (), x: &[f64; 10], _: &Motion) -> f64 {
        x[1]
    }

    fn nature(&self, (): ()) -> Nature {
        Nature::new(EquationKind::Smooth, FAST)
    }
}

impl Guarded for Pair {}

impl Resets for Pair {}

fn after<T: Stepper>(parts: &'static [Part], stepper: T) -> ([f64; 10], Work) {
    let mut start = [0.0; 10];
    start[0] = 1.0;
    let mut pair = Simulator::new(Pair { parts }, stepper, Limits::default(), (), start);
    let mut work = Work::default();
    for tick in 0..100 {
        let input = |theta: f64| {
            let t = (f64::from(tick) + theta) * 1e-3;
            Motion { position: 10.0 * t, rate: 10.0, ..Motion::default() }
        };
        work = work.plus(pair.advance(1e-3, &input, &mut Silent).work);
    }
    (*pair.state(), work)
}

#[test]
fn parts_apart_go_where_they_go_together() {
    let methods = Any::NAMES.iter().map(|name| Any::named(name).expect("a method"));
    let controlled = Any::named("dop853").and_then(|it| it.with_tolerance(1e-9, 1e-3));
    for method in methods.chain(controlled) {
        let [(together, _), (apart, work)] = [&WHOLE[..], &APART].map(|it| after(it, method));
        for (index, (one, other)) in together.iter().zip(&apart).enumerate() {
            // To rounding with one method for both; `exact` and `by-need` choose part by part, with
            // errors of the chosen methods.
            let tolerance = match method.name() {
                "exact" | "by-need" => 1e-4,
                _ => 1e-12,
            };
            close(format_args!("{}, entry {index}", method.name()), *other, *one, tolerance);
        }
        let entries = if method.steps_apart(10) { 2 } else { 4 };
        assert_eq!(work.rates, entries * work.derivatives, "{}: its entries only", method.name());
    }
}

#[test]
fn each_part_takes_the_method_that_its_own_nature_asks_for() {
    let (state, work) = after(&APART, Exact);
    close("the slow one", state[0], 0.1_f64.cos(), 1e-15);
    let fast = 10.0 * (0.1 - (FAST * 0.1).sin() / FAST);
    close("the fast one", state[1], fast, 1e-6);
    assert!((state[1] - fast).abs() > 1e-12, "RK4 has an error");
    assert_eq!(work.jacobians, 100, "one for each step of the slow part");
}

#[test]
fn what_is_in_no_part_is_not_integrated() {
    const FAST_ONLY: [Part; 1] = [Part::of(&[1, 6])];
    let (state, work) = after(&FAST_ONLY, Rk4);
    close("the slow one", state[0], 1.0, 0.0);
    close("the fast one", state[1], after(&WHOLE, Rk4).0[1], 1e-14);
    assert_eq!((work.derivatives, work.rates), (400, 800));
}

#[test]
fn a_slow_part_takes_one_step_for_three_of_the_others() {
    const SLOWLY: [Part; 2] =
        [Part::of(&[0, 5]).of_state().with_longest_step(1.0), Part::of(&[1, 6])];
    let (state, work) = after(&SLOWLY, Rk4);
    // 34 of its own steps beside 100: 4 derivatives each.
    assert_eq!((work.derivatives, work.pieces), (4 * (100 + 34), 100));
    close("the slow one", state[0], 0.1_f64.cos(), 1e-12);
    close("the fast one", state[1], after(&WHOLE, Rk4).0[1], 1e-14);
    let (state, work) = after(&SLOWLY, Dop853);
    assert_eq!(work.derivatives, 2 * 100 * (13 + 3) + 13, "with what refines it for the readout");
    close("the slow one", state[0], 0.1_f64.cos(), 1e-14);
}

#[test]
fn a_mode_without_degrees_of_freedom_takes_no_derivative_with_any_method() {
    for name in Any::NAMES {
        let method = Any::named(name).expect("a method");
        let (state, work) = after(&[], method);
        let zero = (work.derivatives, work.rates, work.jacobians);
        assert_eq!(zero, (0, 0, 0), "{name}");
        assert_eq!(state[0].to_bits(), 1.0_f64.to_bits(), "{name}");
        assert!(state[1..].iter().all(|it| it.to_bits() == 0), "{name}");
    }
    let (_, work) = after(&[], Controlled::<Dop853>::default());
    assert_eq!((work.derivatives, work.pieces), (0, 100));
}

#[test]
fn a_matrix_of_any_size_is_factored_with_interchanged_rows() {
    // 1 − a·A with a zero in the first pivot's place; 40 unknowns, no bound on the size needed.
    type Unknowns = [f64; 40];
    type Square = <Unknowns as pode::State>::Matrix;
    let matrix = <Square as Matrix<Unknowns>>::from_columns(|column| {
        Unknowns::ZERO.with_entry((column + 1) % 40, 2.0).with_entry(column, 1.0)
    });
    let factored = matrix.factor(1.0);
    let x: Unknowns = core::array::from_fn(|n| (n as f64).sin());
    let b = x.plus(-1.0, &matrix.apply(&x));
    let solved = Square::solve(&factored, &b).expect("a regular matrix");
    for (found, expected) in solved.iter().zip(x) {
        close("an unknown", *found, expected, 1e-13);
    }
    let singular = Square::ONE.factor(1.0);
    assert!(Square::solve(&singular, &b).is_none());
}
