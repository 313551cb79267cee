//! The first root of a guard in a step, isolated with certainty where its bend is bounded.
//!
//! The step is halved from left to right until each half is either free of roots, since the guard
//! lies above a parabola through its ends, or holds exactly one, since the guard falls through it
//! with a slope that cannot vanish. `[MKC09]` ch. 8: roots are isolated by enclosures of a function
//! and of its derivatives.

use crate::enclosure::least;

#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Isolated {
    /// The guard is positive over the whole step.
    Free,
    /// The first root lies between these places, the only one there.
    Root { lo: (f64, f64), hi: (f64, f64) },
    /// Too many halvings. `low`: the first place with a known negative value, and that value.
    Open { low: Option<(f64, f64)> },
}

pub(crate) const LOOKS: u32 = 32;

/// Maximum of intervals that wait for their turn: one for each halving.
const DEPTH: usize = LOOKS as usize + 1;

/// Isolates the first root of a `guard` that starts positive, with values `start` and `end` at the
/// ends, a second derivative within `bend` (per step²), and rounding within `band`.
#[cold]
pub(crate) fn isolate(
    (start, end): (f64, f64),
    bend: f64,
    band: f64,
    mut guard: impl FnMut(f64) -> f64,
) -> Isolated {
    let mut waiting = [(1.0, end); DEPTH];
    let (mut count, mut lo) = (1, (0.0, start));
    let mut low = (end < -band).then_some((1.0, end));
    let mut looks = 0;
    while count > 0 {
        let hi = waiting[count - 1];
        let width = hi.0 - lo.0;
        let bow = bend * width * width;
        if least(lo.1 - band, hi.1 - band, bow) > 0.0 {
            (lo, count) = (hi, count - 1);
        } else if hi.1 < -band && lo.1 - hi.1 > bow {
            return Isolated::Root { lo, hi };
        } else if looks == LOOKS {
            return Isolated::Open { low };
        } else {
            looks += 1;
            let middle = lo.0 + 0.5 * width;
            let value = guard(middle);
            if value.is_nan() {
                return Isolated::Open { low };
            }
            if value < -band {
                low = Some((middle, value));
            }
            waiting[count] = (middle, value);
            count += 1;
        }
    }
    Isolated::Free
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the result for `guard` with a second derivative up to `bend`, and the evaluations.
    fn found(bend: f64, guard: impl Fn(f64) -> f64) -> (Isolated, u32) {
        let mut looks = 0;
        let isolated = isolate((guard(0.0), guard(1.0)), bend, 1e-15, |tau| {
            looks += 1;
            guard(tau)
        });
        (isolated, looks)
    }

    #[test]
    fn a_wave_that_falls_below_zero_ten_times_is_found_at_its_first_fall() {
        // A guard faster than the step: 0.999 − sin 10 τ at bend 100.
        let (isolated, looks) = found(100.0, |tau| 0.999 - (10.0 * tau).sin());
        let root = 0.999_f64.asin() / 10.0;
        let Isolated::Root { lo, hi } = isolated else { panic!("{isolated:?}") };
        assert!(lo.0 < root && root < hi.0 && hi.0 < (std::f64::consts::PI - 10.0 * root) / 10.0);
        assert!(looks <= 12, "{looks}");
    }

    #[test]
    fn a_dip_that_stays_above_zero_is_proven_to() {
        for depth in [1e-2, 1e-4, 1e-6] {
            let (isolated, looks) = found(2.1, |tau| (tau - 0.37) * (tau - 0.37) + depth);
            assert_eq!(isolated, Isolated::Free, "{depth:e} after {looks}");
        }
    }

    #[test]
    fn a_pair_of_roots_is_never_proven_away() {
        for n in 0..50 {
            let (at, half) = (0.02 * f64::from(n) + 0.005, 0.5_f64.powi(2 + n % 12));
            let (isolated, _) = found(2.0, |tau| (tau - at).powi(2) - half.powi(2));
            assert_ne!(isolated, Isolated::Free, "a pair of roots at {at} ± {half}");
        }
    }

    #[test]
    fn what_is_not_a_number_proves_nothing() {
        let isolated = isolate((1.0, 1.0), 100.0, 0.0, |_| f64::NAN);
        assert_eq!(isolated, Isolated::Open { low: None });
        let isolated = isolate((1.0, 1.0), f64::NAN, 0.0, |_| 1.0);
        assert_ne!(isolated, Isolated::Free);
    }
}
