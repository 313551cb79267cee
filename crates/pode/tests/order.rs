//! Observed order of every stepper, of its dense output and of the events located on it,
//! and the evaluations that a step takes.
//!
//! Orders are observed between a step and half of it, where the next term of the error is
//! about a tenth of the first: ± 0.2.

mod common;

use common::ONE;
use pode::stepper::{BogackiShampine, Given, Heun, Rk4, SemiImplicitEuler};
use pode::{
    Advance, Dense as _, GuardId, GuardSpec, GuardValue, Guarded, Kind, Limits, Model, Nature,
    Reset, Resets, Silent, Simulator, Stepper, Work,
};

/// A driven oscillator, q'' = −q + e^(−t), solved by q = (e^(−t) + sin t) / 2 from (1/2, 0):
/// its derivative depends on the time, so wrong nodes show.
fn derivative(t: f64, x: &[f64; 2]) -> [f64; 2] {
    [x[1], -x[0] + (-t).exp()]
}

fn exact(t: f64) -> [f64; 2] {
    [0.5 * ((-t).exp() + t.sin()), 0.5 * (t.cos() - (-t).exp())]
}

/// The dense output of one step from `x` at `t`, brought to its full order.
fn step<T: Stepper>(
    t: f64,
    x: &[f64; 2],
    memory: &mut T::Memory<[f64; 2]>,
    h: f64,
) -> T::Dense<[f64; 2]> {
    let f = |tau: f64, x: &[f64; 2]| derivative(t + tau * h, x);
    // The oscillator is linear, its rate is 1.
    let mut field = Given { coords: 1, nature: Nature::new(Kind::Linear, 1.0), f };
    let mut step = T::default().step(&mut field, x, memory, h);
    T::default().refine(&mut field, &mut step.dense, h);
    step.dense
}

/// The same from the exact state at `t`, without anything known from before.
fn first_step<T: Stepper>(t: f64, h: f64) -> T::Dense<[f64; 2]> {
    step::<T>(t, &exact(t), &mut T::Memory::default(), h)
}

fn distance(a: &[f64; 2], b: &[f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Asserts that halving the step divides `error` by 2^`order`.
#[track_caller]
fn check_order(what: impl std::fmt::Display, order: f64, error: impl Fn(f64) -> f64, h: f64) {
    let observed = (error(h) / error(0.5 * h)).log2();
    assert!((observed - order).abs() < 0.2, "{what}: observed order {observed:.3}, not {order}");
}

/// Error after 1 s in steps of `h` [s].
fn global_error<T: Stepper>(h: f64) -> f64 {
    let n = (1.0 / h).round();
    let mut x = exact(0.0);
    let (mut k, mut memory) = (0.0, T::Memory::default());
    while k < n {
        x = *step::<T>(k * h, &x, &mut memory, h).end();
        k += 1.0;
    }
    distance(&x, &exact(1.0))
}

/// Largest error inside one step of `h` [s] from the exact state.
fn dense_error<T: Stepper>(h: f64) -> f64 {
    let step = first_step::<T>(0.3, h);
    let inside = (1..=20).map(|n| f64::from(n) / 20.0);
    inside.map(|tau| distance(&step.at(tau), &exact(0.3 + tau * h))).fold(0.0, f64::max)
}

/// Global order of the method, and local order of its dense output.
fn check_stepper<T: Stepper>(dense: f64) {
    let h = 1.0 / 32.0;
    check_order(T::NAME, f64::from(T::ORDER), global_error::<T>, h);
    check_order(format_args!("dense output of {}", T::NAME), dense, dense_error::<T>, h);
}

#[test]
fn semi_implicit_euler_is_first_order() {
    // Its own local error is of order 2, and the parabola through its end keeps that.
    check_stepper::<SemiImplicitEuler>(2.0);
}

#[test]
fn heun_is_second_order() {
    check_stepper::<Heun>(3.0);
}

#[test]
fn bogacki_shampine_is_third_order() {
    check_stepper::<BogackiShampine>(4.0);
}

#[test]
fn rk4_is_fourth_order() {
    check_stepper::<Rk4>(4.0);
}

#[test]
fn dense_output_ends_where_the_step_does() {
    fn check<T: Stepper>() {
        let step = first_step::<T>(0.3, 0.1);
        let bits = |x: &[f64; 2]| x.map(f64::to_bits);
        assert_eq!(bits(&step.at(1.0)), bits(step.end()), "{}", T::NAME);
        assert_eq!(bits(&step.at(0.0)), bits(&exact(0.3)), "{}", T::NAME);
        // A cubic that ends elsewhere by its last rounding only.
        let gap = distance(&step.at(1.0 - f64::EPSILON), step.end());
        assert!(gap < 1e-15, "{}: {gap:e}", T::NAME);
    }
    check::<SemiImplicitEuler>();
    check::<Heun>();
    check::<BogackiShampine>();
    check::<Rk4>();
}

/// The same oscillator with the time as its third state, guarded by q + 0.3.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Driven;

impl Model for Driven {
    type Mode = ();
    type State = [f64; 3];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, (): (), x: &[f64; 3], (): &()) -> [f64; 3] {
        let [dq, du] = derivative(x[2], &[x[0], x[1]]);
        [dq, du, 1.0]
    }

    fn readout(&self, (): (), _: &[f64; 3], (): &()) -> f64 {
        0.0
    }
}

impl Guarded for Driven {
    fn guards(&self, (): ()) -> &'static [GuardSpec] {
        const FALLS: [GuardSpec; 1] = [ONE[0].on_crossing()];
        &FALLS
    }

    fn guard(&self, (): (), _: GuardId, x: &[f64; 3], (): &()) -> GuardValue {
        GuardValue::new(x[0] + 0.3, x[1])
    }
}

impl Resets for Driven {
    fn reset(&self, (): (), _: GuardId, x: &[f64; 3], (): &()) -> Reset<Self> {
        Reset::to((), *x)
    }
}

/// When q first falls through −0.3 [s], by bisection on the closed form.
fn crossing() -> f64 {
    let (mut lo, mut hi) = (3.0, 5.0);
    for _ in 0..60 {
        let middle = 0.5 * (lo + hi);
        if exact(middle)[0] > -0.3 { lo = middle } else { hi = middle }
    }
    hi
}

/// Error of the crossing's time with `n` whole steps before it and half a one.
fn event_error<T: Stepper>(n: f64) -> f64 {
    let t = crossing();
    let h = t / (n + 0.5);
    let start = [exact(0.0)[0], exact(0.0)[1], 0.0];
    let mut simulator = Simulator::new(Driven, T::default(), Limits::default(), (), start);
    let mut recorder = common::Recorder::new(h);
    while recorder.seen.is_empty() {
        assert_eq!(simulator.advance(h, &|_| (), &mut recorder).advance, Advance::Completed);
    }
    (recorder.seen[0].t - t).abs()
}

#[test]
fn events_are_located_at_the_order_of_the_method() {
    fn check<T: Stepper>() {
        let observed = (event_error::<T>(64.0) / event_error::<T>(128.0)).log2();
        let order = f64::from(T::ORDER);
        // A time is a sum of a global and a dense error: the next term is a fifth.
        assert!((observed - order).abs() < 0.3, "{}: observed order {observed:.3}", T::NAME);
    }
    check::<SemiImplicitEuler>();
    check::<Heun>();
    check::<BogackiShampine>();
    check::<Rk4>();
}

/// Work of the second of two ticks without an event, each in `steps` steps.
fn work<T: Stepper>(steps: f64) -> Work {
    let limits = Limits { longest_step: 1e-3 / steps, ..Limits::default() };
    let mut simulator = Simulator::new(Driven, T::default(), limits, (), [0.5, 0.0, 0.0]);
    let _ = simulator.advance(1e-3, &|_| (), &mut Silent);
    simulator.advance(1e-3, &|_| (), &mut Silent).work
}

#[test]
fn a_step_takes_its_stated_evaluations() {
    fn check<T: Stepper>(derivatives: [u32; 2]) {
        for (steps, derivatives) in [1, 5].into_iter().zip(derivatives) {
            // One look at the guard per step; the readout at both ends and in the middle.
            let expected = Work {
                pieces: steps,
                derivatives,
                guards: steps,
                readouts: 2 * steps + 1,
                unknown: steps,
                ..Work::default()
            };
            assert_eq!(work::<T>(f64::from(steps)), expected, "{} in {steps} steps", T::NAME);
        }
        assert_eq!(derivatives[0], T::EVALUATIONS, "{}", T::NAME);
    }
    check::<SemiImplicitEuler>([2, 10]);
    check::<Heun>([2, 10]);
    // First-same-as-last within the tick.
    check::<BogackiShampine>([4, 16]);
    check::<Rk4>([4, 20]);
}
