//! Observed order of every stepper, of its dense output and of the events located on it, and the
//! evaluations of a step.

use pode::stepper::{
    AdamsBashforth2, AdamsBashforth3, BogackiShampine, ExplicitEuler, Given, Heun,
    LinearImplicitMidpoint, Rk4, Rodas3, SemiImplicitEuler, Tsitouras5, VelocityVerlet,
};
use pode::{
    Advance, Dense as _, EquationKind, GuardValue, Limits, Nature, Simulator, Stepper, Work,
};

use crate::common::{ON_CROSSING, OneMode, no_input};
use crate::known::{
    OSCILLATOR, PENDULUM, Problem, check_order, distance, exact, first_step, global_error,
    largest_inside, step, whole_step,
};

macro_rules! every {
    ($check:ident) => {
        $check::<ExplicitEuler>();
        $check::<SemiImplicitEuler>();
        $check::<Heun>();
        $check::<VelocityVerlet>();
        $check::<BogackiShampine>();
        $check::<Rk4>();
        $check::<Tsitouras5>();
        $check::<AdamsBashforth2>();
        $check::<AdamsBashforth3>();
        $check::<LinearImplicitMidpoint>();
        $check::<Rodas3>();
    };
}

fn check_stepper<T: Stepper>() {
    let h = 1.0 / 32.0;
    for (name, problem) in [("oscillator", OSCILLATOR), ("pendulum", PENDULUM)] {
        let what = format_args!("{} on the {name}", T::NAME);
        let global = |h: f64| global_error::<T>(problem, &[1.0], h);
        check_order(what, f64::from(T::ORDER), global, h);
        let dense = |h: f64| largest_inside(&first_step::<T>(problem, 0.3, h), 0.3, h);
        let what = format_args!("dense output of {what}");
        check_order(what, f64::from(T::DENSE) + 1.0, dense, h);
    }
}

#[test]
fn every_method_has_its_order_and_so_has_its_dense_output() {
    every!(check_stepper);
}

#[test]
fn an_embedded_estimate_is_what_a_method_of_its_order_errs_by() {
    fn check<T: Stepper>(order: f64) {
        for problem in [OSCILLATOR, PENDULUM] {
            let estimate = |h: f64| {
                let start = (0.3, &exact(0.3));
                let step = whole_step::<T>(problem, start, &mut T::Memory::default(), h);
                distance(&step.error, &[0.0; 2])
            };
            check_order(T::NAME, order + 1.0, estimate, 1.0 / 32.0);
        }
    }
    check::<BogackiShampine>(2.0);
    check::<Tsitouras5>(4.0);
    check::<Rodas3>(2.0);
    // The linearised step is exact but for the forcing on the oscillator.
}

#[test]
fn dense_output_ends_where_the_step_does() {
    fn check<T: Stepper>() {
        let step = first_step::<T>(PENDULUM, 0.3, 0.1);
        let bits = |x: &[f64; 2]| x.map(f64::to_bits);
        assert_eq!(bits(&step.at(1.0)), bits(step.end()), "{}", T::NAME);
        assert_eq!(bits(&step.at(0.0)), bits(&exact(0.3)), "{}", T::NAME);
        let gap = distance(&step.at(1.0 - f64::EPSILON), step.end());
        assert!(gap < 2e-15, "{}: {gap:e}", T::NAME);
    }
    every!(check);
}

/// Returns the oscillator with its time as the third entry, and a guard that falls through `level`.
fn driven(level: f64) -> OneMode<f64, 3> {
    OneMode {
        guards: &ON_CROSSING,
        guard: |level, _, x| GuardValue::new(x[0] - level, x[1]),
        ..OneMode::new(level, |_, x| [x[1], (OSCILLATOR.acceleration)(x[2], &[x[0], x[1]]), 1.0])
    }
}

fn crossing(level: f64) -> f64 {
    let (mut lo, mut hi) = (1.0, 4.6);
    for _ in 0..60 {
        let middle = 0.5 * (lo + hi);
        if exact(middle)[0] > level { lo = middle } else { hi = middle }
    }
    hi
}

/// Sums errors of crossing times with `n` whole steps before each and half a one: at a single level
/// the terms of an error may cancel.
fn event_error<T: Stepper>(n: f64) -> f64 {
    let error = |level: f64| {
        let t = crossing(level);
        let h = t / (n + 0.5);
        let start = [exact(0.0)[0], exact(0.0)[1], 0.0];
        let mut simulator = driven(level).start(T::default(), start);
        let mut recorder = pode::RunRecorder::new(h);
        while recorder.events().is_empty() {
            assert_eq!(simulator.advance(h, &no_input, &mut recorder).advance, Advance::Completed);
        }
        (recorder.events()[0].t - t).abs()
    };
    [0.3, 0.1, -0.1, -0.3].map(error).iter().sum()
}

#[test]
fn events_are_located_at_the_order_of_the_method() {
    fn check<T: Stepper>() {
        let observed = (event_error::<T>(64.0) / event_error::<T>(128.0)).log2();
        let order = f64::from(T::ORDER);
        // A time is a sum of a global and a dense error: the next term is a fifth.
        assert!((observed - order).abs() < 0.3, "{}: observed order {observed:.3}", T::NAME);
    }
    every!(check);
}

fn work<T: Stepper>(steps: f64) -> [Work; 2] {
    let limits = Limits { longest_step: 1e-3 / steps, ..Limits::default() };
    let mut simulator = Simulator::new(driven(-0.3), T::default(), limits, (), [0.5, 0.0, 0.0]);
    // Guards are evaluated again in the first tick: the second is like later ones.
    let mut recorder = pode::RunRecorder::new(1e-3);
    [(); 2].map(|()| simulator.advance(1e-3, &no_input, &mut recorder).work)
}

#[test]
fn a_step_takes_its_stated_evaluations() {
    /// Evaluations of the first tick in one step, of later ones in one and five; Jacobians per
    /// step.
    fn check<T: Stepper>(derivatives: [u32; 3], jacobians: u32) {
        let [first, later @ ..] = derivatives;
        for (steps, derivatives) in [1, 5].into_iter().zip(later) {
            // One guard evaluation per step; the readout at both ends and in the middle.
            let expected = Work {
                pieces: steps,
                derivatives,
                rates: 3 * derivatives,
                jacobians: jacobians * steps,
                guards: steps,
                readouts: 2 * steps + 1,
                unknown: steps,
                ..Work::default()
            };
            assert_eq!(work::<T>(f64::from(steps))[1], expected, "{} in {steps} steps", T::NAME);
        }
        assert_eq!(work::<T>(1.0)[0].derivatives, first, "{}", T::NAME);
        assert_eq!(derivatives.map(|it| it > 5 * T::EVALUATIONS), [false; 3], "{}", T::NAME);
    }
    check::<ExplicitEuler>([1, 1, 5], 0);
    check::<SemiImplicitEuler>([2, 2, 10], 0);
    check::<Heun>([2, 2, 10], 0);
    // Two of three: the coordinate's rate is its speed.
    check::<VelocityVerlet>([2, 2, 10], 0);
    check::<BogackiShampine>([4, 4, 16], 0);
    check::<Rk4>([4, 4, 20], 0);
    check::<Tsitouras5>([7, 7, 31], 0);
    // One after the first; in five steps a tick, the first tick holds all the first steps.
    check::<AdamsBashforth2>([2, 1, 5], 0);
    check::<LinearImplicitMidpoint>([2, 2, 10], 1);
    check::<Rodas3>([5, 5, 25], 1);
    // The second tick of one step is still one of its first steps.
    check::<AdamsBashforth3>([3, 3, 5], 0);
}

#[test]
fn no_step_takes_more_than_its_most_evaluations() {
    fn check<T: Stepper>() {
        let most = work::<T>(1.0).map(|work| work.derivatives).into_iter().max();
        let expected = if T::NAME == VelocityVerlet::NAME { 2 } else { T::EVALUATIONS };
        assert_eq!(most, Some(expected), "{}", T::NAME);
    }
    every!(check);
}

#[test]
fn verlet_keeps_its_order_where_the_rates_are_not_the_speeds() {
    // The pendulum in q/3 and q': a coordinate whose rate is a third of its speed.
    let error = |h: f64| {
        let (mut x, mut t) = ([exact(0.0)[0] / 3.0, exact(0.0)[1]], 0.0);
        while t < 1.0 - 0.5 * h {
            let f = |tau: f64, x: &[f64; 2]| {
                let a = (PENDULUM.acceleration)(t + tau * h, &[3.0 * x[0], x[1]]);
                [x[1] / 3.0, a]
            };
            let mut field = Given { coords: 1, nature: Nature::default(), f };
            x = *VelocityVerlet.step(&mut field, &x, &mut (), h).dense.end();
            t += h;
        }
        distance(&[3.0 * x[0], x[1]], &exact(1.0))
    };
    check_order("thirds", 2.0, error, 1.0 / 32.0);
}

#[test]
fn a_step_with_what_is_not_finite_ends_there() {
    fn check<T: Stepper>() {
        let broken: [fn(f64, &[f64; 2]) -> f64; 2] = [|_, _| f64::NAN, |_, _| f64::INFINITY];
        for (acceleration, kind) in
            broken.into_iter().zip([EquationKind::Smooth, EquationKind::Linear])
        {
            let (start, mut memory) = ([0.5, 1.0], T::Memory::default());
            let step = step::<T>(Problem { kind, acceleration }, (0.0, &start), &mut memory, 0.1);
            assert!(step.end().iter().any(|it| !it.is_finite()), "{}: {step:?}", T::NAME);
        }
    }
    every!(check);
}

#[test]
fn a_singular_system_ends_in_a_state_that_is_not_finite() {
    /// With `growth` = 1/(γ h) the last pivot of 1 − γ h J is zero, to the bit.
    fn check<T: Stepper>(growth: fn(f64, &[f64; 2]) -> f64) {
        let problem = Problem { kind: EquationKind::Linear, acceleration: growth };
        let step = step::<T>(problem, (0.0, &[0.5, 1.0]), &mut T::Memory::default(), 0.125);
        assert!(step.end().iter().all(|it| it.is_nan()), "{}: {step:?}", T::NAME);
    }
    check::<LinearImplicitMidpoint>(|_, x| 16.0 * x[1]);
    check::<Rodas3>(|_, x| 16.0 * x[1]);
}
