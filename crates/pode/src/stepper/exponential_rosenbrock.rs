use crate::dense::Cubic;
use crate::phi::Phi;
use crate::state::Matrix as _;
use crate::state::State;
use crate::stepper::quarters::{PLACES, through_quarters};
use crate::stepper::time_slope::time_slope;
use crate::stepper::{Field, Step, Stepper};

/// Order 2, exponential: x1 = x0 + h φ1(h J) f + h² φ2(h J) ∂f/∂t.
///
/// 2 evaluations, one of them for ∂f/∂t by a difference of first order, and one Jacobian, which
/// must be exact to keep order 2; no linear system, no error estimate. Exact where the mode is
/// linear with a forcing that is straight over the step, at any stiffness. Dense output: the cubic
/// through the same formula at a quarter, a half and the whole of the step, by-products of the
/// matrix functions; locally of third order, and bounded in a stiff transient. Nothing is carried
/// to the next step.
///
/// Stability: that of the linear part, which is solved: L-stable, without numerical damping. Work:
/// 18 matrix products, and 4 for every doubling of |h J| beyond 4. Choose it for nearly linear
/// modes, an oscillator with a weak nonlinearity, whose phase counts. `[HO10]` 2.4; `[HOS09]`.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct ExponentialRosenbrock;

impl Stepper for ExponentialRosenbrock {
    const ORDER: u32 = 2;
    const EVALUATIONS: u32 = 2;
    const JACOBIANS: u32 = 1;
    const NAME: &'static str = "exponential-rosenbrock";

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
        let slope = time_slope::<S, 1>(field, x0, &f0);
        let phi = Phi::<S>::quarters(&field.jacobian(0.0, x0), h);
        let rises = [0, 1, 2].map(|n| {
            let tau = PLACES[n];
            let steady = phi[n].p1.apply(&f0).times(tau * h);
            steady.plus(0.5 * tau * tau * h, &phi[n].p2.apply(&slope))
        });
        Step::new(through_quarters(x0, &rises))
    }
}
