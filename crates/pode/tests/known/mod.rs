//! Problems with a known solution, and the order observed on them.
//!
//! Orders are observed between a step and half of it, where the next term of the error is about a
//! tenth of the first: ± 0.2. The driven oscillator is linear, and flatters methods that know its
//! Jacobian; the driven pendulum is not.

use pode::stepper::Given;
use pode::{Dense, EquationKind, Nature, Step, Stepper};

#[derive(Clone, Copy)]
pub struct Problem {
    pub kind: EquationKind,
    pub acceleration: fn(f64, &[f64; 2]) -> f64,
}

/// A driven oscillator, q'' = −q + e^(−t): its derivative depends on the time, so wrong nodes show.
pub const OSCILLATOR: Problem =
    Problem { kind: EquationKind::Linear, acceleration: |t, x| -x[0] + (-t).exp() };

/// A pendulum with a cubic drag, driven so that it moves as the oscillator does.
pub const PENDULUM: Problem = Problem {
    kind: EquationKind::Smooth,
    acceleration: |t, x| {
        let ([q, dq], ddq) = (exact(t), 0.5 * ((-t).exp() - t.sin()));
        -4.0 * (x[0].sin() - q.sin()) - 0.5 * (x[1].powi(3) - dq.powi(3)) + ddq
    },
};

/// Returns q = (e^(−t) + sin t) / 2 and its rate, from (1/2, 0).
pub fn exact(t: f64) -> [f64; 2] {
    [0.5 * ((-t).exp() + t.sin()), 0.5 * (t.cos() - (-t).exp())]
}

/// Returns one step from `x` at `t`, its dense output brought to its full order.
pub fn whole_step<T: Stepper>(
    problem: Problem,
    (t, x): (f64, &[f64; 2]),
    memory: &mut T::Memory<[f64; 2]>,
    h: f64,
) -> Step<[f64; 2], T::Dense<[f64; 2]>> {
    let f = |tau: f64, x: &[f64; 2]| [x[1], (problem.acceleration)(t + tau * h, x)];
    let mut field = Given { coords: 1, nature: Nature::new(problem.kind, 1.0), f };
    let mut step = T::default().step(&mut field, x, memory, h);
    T::default().refine(&mut field, memory, &mut step.dense, h);
    step
}

pub fn step<T: Stepper>(
    problem: Problem,
    start: (f64, &[f64; 2]),
    memory: &mut T::Memory<[f64; 2]>,
    h: f64,
) -> T::Dense<[f64; 2]> {
    whole_step::<T>(problem, start, memory, h).dense
}

pub fn first_step<T: Stepper>(problem: Problem, t: f64, h: f64) -> T::Dense<[f64; 2]> {
    step::<T>(problem, (t, &exact(t)), &mut T::Memory::default(), h)
}

pub fn distance(a: &[f64; 2], b: &[f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

#[track_caller]
pub fn check_order(what: impl std::fmt::Display, order: f64, error: impl Fn(f64) -> f64, h: f64) {
    let observed = (error(h) / error(0.5 * h)).log2();
    assert!((observed - order).abs() < 0.2, "{what}: observed order {observed:.3}, not {order}");
}

/// Returns the error after 1 s in steps with lengths (s) cycling through `parts` of `h`.
pub fn global_error<T: Stepper>(problem: Problem, parts: &[f64], h: f64) -> f64 {
    let mut x = exact(0.0);
    let (mut t, mut memory) = (0.0, T::Memory::default());
    while t < 1.0 - 0.5 * h {
        for part in parts {
            x = *step::<T>(problem, (t, &x), &mut memory, part * h).end();
            t += part * h;
        }
    }
    distance(&x, &exact(1.0))
}

/// Returns the largest error of `step`'s dense output, which begins at `t` and lasts `h` (s).
pub fn largest_inside(step: &impl Dense<[f64; 2]>, t: f64, h: f64) -> f64 {
    let inside = (1..=20).map(|n| f64::from(n) / 20.0);
    inside.map(|tau| distance(&step.at(tau), &exact(t + tau * h))).fold(0.0, f64::max)
}
