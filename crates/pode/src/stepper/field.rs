//! The right-hand side over one step, for a method.

use crate::math::sqrt;
use crate::mechanical::{MAX_SPEEDS, MechanicalOutcome, MechanicalStep};
use crate::nature::Nature;
use crate::state::Matrix as _;
use crate::state::State;

/// A mode's equations over one step of known length.
pub trait Field<S: State> {
    fn coords(&self) -> usize;

    fn nature(&self) -> Nature;

    /// Evaluates the derivative at the fraction `tau` of the step.
    fn derivative(&mut self, tau: f64, x: &S) -> S;

    fn jacobian(&mut self, tau: f64, x: &S) -> S::Matrix {
        if self.nature().is_linear() {
            return unit_differences(|x| self.derivative(tau, x));
        }
        differences(x, |x| self.derivative(tau, x))
    }

    /// Returns the accelerations in mechanical form at `x`, the state at the step's start; `None`
    /// without one.
    fn mechanical_acceleration(&mut self, _x: &S) -> Option<[f64; MAX_SPEEDS]> {
        None
    }

    /// Takes a step in mechanical form from `x`, the state at the step's start; `None` without one.
    fn mechanical_step(&mut self, _x: &S, _step: &MechanicalStep) -> Option<MechanicalOutcome<S>> {
        None
    }
}

/// A right-hand side given as a function, for a method used on its own.
#[derive(Clone, Copy, Debug)]
pub struct Given<F> {
    pub coords: usize,
    pub nature: Nature,
    pub f: F,
}

impl<S: State, F: FnMut(f64, &S) -> S> Field<S> for Given<F> {
    fn coords(&self) -> usize {
        self.coords
    }

    fn nature(&self) -> Nature {
        self.nature
    }

    #[inline]
    fn derivative(&mut self, tau: f64, x: &S) -> S {
        (self.f)(tau, x)
    }
}

/// Computes the Jacobian of a field linear in the state, to rounding: one evaluation per entry.
pub(crate) fn unit_differences<S: State>(mut f: impl FnMut(&S) -> S) -> S::Matrix {
    let origin = f(&S::ZERO);
    S::Matrix::from_columns(|index| f(&S::ZERO.with_entry(index, 1.0)).plus(-1.0, &origin))
}

/// Computes a Jacobian by central differences: two evaluations of `f` per entry of the state. The
/// step is ∛ε of the entry's size, where rounding and curvature weigh the same. `[PTVF07]` 5.7
pub(crate) fn differences<S: State>(x: &S, mut f: impl FnMut(&S) -> S) -> S::Matrix {
    const PART: f64 = 1.0 / 131_072.0;
    let size = sqrt(x.entries().iter().map(|entry| entry * entry).sum::<f64>());
    S::Matrix::from_columns(|index| {
        let entry = x.entries().get(index).copied().unwrap_or(0.0);
        // A zero entry gets the size of the others, and 1 if all are zero.
        let size = entry.abs().max(1e-3 * size).max(if size > 0.0 { 0.0 } else { 1.0 });
        let (up, down) = (entry + PART * size, entry - PART * size);
        let rise = f(&x.with_entry(index, up)).plus(-1.0, &f(&x.with_entry(index, down)));
        rise.times(1.0 / (up - down))
    })
}
