use crate::dense::Cubic;
use crate::state::State;
use crate::stepper::rosenbrock::{Tableau, weighted};
use crate::stepper::time_slope::time_slope;
use crate::stepper::{Field, Step, Stepper};

/// Order 3, linearly implicit: 5 evaluations, one Jacobian, one LU, an estimate of order 2.
///
/// Three evaluations are for the four stages, two of which share one, and two for ∂f/∂t, by a
/// difference of second order. Dense output: of order 2 from the same stages, bounded in a stiff
/// transient; its local error h³ keeps event times at order 3. Nothing is carried to the next step.
///
/// Stability: L-stable and stiffly accurate, as its embedded method is: motion much faster than the
/// step is gone after it, and forced motion is followed to 1/(h |λ|). Choose it for stiff modes
/// with loss.
///
/// `[SVB97]` (RODAS3); the form without products `[HW96]` IV.7, eq. 7.25. The dense output is our
/// own: b1 + b2 + b3 + b4 = τ, Σ bᵢ βᵢ = τ²/2, b3 + b4 = τ³/3 (no choice meets the fourth condition
/// of order 3), and b4 = τ³/2 for a quiet middle.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Rodas3;

const TABLEAU: Tableau<4> = Tableau {
    gamma: 0.5,
    nodes: [0.0, 0.0, 1.0, 1.0],
    a: [[0.0; 4], [0.0; 4], [2.0, 0.0, 0.0, 0.0], [2.0, 0.0, 1.0, 0.0]],
    c: [[0.0; 4], [4.0, 0.0, 0.0, 0.0], [1.0, -1.0, 0.0, 0.0], [1.0, -1.0, -8.0 / 3.0, 0.0]],
    d: [0.5, 1.5, 0.0, 0.0],
    at_start: 2,
};

/// Weights of the stages at τ, τ² and τ³. Their sum ends the step.
const DENSE: [[f64; 4]; 3] = [[5.0, -1.0, 0.0, 0.0], [-3.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 1.0]];

impl Stepper for Rodas3 {
    const ORDER: u32 = 3;
    const DENSE: u32 = 2;
    const EVALUATIONS: u32 = 5;
    const JACOBIANS: u32 = 1;
    const NAME: &'static str = "rodas3";

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
        let slope = time_slope(field, x0, &f0);
        let u = TABLEAU.stages(field, (x0, &f0), &slope, h);
        let [c1, c2, c3] = [0, 1, 2].map(|power| weighted(&DENSE[power], &u));
        let x1 = x0.plus(2.0, &u[0]).plus(1.0, &u[2]).plus(1.0, &u[3]);
        Step::new(Cubic::cubic(*x0, c1, c2, c3, x1)).with_error(u[3])
    }
}
