//! Semi-implicit (symplectic) Euler.

use crate::dense::Dense;
use crate::state::State;
use crate::stepper::{Step, Stepper};

/// Order 1 in 2 evaluations: speeds first, then coordinates with the new speeds.
///
/// No error estimate. Keeps the energy of an oscillator bounded where explicit Euler
/// lets it grow. Dense output: the parabola through the start, its slope and the end.
/// Nothing is carried to the next step, so nothing is discarded after a reset.
///
/// # References
/// [HLW06] I.1.2, eq. 1.9.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct SemiImplicitEuler;

impl Stepper for SemiImplicitEuler {
    const ORDER: u32 = 1;
    const EVALUATIONS: u32 = 2;
    const NAME: &'static str = "semi-implicit-euler";

    #[inline]
    fn step<S: State>(
        &self,
        mut f: impl FnMut(f64, &S) -> S,
        x0: &S,
        _first: Option<&S>,
        h: f64,
        coords: usize,
    ) -> Step<S> {
        let k1 = f(0.0, x0);
        let with_new_speeds = x0.head_of(coords, &x0.plus(h, &k1));
        let k2 = f(1.0, &with_new_speeds);
        let x1 = x0.plus(h, &k2).head_of(coords, &with_new_speeds);
        let dense = Dense::parabola(x0, &k1, &x1, h);
        Step { dense, last: None, error: 0.0, evaluations: Self::EVALUATIONS }
    }
}
