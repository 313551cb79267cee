//! Order and reach of a series.

use crate::math::{floor, ln};
use crate::series::{Expansion, MOST_ORDER};
use crate::state::State;
use crate::stepper::Tolerance;

/// Returns the order of least work for a tolerance. It is −½ ln ε where a step's work grows with
/// the square of the order `[JZ05]`. Work beside the sums favours higher orders: on the paper's
/// figure 6 orders from 16 to 22 differ by 5 % within 1e-9, and from 20 to 24 within 1e-13.
pub(super) fn order_for(tolerance: f64) -> usize {
    let digits = -ln(tolerance.clamp(f64::EPSILON, 0.5));
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 25")]
    let order = (8.5 + 0.46 * digits) as usize;
    order.clamp(4, MOST_ORDER)
}

/// Returns the reach (s) at which the last two terms of the series are within the tolerance (two,
/// since one may vanish). `[JZ05]` 3.2. `None` if it is not a series.
pub(super) fn of<S: State>(expansion: &Expansion<S>, tolerance: Tolerance) -> Option<f64> {
    const MOST: f64 = 1e6;
    let order = expansion.order;
    let ratios = [order, order - 1].map(|k| {
        let size = weigh(expansion.terms.get(k)?, &expansion.terms[0], tolerance);
        size.is_finite().then(|| if size > 0.0 { per_root(size, k) } else { MOST })
    });
    let [Some(last), Some(before)] = ratios else { return None };
    Some(expansion.scale * last.min(before).min(MOST))
}

/// Returns the largest entry of a coefficient in units of the tolerance at `x`; NaN if one is NaN.
fn weigh<S: State>(term: &S, x: &S, tolerance: Tolerance) -> f64 {
    let entries = term.entries().iter().zip(x.entries());
    entries.fold(0.0, |most, (term, x)| {
        let size = term.abs() / (tolerance.absolute + tolerance.relative * x.abs());
        // Not `max`, which ignores NaN.
        if size <= most || most.is_nan() { most } else { size }
    })
}

/// Returns 1/ᵏ√x of a positive x to 1e-3, which is enough for a step's length.
fn per_root(x: f64, k: usize) -> f64 {
    const MANTISSA: u64 = (1 << 52) - 1;
    const ONE: u64 = 1023 << 52;
    let fraction = f64::from_bits(x.to_bits() & MANTISSA | ONE) - 1.0;
    // log2(1 + f) and 2ᶠ by parabolas through both ends.
    let whole = (x.to_bits() >> 52) as f64 - 1023.0;
    let log = whole + fraction * (1.344 - 0.344 * fraction);
    let power = (-log / k as f64).clamp(-1000.0, 1000.0);
    let floor = floor(power);
    let fraction = power - floor;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "23 to 2023")]
    let scale = f64::from_bits(((floor + 1023.0) as u64) << 52);
    scale * (1.0 + fraction * (0.6565 + 0.3435 * fraction))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_root_is_right_to_a_part_in_a_hundred() {
        for n in -300..300 {
            let x = 10.0_f64.powf(0.37 * f64::from(n));
            for k in [4, 12, 24] {
                let ratio = per_root(x, k) * x.powf(1.0 / k as f64);
                assert!((ratio - 1.0).abs() < 1e-2, "{x:e}, {k}: {ratio}");
            }
        }
    }

    #[test]
    fn more_digits_take_a_higher_order() {
        assert_eq!([1e-3, 1e-9, 1e-13, 0.0].map(order_for), [11, 18, 22, 24]);
    }
}
