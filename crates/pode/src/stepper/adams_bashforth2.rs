use crate::dense::Cubic;
use crate::state::State;
use crate::stepper::{DerivativeHistory, Field, Step, Stepper};

/// Order 2 in 1 evaluation, 2 in the first step and after every event; no error estimate.
///
/// A straight line in time through the derivatives at the start and one step before is integrated
/// for the step and for the dense output, locally of third order. Steps may differ in length. The
/// first step, and one more than four times as long as the step before, is
/// [`Heun`](crate::stepper::Heun)'s.
///
/// Carried: the derivative at the start of the last step. A reset, an event that cuts a step short,
/// a change of the mode and another model discard it, as `[GC93]` 2.2 demands of a multistep
/// method. A new tick does not: where the derivative jumps between two ticks, with the input or
/// with a parameter that the input carries, one step is of order 1 in it.
///
/// Stability: h |λ| < 1 for damped motion; an undamped oscillator gains (ω h)⁴/2 of its energy in
/// every step. Choose it where the derivative is costly and events are rare.
///
/// `[HNW93]` III.1, eq. 1.5; steps of different lengths III.5, eq. 5.5.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct AdamsBashforth2;

impl Stepper for AdamsBashforth2 {
    const ORDER: u32 = 2;
    const EVALUATIONS: u32 = 2;
    const NAME: &'static str = "adams-bashforth2";

    type Memory<S: State> = DerivativeHistory<S, 1>;
    type Dense<S: State> = Cubic<S>;

    #[inline]
    fn step<S: State>(
        &self,
        field: &mut impl Field<S>,
        x0: &S,
        memory: &mut DerivativeHistory<S, 1>,
        h: f64,
    ) -> Step<S, Cubic<S>> {
        let k = field.derivative(0.0, x0);
        let dense = match memory.before(h) {
            None => first(field, x0, &k, h),
            Some([before]) => {
                let rise = k.plus(-1.0, &before.slope).times(h / before.h);
                let (c1, c2) = (k.times(h), rise.times(0.5 * h));
                let x1 = x0.plus(1.0, &c1).plus(1.0, &c2);
                Cubic::cubic(*x0, c1, c2, S::ZERO, x1)
            }
        };
        memory.remember(k, h);
        Step::new(dense)
    }
}

#[inline]
fn first<S: State>(field: &mut impl Field<S>, x0: &S, k1: &S, h: f64) -> Cubic<S> {
    let k2 = field.derivative(1.0, &x0.plus(h, k1));
    let x1 = x0.plus(0.5 * h, &k1.plus(1.0, &k2));
    Cubic::parabola(x0, k1, &x1, h)
}
