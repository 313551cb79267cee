//! The Bogacki–Shampine 3(2) pair.

use crate::dense::Dense;
use crate::state::State;
use crate::stepper::{Step, Stepper};

/// Order 3 with an embedded estimate of order 2, in 4 evaluations, 3 after the first.
///
/// Dense output: the cubic Hermite of the step. First-same-as-last: the derivative at
/// the end is carried to the next step and must be discarded after a reset, a jump of
/// the input, or a change of the mode.
///
/// # References
/// [BS89]; [HNW93] II.4.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct BogackiShampine;

impl Stepper for BogackiShampine {
    const ORDER: u32 = 3;
    const EVALUATIONS: u32 = 4;
    const NAME: &'static str = "bogacki-shampine";

    #[inline]
    fn step<S: State>(
        &self,
        mut f: impl FnMut(f64, &S) -> S,
        x0: &S,
        first: Option<&S>,
        h: f64,
        _coords: usize,
    ) -> Step<S> {
        let k1 = first.copied().unwrap_or_else(|| f(0.0, x0));
        let k2 = f(0.5, &x0.plus(0.5 * h, &k1));
        let k3 = f(0.75, &x0.plus(0.75 * h, &k2));
        let sum = k1.times(2.0 / 9.0).plus(1.0 / 3.0, &k2).plus(4.0 / 9.0, &k3);
        let x1 = x0.plus(h, &sum);
        let k4 = f(1.0, &x1);
        // Difference of the third- and second-order results.
        let difference =
            k1.times(-5.0 / 72.0).plus(1.0 / 12.0, &k2).plus(1.0 / 9.0, &k3).plus(-1.0 / 8.0, &k4);
        let error = difference.entries().iter().fold(0.0, |most: f64, e| most.max((h * e).abs()));
        let dense = Dense::hermite(x0, &k1, &x1, &k4, h);
        let evaluations = if first.is_some() { 3 } else { 4 };
        Step { dense, last: Some(k4), error, evaluations }
    }
}
