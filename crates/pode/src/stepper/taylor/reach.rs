//! Of what order a series should be, and how far it reaches.

use crate::math::{ln, powf};
use crate::series::{Expansion, MOST_ORDER};
use crate::state::State;
use crate::stepper::Tolerance;

/// The order that takes the least work to a tolerance, where a step's work grows with the square
/// of the order: −½ ln ε, and one more. `[JZ05]` 3.2
pub(super) fn order_for(tolerance: f64) -> usize {
    let digits = -ln(tolerance.clamp(f64::EPSILON, 0.5));
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 20")]
    let order = (0.5 * digits + 2.0) as usize;
    order.clamp(4, MOST_ORDER)
}

/// How far (s) the series reaches: its last two terms are then within the tolerance.
///
/// Two of them, since one of them may vanish. `[JZ05]` 3.2. `None` if it is no series.
pub(super) fn of<S: State>(expansion: &Expansion<S>, tolerance: Tolerance) -> Option<f64> {
    /// Beyond it the series says nothing of what comes.
    const MOST: f64 = 1e6;
    let order = expansion.order;
    let ratios = [order, order - 1].map(|k| {
        let size = weigh(expansion.terms.get(k)?, &expansion.terms[0], tolerance);
        size.is_finite().then(|| if size > 0.0 { powf(size, -1.0 / k as f64) } else { MOST })
    });
    let [Some(last), Some(before)] = ratios else { return None };
    Some(expansion.scale * last.min(before).min(MOST))
}

/// Largest entry of a coefficient in units of the tolerance at `x`; not a number if one is not.
fn weigh<S: State>(term: &S, x: &S, tolerance: Tolerance) -> f64 {
    let entries = term.entries().iter().zip(x.entries());
    entries.fold(0.0, |most, (term, x)| {
        let size = term.abs() / (tolerance.absolute + tolerance.relative * x.abs());
        // Not `max`, which takes the other where one is no number.
        if size <= most || most.is_nan() { most } else { size }
    })
}
