use crate::dense::Cubic;
use crate::state::State;
use crate::stepper::{EndDerivative, Field, Step, Stepper};

/// Order 3 with an embedded estimate of order 2, in 4 evaluations, 3 after the first.
///
/// Dense output: the cubic Hermite of the step. First-same-as-last: the derivative at the end is
/// carried, and void after a reset, a jump of the input, or a change of the mode.
///
/// `[BS89]`; `[HNW93]` II.4.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct BogackiShampine;

impl Stepper for BogackiShampine {
    const ORDER: u32 = 3;
    const EVALUATIONS: u32 = 4;
    const NAME: &'static str = "bogacki-shampine";

    type Memory<S: State> = EndDerivative<S>;
    type Dense<S: State> = Cubic<S>;

    #[inline]
    fn step<S: State>(
        &self,
        field: &mut impl Field<S>,
        x0: &S,
        memory: &mut EndDerivative<S>,
        h: f64,
    ) -> Step<S, Cubic<S>> {
        let k1 = memory.0.unwrap_or_else(|| field.derivative(0.0, x0));
        let k2 = field.derivative(0.5, &x0.plus(0.5 * h, &k1));
        let k3 = field.derivative(0.75, &x0.plus(0.75 * h, &k2));
        let sum = k1.times(2.0 / 9.0).plus(1.0 / 3.0, &k2).plus(4.0 / 9.0, &k3);
        let x1 = x0.plus(h, &sum);
        let k4 = field.derivative(1.0, &x1);
        let difference =
            k1.times(-5.0 / 72.0).plus(1.0 / 12.0, &k2).plus(1.0 / 9.0, &k3).plus(-1.0 / 8.0, &k4);
        let dense = Cubic::hermite(x0, &k1, &x1, &k4, h);
        memory.0 = Some(k4);
        Step::new(dense).with_error(difference.times(h))
    }
}
