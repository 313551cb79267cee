//! Dense output of Dormand–Prince 8(5,3): a cubic at no cost, order 7 for three evaluations.

use super::moved;
use super::tableau::{A13, A14, A15, D0, D1, D2, D3, NODES};
use super::weighed;
use crate::dense::{Dense, DenseBounds};
use crate::part::Part;
use crate::state::State;
use crate::stepper::Field;

/// x(τ) = c0 + τ (c1 + σ (c2 + τ (c3 + σ (c4 + …)))), σ = 1 − τ.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Dense8<S> {
    terms: [S; 8],
    /// 4 for the cubic Hermite, 8 once refined.
    used: usize,
    end: S,
}

impl<S: State> Dense8<S> {
    #[inline]
    pub(super) fn hermite(x0: &S, x1: &S, slopes: [&S; 2], h: f64) -> Self {
        let rise = x1.plus(-1.0, x0);
        let bend = slopes[0].times(h).plus(-1.0, &rise);
        let twist = rise.plus(-h, slopes[1]).plus(-1.0, &bend);
        let mut terms = [S::ZERO; 8];
        (terms[0], terms[1], terms[2], terms[3]) = (*x0, rise, bend, twist);
        Self { terms, used: 4, end: *x1 }
    }

    pub(super) fn refine(&mut self, field: &mut impl Field<S>, stages: &[S; 13], h: f64) {
        let x0 = self.terms[0];
        let mut k = [S::ZERO; 16];
        k[..13].copy_from_slice(stages);
        k[13] = field.derivative(NODES[13], &moved(&x0, h, &k, &A13));
        k[14] = field.derivative(NODES[14], &moved(&x0, h, &k, &A14));
        k[15] = field.derivative(NODES[15], &moved(&x0, h, &k, &A15));
        self.terms[4] = weighed(&k, &D0).times(h);
        self.terms[5] = weighed(&k, &D1).times(h);
        self.terms[6] = weighed(&k, &D2).times(h);
        self.terms[7] = weighed(&k, &D3).times(h);
        self.used = 8;
    }
}

impl<S: State> Dense<S> for Dense8<S> {
    fn still(x: &S) -> Self {
        let mut terms = [S::ZERO; 8];
        terms[0] = *x;
        Self { terms, used: 8, end: *x }
    }

    fn merged(&self, other: &Self, part: &Part) -> Self {
        let mut merged = *self;
        for (term, new) in merged.terms.iter_mut().zip(&other.terms) {
            *term = term.with_entries(new, part);
        }
        merged.used = other.used;
        merged.end = self.end.with_entries(&other.end, part);
        merged
    }

    fn at(&self, tau: f64) -> S {
        if tau >= 1.0 {
            return self.end;
        }
        let factors = [tau, 1.0 - tau];
        let mut sum = S::ZERO;
        for index in (1..self.used.min(8)).rev() {
            sum = self.terms[index].plus(1.0, &sum).times(factors[(index + 1) % 2]);
        }
        self.terms[0].plus(1.0, &sum)
    }

    fn end(&self) -> &S {
        &self.end
    }

    /// Sums the coefficients' magnitudes, each times the maximum of its product of τ and σ and of
    /// the derivatives of that product; only after refinement.
    fn bounds(&self) -> Option<DenseBounds<S>> {
        /// Maxima of τ, τσ, τ²σ, τ²σ², τ³σ², τ³σ³, τ⁴σ³ and of two derivatives of each, rounded up.
        const MOST: [[f64; 3]; 7] = [
            [1.0, 1.0, 0.0],
            [0.25, 1.0, 2.0],
            [0.1482, 1.0, 4.0],
            [0.0625, 0.1925, 2.0],
            [0.0346, 0.1356, 2.0],
            [0.0157, 0.0537, 0.3751],
            [0.0084, 0.0336, 0.2427],
        ];
        if self.used < 8 {
            return None;
        }
        let zero = DenseBounds { moves: S::ZERO, speeds: S::ZERO, bends: S::ZERO };
        Some(self.terms[1..].iter().zip(MOST).fold(zero, |sum, (term, [move_, speed, bend])| {
            let size = term.magnitudes();
            DenseBounds {
                moves: sum.moves.plus(move_, &size),
                speeds: sum.speeds.plus(speed, &size),
                bends: sum.bends.plus(bend, &size),
            }
        }))
    }
}
