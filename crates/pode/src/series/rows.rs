//! The next coefficient of a product, a quotient, a root: what each takes of those before it.
//!
//! Sums of products over a row and another one backwards are what a series costs. Rows that are
//! read backwards are therefore kept backwards ([`Falling`]), and sums go four terms at a time,
//! padded with zeros.
//!
//! # References
//! `[JZ05]` proposition 2.1: the rules.

use super::INPUT_TERMS;

/// Length of a row: a multiple of four.
const ROW: usize = INPUT_TERMS.next_multiple_of(4);

/// 1/k, for k from 1 on; a division takes four times as long as a product.
pub const PER_ORDER: [f64; ROW] = {
    let mut list = [0.0; ROW];
    let mut k = 1;
    while k < ROW {
        list[k] = 1.0 / k as f64;
        k += 1;
    }
    list
};

/// Coefficients from the first on.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Rising([f64; ROW]);

/// Coefficients from the last one down to the first, and zeros behind it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Falling([f64; ROW + 4]);

impl Rising {
    /// The row of no coefficients.
    pub const ZERO: Self = Self([0.0; ROW]);

    /// Enters the coefficient of order `k`.
    #[inline]
    pub fn set(&mut self, k: usize, value: f64) {
        if let Some(place) = self.0.get_mut(k) {
            *place = value;
        }
    }

    /// The coefficient of order `k`.
    #[inline]
    pub fn at(&self, k: usize) -> f64 {
        self.0.get(k).copied().unwrap_or(0.0)
    }
}

impl Falling {
    /// The row of no coefficients.
    pub const ZERO: Self = Self([0.0; ROW + 4]);

    /// Enters the coefficient of order `k`.
    #[inline]
    pub fn set(&mut self, k: usize, value: f64) {
        if let Some(place) = self.0.get_mut((ROW - 1).wrapping_sub(k)) {
            *place = value;
        }
    }
}

/// Σ a b over as many terms, four at a time; what is beyond them is zero in `b`.
#[expect(clippy::inline_always, reason = "a few products, asked for thousands of times")]
#[inline(always)]
fn dot(a: &[f64], b: &[f64], terms: usize) -> f64 {
    let mut sums = [0.0; 4];
    let padded = (terms + 3) & !3;
    let (a, b) = (a.get(..padded).unwrap_or(&[]), b.get(..padded).unwrap_or(&[]));
    for (a, b) in a.chunks_exact(4).zip(b.chunks_exact(4)) {
        for (sum, (a, b)) in sums.iter_mut().zip(a.iter().zip(b)) {
            *sum += a * b;
        }
    }
    (sums[0] + sums[2]) + (sums[1] + sums[3])
}

/// Σ a(j) b(k − j) for j from `from` to k: `b` down from k − from.
#[expect(clippy::inline_always, reason = "as above")]
#[inline(always)]
fn sum_from(from: usize, a: &Rising, b: &Falling, k: usize) -> f64 {
    let start = (ROW - 1 + from).wrapping_sub(k);
    let (a, b) = (a.0.get(from..).unwrap_or(&[]), b.0.get(start..).unwrap_or(&[]));
    dot(a, b, k + 1 - from)
}

/// Coefficient `k` of a b.
#[inline]
pub fn product(a: &Rising, b: &Falling, k: usize) -> f64 {
    sum_from(0, a, b, k)
}

/// Coefficient `k` of a², with the same coefficients both ways.
#[inline]
pub fn square(rising: &Rising, falling: &Falling, k: usize) -> f64 {
    let half = k.div_ceil(2);
    let middle = if k.is_multiple_of(2) { rising.at(k / 2) } else { 0.0 };
    2.0 * pairs(rising, falling, (0, half), k) + middle * middle
}

/// Σ a(j) a(k − j) for j in a range of the first half; no padding, since `falling` goes on.
#[inline]
fn pairs(rising: &Rising, falling: &Falling, (from, to): (usize, usize), k: usize) -> f64 {
    let start = (ROW - 1 + from).wrapping_sub(k);
    let a = rising.0.get(from..to).unwrap_or(&[]);
    let b = falling.0.get(start..).unwrap_or(&[]);
    a.iter().zip(b).fold(0.0, |sum, (a, b)| sum + a * b)
}

/// Coefficient `k` ≥ 1 of the quotient q = n / d, where `n` is that of the numerator, `q` the
/// quotient's coefficients before it and `per_first` 1/d(0).
#[inline]
pub fn quotient(n: f64, d: &Rising, q: &Falling, per_first: f64, k: usize) -> f64 {
    (n - sum_from(1, d, q, k)) * per_first
}

/// Coefficient `k` ≥ 1 of what changes with `slope` times the rate of x: `rate` has k x(k).
///
/// The sine's slope is the cosine, that of an exponential itself.
#[inline]
pub fn driven(rate: &Rising, slope: &Falling, k: usize) -> f64 {
    sum_from(1, rate, slope, k) * PER_ORDER[k]
}

/// Coefficient `k` ≥ 1 of the root r = √x, where `x` is that of the square and `per_twice_first`
/// 1/(2 r(0)).
#[inline]
pub fn root(x: f64, r: &Rising, falling: &Falling, per_twice_first: f64, k: usize) -> f64 {
    let half = k.div_ceil(2);
    let middle = if k.is_multiple_of(2) { r.at(k / 2) } else { 0.0 };
    (x - 2.0 * pairs(r, falling, (1, half), k) - middle * middle) * per_twice_first
}

/// Coefficient `k` ≥ 1 of the power p = xᶜ, where `rate` has k x(k) and `per_first` is 1/x(0).
#[inline]
pub fn power(
    exponent: f64,
    (x, rate): (&Rising, &Rising),
    p: &Falling,
    per_first: f64,
    k: usize,
) -> f64 {
    let by_rate = sum_from(1, rate, p, k) * PER_ORDER[k];
    ((exponent + 1.0) * by_rate - sum_from(1, x, p, k)) * per_first
}
