//! Strokes as functions of time, exact with their derivatives.

use pode::Motion;

/// An input that is a sum of terms with size, time and width.
pub(super) trait TermInput: Copy {
    /// Returns the input of these (A, tc (s), w (s)), if their number is right.
    fn of(terms: &[[f64; 3]]) -> Option<Self>;

    /// Returns the input at `t` (s).
    fn at(&self, t: f64) -> Motion;
}

/// Returns A, tc (s) and 1/w (1/s) of each term.
fn inverted<const N: usize>(terms: &[[f64; 3]]) -> Option<[[f64; 3]; N]> {
    let terms: &[[f64; 3]; N] = terms.try_into().ok()?;
    Some(terms.map(|[a, tc, w]| [a, tc, 1.0 / w]))
}

/// s(t) = Σ A exp(−((t − tc)/w)²).
#[derive(Clone, Copy, Debug)]
pub(super) struct Bells<const N: usize>([[f64; 3]; N]);

impl<const N: usize> TermInput for Bells<N> {
    fn of(terms: &[[f64; 3]]) -> Option<Self> {
        inverted(terms).map(Self)
    }

    #[inline]
    fn at(&self, t: f64) -> Motion {
        let mut motion = Motion::default();
        for [a, tc, per_w] in self.0 {
            let z = (t - tc) * per_w;
            let bell = a * (-z * z).exp();
            motion.position += bell;
            motion.rate -= bell * 2.0 * z * per_w;
            motion.acceleration += bell * (4.0 * z * z - 2.0) * per_w * per_w;
            motion.jerk += bell * (12.0 * z - 8.0 * z * z * z) * per_w * per_w * per_w;
        }
        motion
    }
}

/// s(t) = Σ A (1 + tanh((t − tc)/w))/2.
#[derive(Clone, Copy, Debug)]
pub(super) struct Presses<const N: usize>([[f64; 3]; N]);

impl Presses<1> {
    /// Returns a press by `size`, fastest at `tc` (s), of the width `w` (s).
    pub(super) fn one(size: f64, [tc, w]: [f64; 2]) -> Self {
        Self([[size, tc, 1.0 / w]])
    }
}

impl<const N: usize> TermInput for Presses<N> {
    fn of(terms: &[[f64; 3]]) -> Option<Self> {
        inverted(terms).map(Self)
    }

    #[inline]
    fn at(&self, t: f64) -> Motion {
        let mut motion = Motion::default();
        for [a, tc, per_w] in self.0 {
            let tanh = ((t - tc) * per_w).tanh();
            let slope = 1.0 - tanh * tanh;
            motion.position += 0.5 * a * (1.0 + tanh);
            motion.rate += 0.5 * a * slope * per_w;
            motion.acceleration -= a * tanh * slope * per_w * per_w;
            motion.jerk += a * slope * (3.0 * tanh * tanh - 1.0) * per_w * per_w * per_w;
        }
        motion
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TERMS: [[f64; 3]; 2] = [[0.8, 0.4, 0.1], [-0.5, 0.7, 0.2]];

    #[track_caller]
    fn check(input: impl TermInput) {
        for t in [0.1, 0.35, 0.5, 0.78] {
            let h = 1e-6;
            let (before, now, after) = (input.at(t - h), input.at(t), input.at(t + h));
            let slope = |of: fn(&Motion) -> f64| (of(&after) - of(&before)) / (2.0 * h);
            let pairs = [
                (slope(|it| it.position), now.rate),
                (slope(|it| it.rate), now.acceleration),
                (slope(|it| it.acceleration), now.jerk),
            ];
            for (found, stated) in pairs {
                assert!((found - stated).abs() < 1e-6 * stated.abs().max(1.0), "{found}, {stated}");
            }
        }
    }

    #[test]
    fn an_input_has_its_stated_rates() {
        check(Bells::<2>::of(&TERMS).unwrap());
        check(Presses::<2>::of(&TERMS).unwrap());
    }

    #[test]
    fn inputs_are_the_sums_that_the_references_name() {
        let bells = Bells::<2>::of(&TERMS).unwrap().at(0.4).position;
        assert!((bells - (0.8 - 0.5 * (-2.25_f64).exp())).abs() < 1e-15, "{bells}");
        let presses = Presses::<2>::of(&TERMS).unwrap().at(0.7).position;
        let expected = 0.4 * (1.0 + 3.0_f64.tanh()) - 0.25;
        assert!((presses - expected).abs() < 1e-15, "{presses}");
        assert!(Bells::<3>::of(&TERMS).is_none());
    }
}
