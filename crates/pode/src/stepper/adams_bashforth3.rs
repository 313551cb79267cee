use crate::dense::Cubic;
use crate::state::State;
use crate::stepper::history::Past;
use crate::stepper::{DerivativeHistory, Field, Step, Stepper};

/// Order 3 in 1 evaluation, 3 in the first two steps and after every event; no error estimate.
///
/// A parabola in time through the derivatives at the start and one and two steps before is
/// integrated for the step and for the dense output, locally of fourth order. Steps may differ in
/// length. The first two steps, and one more than four times as long as a step before, are
/// [`BogackiShampine`](crate::stepper::BogackiShampine)'s of third order, with a parabola as dense
/// output: locally of third order, which keeps event times at order 3.
///
/// Carried: the derivatives at the starts of the last two steps, discarded like those of
/// [`AdamsBashforth2`](crate::stepper::AdamsBashforth2) (`[GC93]` 2.2). Where the derivative jumps
/// between two ticks, with the input or with a parameter that the input carries, two steps are of
/// order 1 in it.
///
/// Stability: h |λ| < 6/11 for damped motion, h ω < 0.72 for undamped. Choose it where the
/// derivative is costly, events are rare and the step is short for other reasons.
///
/// `[HNW93]` III.1, eq. 1.5; steps of different lengths III.5, eq. 5.5.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct AdamsBashforth3;

impl Stepper for AdamsBashforth3 {
    const ORDER: u32 = 3;
    /// Order of the first steps' dense output, which follow every event.
    const DENSE: u32 = 2;
    const EVALUATIONS: u32 = 3;
    const NAME: &'static str = "adams-bashforth3";

    type Memory<S: State> = DerivativeHistory<S, 2>;
    type Dense<S: State> = Cubic<S>;

    #[inline]
    fn step<S: State>(
        &self,
        field: &mut impl Field<S>,
        x0: &S,
        memory: &mut DerivativeHistory<S, 2>,
        h: f64,
    ) -> Step<S, Cubic<S>> {
        let k = field.derivative(0.0, x0);
        let dense = match memory.before(h) {
            None => first(field, x0, &k, h),
            Some(before) => integral(x0, &k, before, h),
        };
        memory.remember(k, h);
        Step::new(dense)
    }
}

#[inline]
fn integral<S: State>(x0: &S, k: &S, [last, older]: &[Past<S>; 2], h: f64) -> Cubic<S> {
    // Newton's divided differences of the slope, by time in steps.
    let rise = k.plus(-1.0, &last.slope).times(h / last.h);
    let older_rise = last.slope.plus(-1.0, &older.slope).times(h / older.h);
    let bend = rise.plus(-1.0, &older_rise).times(h / (last.h + older.h));
    let c1 = k.times(h);
    let c2 = rise.plus(last.h / h, &bend).times(0.5 * h);
    let c3 = bend.times(h / 3.0);
    let x1 = x0.plus(1.0, &c1).plus(1.0, &c2).plus(1.0, &c3);
    Cubic::cubic(*x0, c1, c2, c3, x1)
}

#[inline]
fn first<S: State>(field: &mut impl Field<S>, x0: &S, k1: &S, h: f64) -> Cubic<S> {
    let k2 = field.derivative(0.5, &x0.plus(0.5 * h, k1));
    let k3 = field.derivative(0.75, &x0.plus(0.75 * h, &k2));
    let x1 = x0.plus(h, &k1.times(2.0 / 9.0).plus(1.0 / 3.0, &k2).plus(4.0 / 9.0, &k3));
    Cubic::parabola(x0, k1, &x1, h)
}
