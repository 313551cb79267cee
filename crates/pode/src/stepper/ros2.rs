use crate::dense::Cubic;
use crate::state::State;
use crate::stepper::rosenbrock::{Tableau, weighted};
use crate::stepper::time_slope::time_slope;
use crate::stepper::{Field, Step, Stepper};

/// Order 2, linearly implicit: 3 evaluations, one Jacobian, one LU, an estimate of order 1.
///
/// One evaluation is for ∂f/∂t, by a difference of first order; it keeps order 2, as would any
/// error in the Jacobian. Dense output: of order 2 from the same two stages; it follows the stages,
/// not the slope at the start, and so stays bounded in a stiff transient. Nothing is carried.
///
/// γ = 1 − 1/√2. The other root, 1 + 1/√2, also makes the method L-stable and its response to fast
/// damped motion free of sign changes, but its error is 34 times as large.
///
/// Stability: L-stable. Motion much faster than the step is gone after it, but for 4.8/(h |λ|),
/// with the opposite sign. Choose it for stiff contacts with loss, where a few parts in 10³ are
/// enough; it damps motion that oscillates faster than the step.
///
/// `[VSB99]` section 2; the form without products `[HW96]` IV.7, eq. 7.25.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Ros2;

const GAMMA: f64 = 1.0 - core::f64::consts::FRAC_1_SQRT_2;

const TABLEAU: Tableau<2> = Tableau {
    gamma: GAMMA,
    nodes: [0.0, 1.0],
    a: [[0.0, 0.0], [1.0 / GAMMA, 0.0]],
    c: [[0.0, 0.0], [-2.0 / GAMMA, 0.0]],
    d: [GAMMA, -GAMMA],
    at_start: 1,
};

/// Weights of the stages at τ and τ². Their sum ends the step.
const DENSE: [[f64; 2]; 2] = {
    // b2 = (τ²/2 − γ τ)/(1 − 2γ) and b1 = τ − b2 meet both conditions of order 2 at every τ;
    // in terms of u: (b1 + 2 b2)/γ and b2/γ.
    let slope = -1.0 / (1.0 - 2.0 * GAMMA);
    let bend = 0.5 / (GAMMA * (1.0 - 2.0 * GAMMA));
    [[1.0 / GAMMA + slope, slope], [bend, bend]]
};

impl Stepper for Ros2 {
    const ORDER: u32 = 2;
    const EVALUATIONS: u32 = 3;
    const JACOBIANS: u32 = 1;
    const NAME: &'static str = "ros2";

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
        let u = TABLEAU.stages(field, (x0, &f0), &slope, h);
        let [c1, c2] = [0, 1].map(|power| weighted(&DENSE[power], &u));
        let x1 = x0.plus(1.5 / GAMMA, &u[0]).plus(0.5 / GAMMA, &u[1]);
        let dense = Cubic::cubic(*x0, c1, c2, S::ZERO, x1).truncated(3);
        // Difference from x0 + h k1, of order 1.
        let error = u[0].plus(1.0, &u[1]).times(0.5 / GAMMA);
        Step::new(dense).with_error(error)
    }
}
