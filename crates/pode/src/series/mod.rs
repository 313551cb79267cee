//! Taylor coefficients, one order after another.
//!
//! A model that knows its own series ([`Guarded::series`](crate::Guarded::series)) gives the solution
//! from a state on as a power series in time, of any order, and its guards along with it.
//! [`Taylor`](crate::stepper::Taylor) makes steps of them. Coefficients are scaled by powers of a
//! time that is about as long as the step, so that high orders neither overflow nor vanish.
//!
//! [`lanes`] sums the products that one more order takes.

mod bell;
mod falls;
mod guards;
pub mod lanes;

pub use bell::add_bell;
pub(crate) use falls::{Fall, first_fall};
pub(crate) use guards::GuardPolynomial;
pub use guards::GuardSeries;

use crate::state::State;

/// Highest order of a series.
pub const MOST_ORDER: usize = 24;

/// Coefficients of a series of the highest order.
pub const TERMS: usize = MOST_ORDER + 1;

/// 1/k, for k from 1 on; a division takes four times as long as a product.
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

/// Guards of a mode whose series are kept, the first of its list.
pub const MOST_GUARDS: usize = 6;

/// Conditions whose series are kept.
pub const MOST_CONDITIONS: usize = 12;

/// The solution from one state on, as a power series, with the guards along it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Expansion<S> {
    /// How many coefficients there are after the first, at most [`MOST_ORDER`].
    pub order: usize,
    /// The time (s) that belongs to τ = 1.
    pub scale: f64,
    /// Coefficients of x(τ) by power of τ; the first is the state that is given.
    pub terms: [S; TERMS],
    /// Coefficients of the guards along the solution, in the order of the mode's list.
    pub guards: [[f64; TERMS]; MOST_GUARDS],
    /// How many guards have theirs.
    pub known_guards: usize,
    /// Coefficients of what the equations' form depends on by its sign: where one of these comes to
    /// zero, as a felt that is left, the series ends.
    pub conditions: [[f64; TERMS]; MOST_CONDITIONS],
    /// How many conditions there are.
    pub known_conditions: usize,
}

impl<S: State> Expansion<S> {
    /// The expansion that is asked for: from `x`, up to `order`, in units of `scale` (s).
    pub fn of(x: &S, order: usize, scale: f64) -> Self {
        let mut new = Self::EMPTY;
        new.begin(x, order, scale);
        new
    }

    /// An expansion of nothing.
    pub const EMPTY: Self = Self {
        order: 0,
        scale: 1.0,
        terms: [S::ZERO; TERMS],
        guards: [[0.0; TERMS]; MOST_GUARDS],
        known_guards: 0,
        conditions: [[0.0; TERMS]; MOST_CONDITIONS],
        known_conditions: 0,
    };

    /// Asks for the expansion from `x`, up to `order`, in units of `scale` (s).
    #[inline]
    pub(crate) fn begin(&mut self, x: &S, order: usize, scale: f64) {
        self.order = order.clamp(1, MOST_ORDER);
        (self.scale, self.terms[0]) = (scale, *x);
        (self.known_guards, self.known_conditions) = (0, 0);
    }
}
