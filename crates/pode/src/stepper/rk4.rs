//! The classical fourth-order Runge–Kutta method.

use crate::dense::Dense;
use crate::state::State;
use crate::stepper::{Step, Stepper};

/// Order 4 in 4 evaluations, no error estimate.
///
/// Dense output: the third-order cubic from the same four stages, so that locating an
/// event costs no derivative; its local error h⁴ keeps event times at order 4.
/// Nothing is carried to the next step, so nothing is discarded after a reset.
///
/// # References
/// [HNW93] II.1, table 1.2; dense output II.6, eq. 6.9.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Rk4;

impl Stepper for Rk4 {
    const ORDER: u32 = 4;
    const EVALUATIONS: u32 = 4;
    const NAME: &'static str = "rk4";

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
        let k2 = f(0.5, &x0.plus(0.5 * h, &k1));
        let k3 = f(0.5, &x0.plus(0.5 * h, &k2));
        let k4 = f(1.0, &x0.plus(h, &k3));
        let k23 = k2.plus(1.0, &k3);
        let x1 = x0.plus(h / 6.0, &k1.plus(2.0, &k23).plus(1.0, &k4));
        // b1 = τ − 3τ²/2 + 2τ³/3, b2 = b3 = τ² − 2τ³/3, b4 = −τ²/2 + 2τ³/3.
        let c1 = k1.times(h);
        let c2 = k23.plus(-1.5, &k1).plus(-0.5, &k4).times(h);
        let c3 = k1.plus(-1.0, &k23).plus(1.0, &k4).times(h * (2.0 / 3.0));
        let dense = Dense::cubic(*x0, c1, c2, c3, x1);
        Step { dense, last: None, error: 0.0, evaluations: Self::EVALUATIONS }
    }
}
