//! Semi-implicit (symplectic) Euler.

use crate::dense::Cubic;
use crate::state::State;
use crate::stepper::{Field, Step, Stepper};

/// Order 1 in 2 evaluations: speeds first, then coordinates with the new speeds.
///
/// No error estimate. Keeps the energy of an oscillator bounded where explicit Euler lets it grow.
/// Dense output: the parabola through the start, its slope and the end. Nothing is carried.
///
/// `[HLW06]` I.1.2, eq. 1.9.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct SemiImplicitEuler;

impl Stepper for SemiImplicitEuler {
    const ORDER: u32 = 1;
    const EVALUATIONS: u32 = 2;
    const NAME: &'static str = "semi-implicit-euler";

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
        let with_new_speeds = x0.head_of(field.coords(), &x0.plus(h, &k1));
        let k2 = field.derivative(1.0, &with_new_speeds);
        let x1 = x0.plus(h, &k2).head_of(field.coords(), &with_new_speeds);
        let dense = Cubic::parabola(x0, &k1, &x1, h);
        Step::new(dense)
    }
}
