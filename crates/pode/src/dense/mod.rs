//! The continuous solution inside one step.

mod polynomial;

pub use polynomial::Polynomial;

use core::fmt::Debug;

use crate::part::Part;
use crate::state::State;

/// Dense output: the solution at any fraction of a step.
pub trait Dense<S>: Debug {
    /// Returns the solution without motion: `x` over the whole step.
    fn still(x: &S) -> Self
    where
        Self: Sized;

    /// Returns the solution with the entries of `part` from `other`, over the same step.
    #[must_use]
    fn merged(&self, other: &Self, part: &Part) -> Self
    where
        Self: Sized;

    /// Returns the solution between two fractions of the step; `None` if this form cannot be cut.
    fn within(&self, _from: f64, _to: f64) -> Option<Self>
    where
        Self: Sized,
    {
        None
    }

    /// Returns the state at the fraction `tau` of the step, 0 ..= 1.
    fn at(&self, tau: f64) -> S;

    fn end(&self) -> &S;

    /// Bounds the solution's motion over the step; `None` if unknown.
    fn bounds(&self) -> Option<DenseBounds<S>>;
}

/// Bounds of a dense output over the whole step, entry by entry.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct DenseBounds<S> {
    /// Bound of |x(τ) − x(0)|.
    pub moves: S,
    /// Bound of |dx/dτ|.
    pub speeds: S,
    /// Bound of |d²x/dτ²|.
    pub bends: S,
}

/// A cubic per entry of the state.
pub type Cubic<S> = Polynomial<S, 4>;

impl<S: State> Cubic<S> {
    /// Builds the cubic with these coefficients by power of τ; `end` is the step's end, exactly.
    #[inline]
    pub const fn cubic(x0: S, c1: S, c2: S, c3: S, end: S) -> Self {
        Self::new([x0, c1, c2, c3], end)
    }

    /// Builds the parabola from `x0` with slope `k0` to `end`: locally of third order.
    #[inline]
    pub fn parabola(x0: &S, k0: &S, end: &S, h: f64) -> Self {
        let c1 = k0.times(h);
        let c2 = end.plus(-1.0, x0).plus(-1.0, &c1);
        Self::cubic(*x0, c1, c2, S::ZERO, *end)
    }

    /// Builds the cubic Hermite with slopes `k0`, `k1` at both ends: locally of fourth order.
    #[inline]
    pub fn hermite(x0: &S, k0: &S, end: &S, k1: &S, h: f64) -> Self {
        let rise = end.plus(-1.0, x0);
        let c1 = k0.times(h);
        let c2 = rise.times(3.0).plus(-2.0, &c1).plus(-h, k1);
        let c3 = rise.times(-2.0).plus(1.0, &c1).plus(h, k1);
        Self::cubic(*x0, c1, c2, c3, *end)
    }
}
