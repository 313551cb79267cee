use crate::dense::Cubic;
use crate::state::State;
use crate::stepper::{Field, Step, Stepper};

/// Order 2 in 2 evaluations, no error estimate.
///
/// Dense output: the parabola through the start, its slope and the end. Nothing is carried.
///
/// `[HNW93]` II.1.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Heun;

impl Stepper for Heun {
    const ORDER: u32 = 2;
    const EVALUATIONS: u32 = 2;
    const NAME: &'static str = "heun";

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
        let k1 = field.derivative(0.0, x0);
        let k2 = field.derivative(1.0, &x0.plus(h, &k1));
        let x1 = x0.plus(0.5 * h, &k1.plus(1.0, &k2));
        let dense = Cubic::parabola(x0, &k1, &x1, h);
        Step::new(dense)
    }
}
