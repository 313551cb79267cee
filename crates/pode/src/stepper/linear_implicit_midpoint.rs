use crate::dense::Cubic;
use crate::state::State;
use crate::stepper::shifted::Shifted;
use crate::stepper::{Field, Step, Stepper};

/// Order 2, linearly implicit: k = (1 − h/2 J)⁻¹ f(t + h/2, x0), x1 = x0 + h k.
///
/// 2 evaluations, one Jacobian in the middle of the step, one LU; no error estimate. Any error in
/// the Jacobian of order h keeps order 2. Nothing is carried to the next step. Dense output: the
/// parabola x0 + τ h k − τ (1 − τ) (1 − h/2 J)⁻¹ h (k − f0), locally of third order.
///
/// Stability: passive. Where a linear mechanical system generates no energy, xᵀ E J x ≤ 0, neither
/// does a step, of any length, at any stiffness; without loss the energy is kept. For
/// |R(z)| = |1 + w|, w = z/(1 − z/2), is 1 on the imaginary axis and less to its left, and a
/// contraction's rational bound carries over to matrices. The same holds at every place of the
/// dense output, where an event may end the step: with z = 2i tan φ and σ = 2τ − 1,
/// |1 + τ w − τ (1 − τ) w²/2|² = 1 − τ (1 − τ) sin⁴φ (1 − σ)(3 − σ) ≤ 1.
/// Motion much faster than the step does not die out: it changes sign with every step, with the
/// factor 1 − 4/(h |λ|). Choose it for contacts too stiff for the tick whose energy counts more
/// than their shape. `[HW96]` IV.7 (one stage, γ = 1/2), IV.11, theorem 11.2 (J. von Neumann's).
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct LinearImplicitMidpoint;

impl Stepper for LinearImplicitMidpoint {
    const ORDER: u32 = 2;
    const EVALUATIONS: u32 = 2;
    const JACOBIANS: u32 = 1;
    const NAME: &'static str = "linear-implicit-midpoint";

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
        let lu = Shifted::new(&field.jacobian(0.5, x0), 0.5 * h);
        let rise = lu.solve(&field.derivative(0.5, x0).times(h));
        let bend = lu.solve(&rise.plus(-h, &field.derivative(0.0, x0)));
        let x1 = x0.plus(1.0, &rise);
        Step::new(Cubic::cubic(*x0, rise.plus(-1.0, &bend), bend, S::ZERO, x1).truncated(3))
    }
}
