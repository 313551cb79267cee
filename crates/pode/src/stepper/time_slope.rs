//! The derivative's rate by time at a fixed state.

use crate::state::State;
use crate::stepper::Field;

/// Distance of the places in steps: near for a small error, far for a rounding of 1e-13.
const PART: f64 = 1.0 / 64.0;

/// Returns h ∂f/∂t at the start (0, `x0`), where the derivative is `f0`; `h` is the step's length.
///
/// One-sided differences over the next `ORDER` = 1, 2 or 3 places, each 1/64 of the step further:
/// one evaluation a place, and an error of that order in h. One-sided, because the input is known
/// inside the step only. Exactly zero for autonomous equations. `[AS64]` table 25.2
#[inline]
pub(super) fn time_slope<S: State, const ORDER: usize>(
    field: &mut impl Field<S>,
    x0: &S,
    f0: &S,
) -> S {
    let weights: &[f64] = match ORDER {
        1 => &[1.0],
        2 => &[2.0, -0.5],
        _ => &[3.0, -1.5, 1.0 / 3.0],
    };
    let (mut slope, mut tau) = (S::ZERO, 0.0);
    for weight in weights {
        tau += PART;
        let rise = field.derivative(tau, x0).plus(-1.0, f0);
        slope = slope.plus(weight / PART, &rise);
    }
    slope
}
