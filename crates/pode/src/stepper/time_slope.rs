//! The derivative's rate by time at a fixed state.

use crate::state::State;
use crate::stepper::Field;

/// Distance of the places in steps: near for a small error, far for a rounding of 1e-13.
const PART: f64 = 1.0 / 64.0;

/// Returns h ∂f/∂t at the start (0, `x0`), where the derivative is `f0`; `h` is the step's length.
///
/// One-sided differences over two places, 1/64 and 2/64 of the step: two evaluations, and an error
/// of second order in h. One-sided, because the input is known inside the step only. Exactly zero
/// for autonomous equations. `[AS64]` table 25.2
#[inline]
pub(super) fn time_slope<S: State>(field: &mut impl Field<S>, x0: &S, f0: &S) -> S {
    let mut rise = |places: f64| field.derivative(places * PART, x0).plus(-1.0, f0);
    let near = rise(1.0).times(2.0 / PART);
    near.plus(-0.5 / PART, &rise(2.0))
}
