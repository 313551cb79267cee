//! A polynomial per entry, of any degree up to `N − 1`.

use crate::dense::{Dense, DenseBounds};
use crate::part::Part;
use crate::state::State;

/// x(τ) = c0 + τ (c1 + τ (c2 + …)) for τ in 0 ..= 1 of a step, with at most `N` terms.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Polynomial<S, const N: usize> {
    terms: [S; N],
    used: usize,
    end: S,
}

/// Polynomials up to this length are summed up whole: a branch takes longer than a term.
const SHORT: usize = 5;

impl<S: State, const N: usize> Polynomial<S, N> {
    /// Builds the polynomial with coefficients `terms` by power of τ; `end` is its value at 1.
    #[inline]
    pub const fn new(terms: [S; N], end: S) -> Self {
        Self { terms, used: N, end }
    }

    pub(crate) fn lengthened<const M: usize>(&self) -> Polynomial<S, M> {
        let mut terms = [S::ZERO; M];
        for (term, known) in terms.iter_mut().zip(&self.terms) {
            *term = *known;
        }
        Polynomial { terms, used: self.used.min(N), end: self.end }
    }

    /// Returns the polynomial with zero for all but the first `used` terms.
    #[inline]
    #[must_use]
    pub fn truncated(self, used: usize) -> Self {
        Self { used: used.clamp(1, N), ..self }
    }
}

impl<S: State, const N: usize> Dense<S> for Polynomial<S, N> {
    #[inline]
    fn still(x: &S) -> Self {
        let mut terms = [S::ZERO; N];
        if let Some(first) = terms.first_mut() {
            *first = *x;
        }
        Self { terms, used: 1, end: *x }
    }

    #[inline]
    fn merged(&self, other: &Self, part: &Part) -> Self {
        let mut merged = *self;
        for (term, new) in merged.terms.iter_mut().zip(&other.terms) {
            *term = term.with_entries(new, part);
        }
        merged.used = self.used.max(other.used);
        merged.end = self.end.with_entries(&other.end, part);
        merged
    }

    /// Taylor's shift: all powers of `from + width τ` by repeated Horner.
    fn within(&self, from: f64, to: f64) -> Option<Self> {
        let (used, width) = (self.used.clamp(1, N), to - from);
        let mut terms = self.terms;
        for lowest in 0..used {
            for power in (lowest..used - 1).rev() {
                terms[power] = terms[power].plus(from, &terms[power + 1]);
            }
        }
        let mut scale = 1.0;
        for term in terms.iter_mut().take(used) {
            *term = term.times(scale);
            scale *= width;
        }
        Some(Self { terms, used: self.used, end: self.at(to) })
    }

    #[inline]
    fn at(&self, tau: f64) -> S {
        if tau >= 1.0 {
            return self.end;
        }
        let used = if N <= SHORT { N } else { self.used.min(N) };
        let (mut lower, mut sum) = (used, S::ZERO);
        while lower > 0 {
            lower -= 1;
            sum = self.terms[lower].plus(tau, &sum);
        }
        sum
    }

    #[inline]
    fn end(&self) -> &S {
        &self.end
    }

    #[inline]
    fn bounds(&self) -> Option<DenseBounds<S>> {
        let used = if N <= SHORT { N } else { self.used.min(N) };
        let (mut moves, mut speeds, mut bends) = (S::ZERO, S::ZERO, S::ZERO);
        for power in 1..used {
            let (size, n) = (self.terms[power].magnitudes(), power as f64);
            moves = moves.plus(1.0, &size);
            speeds = speeds.plus(n, &size);
            bends = bends.plus(n * (n - 1.0), &size);
        }
        Some(DenseBounds { moves, speeds, bends })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_of_a_polynomial_is_the_same_polynomial() {
        let whole = Polynomial::new([[1.0], [-2.0], [0.5], [3.0]], [2.5]);
        let part = whole.within(0.25, 0.75).expect("a polynomial");
        for n in 0..=8 {
            let tau = f64::from(n) / 8.0;
            let (found, expected) = (part.at(tau)[0], whole.at(0.25 + 0.5 * tau)[0]);
            assert!((found - expected).abs() < 1e-15, "{tau}: {found} is not {expected}");
        }
    }
}
