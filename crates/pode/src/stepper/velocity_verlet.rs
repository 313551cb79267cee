use crate::dense::Cubic;
use crate::state::State;
use crate::stepper::{Field, Step, Stepper};

/// Order 2 in 2 evaluations: half a kick, a drift with the speeds between, half a kick.
///
/// No error estimate. Symplectic and symmetric for x'' = a(x, t): the energy of a conservative mode
/// swings about its value by a fraction (ω h)² and does not drift. Dense output: the parabola
/// through the start, its slope and the end, locally of third order. Nothing is carried.
///
/// Forces that depend on the speed: the second kick takes them at the speed that the first
/// derivative predicts, v0 + h a0. That keeps order 2, and gives up the symplectic structure, as
/// damping does anyway.
///
/// The entry `coords + i` is the rate of the coordinate `i` if the derivative at the start equals
/// it, to the bit. Otherwise, with fewer speeds than coordinates or with coordinates whose rate is
/// not their speed, the drift takes the rates from a third evaluation in the middle of the step,
/// which keeps order 2. Entries after the speeds are moved like speeds.
///
/// Stability: h ω < 2. Choose it for conservative modes that are followed for long.
///
/// `[SAB82]`; `[HLW06]` I.1.4, eq. 1.17, and VI.3 for its structure.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct VelocityVerlet;

impl Stepper for VelocityVerlet {
    const ORDER: u32 = 2;
    /// 2 where the coordinates' rates are the speeds.
    const EVALUATIONS: u32 = 3;
    const NAME: &'static str = "velocity-verlet";

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
        let coords = field.coords();
        let k1 = field.derivative(0.0, x0);
        let middle = x0.plus(0.5 * h, &k1);
        let rates = if speeds_are_rates(coords, x0, &k1) {
            speeds_first(coords, &middle)
        } else {
            field.derivative(0.5, &middle)
        };
        let drifted = x0.plus(h, &rates);
        let k2 = field.derivative(1.0, &drifted.head_of(coords, &x0.plus(h, &k1)));
        let x1 = drifted.head_of(coords, &x0.plus(0.5 * h, &k1.plus(1.0, &k2)));
        Step::new(Cubic::parabola(x0, &k1, &x1, h))
    }
}

#[inline]
fn speeds_are_rates<S: State>(coords: usize, x: &S, k: &S) -> bool {
    let (x, k) = (x.entries(), k.entries());
    2 * coords <= x.len() && x.iter().skip(coords).zip(k).take(coords).all(|(u, k)| u - k == 0.0)
}

#[inline]
fn speeds_first<S: State>(coords: usize, x: &S) -> S {
    let speeds = x.entries().iter().skip(coords).take(coords).enumerate();
    speeds.fold(*x, |moved, (index, speed)| moved.with_entry(index, *speed))
}
