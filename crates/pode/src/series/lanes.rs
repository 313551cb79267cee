//! Many sums of products at once: one lane for each.

use wide::f64x2;

use super::TERMS;

/// The coefficients of two lanes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LanePair(f64x2);

impl LanePair {
    /// The coefficients of the first lane and of the second.
    #[expect(clippy::inline_always, reason = "one instruction")]
    #[inline(always)]
    pub fn new(one: f64, other: f64) -> Self {
        Self(f64x2::new([one, other]))
    }

    /// Returns the coefficients of both lanes, in order.
    #[expect(clippy::inline_always, reason = "one instruction")]
    #[inline(always)]
    pub fn both(self) -> [f64; 2] {
        self.0.to_array()
    }
}

/// Rows of factors, with a lane for each product, quotient or sine of a series: two to a pair.
///
/// The next order of all lanes is one pass over the orders before it, two lanes at a time,
/// whatever the products are. Rows are written as they are read, since a processor cannot hand on
/// two numbers that were written one by one before both are in its cache.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ProductLanes<const PAIRS: usize> {
    first: [[LanePair; PAIRS]; TERMS],
    second: [[LanePair; PAIRS]; TERMS],
}

impl<const PAIRS: usize> ProductLanes<PAIRS> {
    /// ProductLanes without coefficients.
    pub const ZERO: Self = Self {
        first: [[LanePair(f64x2::ZERO); PAIRS]; TERMS],
        second: [[LanePair(f64x2::ZERO); PAIRS]; TERMS],
    };

    /// Enters the coefficients of order `k` of all first and of all second factors.
    #[expect(clippy::inline_always, reason = "what is entered stays in registers")]
    #[inline(always)]
    pub fn enter(&mut self, k: usize, first: [LanePair; PAIRS], second: [LanePair; PAIRS]) {
        if let (Some(a), Some(b)) = (self.first.get_mut(k), self.second.get_mut(k)) {
            (*a, *b) = (first, second);
        }
    }

    /// Σ a(j) b(k − j) for j from 1 to k − 1, in every lane.
    #[expect(clippy::inline_always, reason = "a few products, asked for thousands of times")]
    #[inline(always)]
    pub fn inner(&self, k: usize) -> [LanePair; PAIRS] {
        let mut sums = [LanePair(f64x2::ZERO); PAIRS];
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
