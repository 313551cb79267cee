//! Taylor coefficients, one order after another.
//!
//! [`Guarded::series`](crate::Guarded::series) expands the solution as a power series in time, of
//! any order, together with the guards; [`Taylor`](crate::stepper::Taylor) steps along it.
//! Coefficients are scaled by powers of a time about as long as the step, so that high orders
//! neither overflow nor vanish. [`lanes`] sums the products of the next order.

mod bell;
mod falls;
mod guards;
pub mod lanes;

pub use bell::add_bell;
pub(crate) use falls::{Fall, first_fall};
pub(crate) use guards::GuardPolynomial;
pub use guards::GuardSeries;

use crate::state::State;

pub const MOST_ORDER: usize = 24;

pub const TERMS: usize = MOST_ORDER + 1;

/// 1/k from k = 1; a division takes four times as long as a product.
pub const PER_ORDER: [f64; INPUT_TERMS] = {
    let mut list = [0.0; INPUT_TERMS];
    let mut k = 1;
    while k < INPUT_TERMS {
        list[k] = 1.0 / k as f64;
        k += 1;
    }
    list
};

/// Coefficients of the input: three rates of it may enter the equations.
pub const INPUT_TERMS: usize = TERMS + 3;

/// Guards of a mode with a kept series, the first of its list.
pub const MOST_GUARDS: usize = 6;

/// Conditions with a kept series.
pub const MOST_CONDITIONS: usize = 12;

/// The solution from one state as a power series, with the guards along it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Expansion<S> {
    /// Coefficients after the first, at most [`MOST_ORDER`].
    pub order: usize,
    /// Time (s) at τ = 1.
    pub scale: f64,
    /// Coefficients of x(τ) by power of τ; the first is the given state.
    pub terms: [S; TERMS],
    /// Coefficients of the guards along the solution, in the order of the mode's list.
    pub guards: [[f64; TERMS]; MOST_GUARDS],
    pub known_guards: usize,
    /// Coefficients of conditions on which the equations' form depends: the series ends at a zero.
    pub conditions: [[f64; TERMS]; MOST_CONDITIONS],
    pub known_conditions: usize,
}

impl<S: State> Expansion<S> {
    /// Requests the expansion from `x`, up to `order`, in units of `scale` (s).
    pub fn of(x: &S, order: usize, scale: f64) -> Self {
        let mut new = Self::EMPTY;
        new.begin(x, order, scale);
        new
    }

    pub const EMPTY: Self = Self {
        order: 0,
        scale: 1.0,
        terms: [S::ZERO; TERMS],
        guards: [[0.0; TERMS]; MOST_GUARDS],
        known_guards: 0,
        conditions: [[0.0; TERMS]; MOST_CONDITIONS],
        known_conditions: 0,
    };

    #[inline]
    pub(crate) fn begin(&mut self, x: &S, order: usize, scale: f64) {
        self.order = order.clamp(1, MOST_ORDER);
        (self.scale, self.terms[0]) = (scale, *x);
        (self.known_guards, self.known_conditions) = (0, 0);
    }
}
