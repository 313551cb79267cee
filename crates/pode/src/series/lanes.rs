//! Many sums of products at once, one per lane.

use wide::f64x2;

use super::TERMS;

/// The coefficients of two lanes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SeriesPair(f64x2);

impl SeriesPair {
    #[expect(clippy::inline_always, reason = "one instruction")]
    #[inline(always)]
    pub fn new(one: f64, other: f64) -> Self {
        Self(f64x2::new([one, other]))
    }

    #[expect(clippy::inline_always, reason = "one instruction")]
    #[inline(always)]
    pub fn both(self) -> [f64; 2] {
        self.0.to_array()
    }
}

/// Rows of factors, with a lane for each product, quotient or sine of a series: two to a pair.
///
/// The next order of all lanes is one pass over the orders before it, two lanes at a time. Rows are
/// written as they are read: a processor cannot forward two numbers that were written one by one
/// before both are in its cache.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SeriesLanes<const PAIRS: usize> {
    first: [[SeriesPair; PAIRS]; TERMS],
    second: [[SeriesPair; PAIRS]; TERMS],
}

impl<const PAIRS: usize> SeriesLanes<PAIRS> {
    pub const ZERO: Self = Self {
        first: [[SeriesPair(f64x2::ZERO); PAIRS]; TERMS],
        second: [[SeriesPair(f64x2::ZERO); PAIRS]; TERMS],
    };

    /// Sets the coefficients of order `k` of all first and of all second factors.
    #[expect(clippy::inline_always, reason = "what is entered stays in registers")]
    #[inline(always)]
    pub fn enter(&mut self, k: usize, first: [SeriesPair; PAIRS], second: [SeriesPair; PAIRS]) {
        if let (Some(a), Some(b)) = (self.first.get_mut(k), self.second.get_mut(k)) {
            (*a, *b) = (first, second);
        }
    }

    /// Returns Σ a(j) b(k − j) for j from 1 to k − 1, in every lane.
    #[expect(clippy::inline_always, reason = "a few products, asked for thousands of times")]
    #[inline(always)]
    pub fn inner(&self, k: usize) -> [SeriesPair; PAIRS] {
        let mut sums = [SeriesPair(f64x2::ZERO); PAIRS];
        let (Some(first), Some(second)) = (self.first.get(1..k), self.second.get(1..k)) else {
            return sums;
        };
        for (a, b) in first.iter().zip(second.iter().rev()) {
            for (sum, (a, b)) in sums.iter_mut().zip(a.iter().zip(b)) {
                sum.0 += a.0 * b.0;
            }
        }
        sums
    }
}
