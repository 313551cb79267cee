//! The continuous solution inside one step: a cubic per entry.

use crate::state::State;

/// Dense output: x(τ) = x0 + τ (c1 + τ (c2 + τ c3)) for τ in 0 ..= 1 of the step.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Dense<S> {
    x0: S,
    c1: S,
    c2: S,
    c3: S,
    x1: S,
}

impl<S: State> Dense<S> {
    /// The cubic with the given coefficients; `x1` is the step's end, exactly.
    #[inline]
    pub const fn cubic(x0: S, c1: S, c2: S, c3: S, x1: S) -> Self {
        Self { x0, c1, c2, c3, x1 }
    }

    /// The parabola from `x0` with slope `k1` to `x1`: locally of third order.
    #[inline]
    pub fn parabola(x0: &S, k1: &S, x1: &S, h: f64) -> Self {
        let c1 = k1.times(h);
        let c2 = x1.plus(-1.0, x0).plus(-1.0, &c1);
        Self { x0: *x0, c1, c2, c3: S::ZERO, x1: *x1 }
    }

    /// The cubic Hermite with slopes `k0`, `k1` at both ends: locally of fourth order.
    #[inline]
    pub fn hermite(x0: &S, k0: &S, x1: &S, k1: &S, h: f64) -> Self {
        let rise = x1.plus(-1.0, x0);
        let c1 = k0.times(h);
        let c2 = rise.times(3.0).plus(-2.0, &c1).plus(-h, k1);
        let c3 = rise.times(-2.0).plus(1.0, &c1).plus(h, k1);
        Self { x0: *x0, c1, c2, c3, x1: *x1 }
    }

    /// The state at `tau` of the step, 0 ..= 1.
    #[inline]
    pub fn at(&self, tau: f64) -> S {
        if tau >= 1.0 {
            return self.x1;
        }
        self.x0.plus(tau, &self.c1.plus(tau, &self.c2.plus(tau, &self.c3)))
    }

    /// The state at the end of the step.
    #[inline]
    pub const fn end(&self) -> &S {
        &self.x1
    }
}
