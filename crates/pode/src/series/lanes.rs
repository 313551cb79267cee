//! Many sums of products at once: one lane for each.

use super::TERMS;

/// Rows of factors, with a lane for each product, quotient or sine of a series.
///
/// The next order of all lanes is one pass over the orders before it, which processors with vector
/// registers do several lanes at a time, whatever the products are.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Lanes<const L: usize> {
    first: [[f64; L]; TERMS],
    second: [[f64; L]; TERMS],
}

impl<const L: usize> Lanes<L> {
    /// Lanes without coefficients.
    pub const ZERO: Self = Self { first: [[0.0; L]; TERMS], second: [[0.0; L]; TERMS] };

    /// Enters the coefficients of order `k` of all first and of all second factors.
    #[inline]
    pub fn enter(&mut self, k: usize, first: [f64; L], second: [f64; L]) {
        if let (Some(a), Some(b)) = (self.first.get_mut(k), self.second.get_mut(k)) {
            (*a, *b) = (first, second);
        }
    }

    /// Σ a(j) b(k − j) for j from 1 to k − 1, in every lane.
    #[expect(clippy::inline_always, reason = "a few products, asked for thousands of times")]
    #[inline(always)]
    pub fn inner(&self, k: usize) -> [f64; L] {
        let mut sums = [0.0; L];
        let (Some(first), Some(second)) = (self.first.get(1..k), self.second.get(1..k)) else {
            return sums;
        };
        for (a, b) in first.iter().zip(second.iter().rev()) {
            for (sum, (a, b)) in sums.iter_mut().zip(a.iter().zip(b)) {
                *sum += a * b;
            }
        }
        sums
    }
}
