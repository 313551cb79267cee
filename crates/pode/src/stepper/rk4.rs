//! The classical fourth-order Runge–Kutta method.

use crate::dense::Cubic;
use crate::state::State;
use crate::stepper::{Field, Step, Stepper};

/// Order 4 in 4 evaluations, no error estimate.
///
/// Dense output: the third-order cubic from the same four stages, so that locating an event costs
/// no derivative; its local error h⁴ keeps event times at order 4. Nothing is carried.
///
/// `[HNW93]` II.1, table 1.2; dense output II.6, eq. 6.9.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Rk4;

impl Stepper for Rk4 {
    const ORDER: u32 = 4;
    const DENSE: u32 = 3;
    const EVALUATIONS: u32 = 4;
    const NAME: &'static str = "rk4";

    type Memory<S: State> = ();
    type Dense<S: State> = Cubic<S>;

    #[expect(clippy::inline_always, reason = "a call takes the stages through memory")]
    #[inline(always)]
    fn step<S: State>(
        &self,
        field: &mut impl Field<S>,
        x0: &S,
        _memory: &mut (),
        h: f64,
    ) -> Step<S, Cubic<S>> {
        let k1 = field.derivative(0.0, x0);
        let k2 = field.derivative(0.5, &x0.plus(0.5 * h, &k1));
        let k3 = field.derivative(0.5, &x0.plus(0.5 * h, &k2));
        let k4 = field.derivative(1.0, &x0.plus(h, &k3));
        let k23 = k2.plus(1.0, &k3);
        let x1 = x0.plus(h / 6.0, &k1.plus(2.0, &k23).plus(1.0, &k4));
        // b1 = τ − 3τ²/2 + 2τ³/3, b2 = b3 = τ² − 2τ³/3, b4 = −τ²/2 + 2τ³/3.
        let c1 = k1.times(h);
        let c2 = k23.plus(-1.5, &k1).plus(-0.5, &k4).times(h);
        let c3 = k1.plus(-1.0, &k23).plus(1.0, &k4).times(h * (2.0 / 3.0));
        let dense = Cubic::cubic(*x0, c1, c2, c3, x1);
        Step::new(dense)
    }
}
