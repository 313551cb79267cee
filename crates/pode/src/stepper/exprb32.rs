//! The exponential Rosenbrock pair exprb32.

use crate::dense::Cubic;
use crate::phi::Phi;
use crate::state::Matrix as _;
use crate::state::State;
use crate::stepper::quarters::{PLACES, through_quarters};
use crate::stepper::time_slope::time_slope;
use crate::stepper::{Field, Step, Stepper};

/// Order 3, exponential: the exponential Rosenbrock–Euler step, and 2 h φ3(h J) times the error of
/// the linearisation at its end; the correction is the embedded estimate of order 2.
///
/// 4 evaluations, two of them for ∂f/∂t by a difference of second order, and one Jacobian, which
/// must be exact to keep order 3. Exact where the mode is linear with a forcing that is a parabola
/// over the step. Dense output locally of fourth order. All else, work included, is that of
/// [`ExponentialRosenbrock`](crate::stepper::ExponentialRosenbrock); choose it where that would
/// need shorter steps. `[HOS09]`; `[HO10]` 2.4.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Exprb32;

impl Stepper for Exprb32 {
    const ORDER: u32 = 3;
    const EVALUATIONS: u32 = 4;
    const JACOBIANS: u32 = 1;
    const NAME: &'static str = "exprb32";

    type Memory<S: State> = ();
    type Dense<S: State> = Cubic<S>;

    #[inline]
    fn step<S: State>(
        &self,
        field: &mut impl Field<S>,
        x0: &S,
        _memory: &mut (),
        h: f64,
    ) -> Step<S, Cubic<S>> {
        let f0 = field.derivative(0.0, x0);
        let slope = time_slope::<S, 2>(field, x0, &f0);
        let jacobian = field.jacobian(0.0, x0);
        let phi = Phi::<S>::quarters(&jacobian, h);
        let euler = [0, 1, 2].map(|n| {
            let tau = PLACES[n];
            let steady = phi[n].p1.apply(&f0).times(tau * h);
            steady.plus(0.5 * tau * tau * h, &phi[n].p2.apply(&slope))
        });
        // The derivative at the end beyond the linear part's.
        let linear = f0.plus(1.0, &jacobian.apply(&euler[2])).plus(1.0, &slope);
        let missed = field.derivative(1.0, &x0.plus(1.0, &euler[2])).plus(-1.0, &linear);
        // It grows as the square of time: 2 h τ³ φ3.
        let corrections = [0, 1, 2].map(|n| {
            let tau = PLACES[n];
            phi[n].p3.apply(&missed).times(tau * tau * tau * h / 3.0)
        });
        let rises = [0, 1, 2].map(|n| euler[n].plus(1.0, &corrections[n]));
        Step::new(through_quarters(x0, &rises)).with_error(corrections[2])
    }
}
