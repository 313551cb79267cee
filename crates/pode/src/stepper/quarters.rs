use crate::dense::Cubic;
use crate::state::State;

pub(super) const PLACES: [f64; 3] = [0.25, 0.5, 1.0];

/// Returns the cubic through `x0` and the state's rises at [`PLACES`]: locally of fourth order, and
/// bounded by a small multiple of the values, however stiff the motion.
#[inline]
pub(super) fn through_quarters<S: State>(x0: &S, rises: &[S; 3]) -> Cubic<S> {
    let [first, second, third] = [0, 1, 2].map(|n| rises[n].times(1.0 / PLACES[n]));
    let c1 = first.times(8.0 / 3.0).plus(-2.0, &second).plus(1.0 / 3.0, &third);
    let c2 = first.times(-8.0).plus(10.0, &second).plus(-2.0, &third);
    let c3 = first.times(16.0 / 3.0).plus(-8.0, &second).plus(8.0 / 3.0, &third);
    Cubic::cubic(*x0, c1, c2, c3, x0.plus(1.0, &rises[2]))
}
