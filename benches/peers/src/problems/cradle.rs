//! Newton's cradle: five balls with gaps at rest, so that impacts of neighbours follow one
//! another and every law of impact agrees.

use pode::{EquationKind, Nature};

use crate::problem::Problem;

const BALLS: usize = 5;

/// State: displacements u of each ball from rest (m), then speeds (m/s).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cradle {
    /// Square of the pendulums' angular frequency (rad²/s²).
    pub(crate) square: f64,
    pub(crate) e: f64,
    /// Displacement of the first ball at the start (m).
    pub(crate) pulled: f64,
    /// Gaps between neighbours at rest (m).
    pub(crate) gaps: [f64; BALLS - 1],
}

impl Problem<10, 4> for Cradle {
    type Mode = ();

    fn names((): ()) -> [&'static str; 4] {
        ["pair0", "pair1", "pair2", "pair3"]
    }

    fn start(&self) -> ((), [f64; 10]) {
        let mut x = [0.0; 10];
        x[0] = -self.pulled;
        ((), x)
    }

    #[inline]
    fn derivative(&self, (): (), _t: f64, x: &[f64; 10]) -> [f64; 10] {
        let [a, b, c, d, e, speeds @ ..] = *x;
        let turn = |u: f64| -self.square * u;
        let [va, vb, vc, vd, ve] = speeds;
        [va, vb, vc, vd, ve, turn(a), turn(b), turn(c), turn(d), turn(e)]
    }

    #[inline]
    fn guards(&self, (): (), x: &[f64; 10]) -> [f64; 4] {
        std::array::from_fn(|i| self.gaps[i] + x[i + 1] - x[i])
    }

    #[inline]
    fn guard_rates(&self, (): (), x: &[f64; 10]) -> [f64; 4] {
        std::array::from_fn(|i| x[BALLS + i + 1] - x[BALLS + i])
    }

    #[inline]
    fn guard(&self, (): (), i: usize, x: &[f64; 10]) -> (f64, f64) {
        (self.gaps[i] + x[i + 1] - x[i], x[BALLS + i + 1] - x[BALLS + i])
    }

    #[inline]
    fn fire(&self, (): (), pair: usize, x: &[f64; 10]) -> ((), [f64; 10]) {
        let (mut after, left, right) = (*x, BALLS + pair, BALLS + pair + 1);
        let (mean, half) = (0.5 * (x[left] + x[right]), 0.5 * (x[right] - x[left]));
        after[pair] = x[pair + 1] + self.gaps[pair];
        (after[left], after[right]) = (mean + self.e * half, mean - self.e * half);
        ((), after)
    }

    fn longest_step(&self) -> f64 {
        f64::INFINITY
    }

    fn nature(&self) -> Nature {
        Nature::new(EquationKind::Affine, self.square.sqrt())
    }
}
