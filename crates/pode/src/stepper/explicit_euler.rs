use crate::dense::Cubic;
use crate::state::State;
use crate::stepper::{Field, Step, Stepper};

/// Order 1 in 1 evaluation, no error estimate.
///
/// Dense output: the straight line, locally of second order, so events keep order 1. Nothing is
/// carried to the next step.
///
/// Stability: damped motion needs h |λ| < 2; an undamped oscillator gains (ω h)² of its energy in
/// every step, however short. For comparison only:
/// [`SemiImplicitEuler`](crate::stepper::SemiImplicitEuler) is as simple and bounds the energy.
///
/// `[HNW93]` I.7, eq. 7.3; `[HLW06]` I.1.2, eq. 1.5.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct ExplicitEuler;

impl Stepper for ExplicitEuler {
    const ORDER: u32 = 1;
    const EVALUATIONS: u32 = 1;
    const NAME: &'static str = "explicit-euler";

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
        let c1 = field.derivative(0.0, x0).times(h);
        let x1 = x0.plus(1.0, &c1);
        Step::new(Cubic::cubic(*x0, c1, S::ZERO, S::ZERO, x1).truncated(2))
    }
}
