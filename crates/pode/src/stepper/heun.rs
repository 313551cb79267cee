//! Heun's second-order method.

use crate::dense::Dense;
use crate::state::State;
use crate::stepper::{Step, Stepper};

/// Order 2 in 2 evaluations, no error estimate.
///
/// Dense output: the parabola through the start, its slope and the end.
/// Nothing is carried to the next step, so nothing is discarded after a reset.
///
/// # References
/// [HNW93] II.1.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Heun;

impl Stepper for Heun {
    const ORDER: u32 = 2;
    const EVALUATIONS: u32 = 2;
    const NAME: &'static str = "heun";

    #[inline]
    fn step<S: State>(
        &self,
        mut f: impl FnMut(f64, &S) -> S,
        x0: &S,
        _first: Option<&S>,
        h: f64,
        _coords: usize,
    ) -> Step<S> {
        let k1 = f(0.0, x0);
        let k2 = f(1.0, &x0.plus(h, &k1));
        let x1 = x0.plus(0.5 * h, &k1.plus(1.0, &k2));
        let dense = Dense::parabola(x0, &k1, &x1, h);
        Step { dense, last: None, error: 0.0, evaluations: Self::EVALUATIONS }
    }
}
