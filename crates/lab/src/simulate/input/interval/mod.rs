//! Ranges of numbers, and what arithmetic makes of them. `[MKC09]`
//!
//! A result contains whatever the same arithmetic on `f64` gives for any numbers of the operands,
//! and what exact arithmetic gives: each bound is moved outwards by what rounding can have moved
//! it inwards. A result that is undefined for some number of an operand is undefined, and so is
//! all that is made of it.

mod functions;
mod operators;

use std::convert::Infallible;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::str::FromStr;

pub(super) use operators::IntervalOperators;

/// All numbers from `lo` to `hi`; undefined if these are not numbers.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(super) struct Interval {
    lo: f64,
    hi: f64,
}

impl Interval {
    /// What is not defined everywhere.
    const UNDEFINED: Self = Self { lo: f64::NAN, hi: f64::NAN };

    /// The numbers from `lo` to `hi`.
    pub(super) fn new(lo: f64, hi: f64) -> Self {
        if lo <= hi { Self { lo, hi } } else { Self::UNDEFINED }
    }

    /// The one number `value`.
    const fn point(value: f64) -> Self {
        Self { lo: value, hi: value }
    }

    /// The number that it is, if it is one.
    fn as_point(self) -> Option<f64> {
        (self.lo >= self.hi).then_some(self.lo)
    }

    const fn is_undefined(self) -> bool {
        self.lo.is_nan() || self.hi.is_nan()
    }

    const fn contains(self, value: f64) -> bool {
        self.lo <= value && value <= self.hi
    }

    /// The largest magnitude in it; infinite or not a number where there is none.
    pub(super) fn magnitude(self) -> f64 {
        if self.is_undefined() { f64::NAN } else { self.lo.abs().max(self.hi.abs()) }
    }

    /// The range of `values`, each with the error that rounding left in it.
    fn around(values: [Rounded; 4]) -> Self {
        if values.iter().any(|it| it.value.is_nan()) {
            return Self::UNDEFINED;
        }
        let lo = values.iter().map(|it| it.down()).fold(f64::INFINITY, f64::min);
        let hi = values.iter().map(|it| it.up()).fold(f64::NEG_INFINITY, f64::max);
        Self::new(lo, hi)
    }
}

/// A rounded number, and whether it is exact.
#[derive(Clone, Copy)]
struct Rounded {
    value: f64,
    is_exact: bool,
}

impl Rounded {
    /// a + b; what rounding took off is a number again, and found by taking the sum apart.
    fn sum(a: f64, b: f64) -> Self {
        let value = a + b;
        let part = value - a;
        let error = (a - (value - part)) + (b - part);
        Self { value, is_exact: error == 0.0 }
    }

    fn product(a: f64, b: f64) -> Self {
        let value = a * b;
        let is_exact = a == 0.0 || b == 0.0 || (value != 0.0 && a.mul_add(b, -value) == 0.0);
        Self { value, is_exact }
    }

    fn quotient(a: f64, b: f64) -> Self {
        let value = a / b;
        let is_exact = a == 0.0 || (value != 0.0 && value.mul_add(b, -a) == 0.0);
        Self { value, is_exact }
    }

    fn down(self) -> f64 {
        if self.is_exact { self.value } else { self.value.next_down() }
    }

    fn up(self) -> f64 {
        if self.is_exact { self.value } else { self.value.next_up() }
    }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (lo, hi) = (Rounded::sum(self.lo, other.lo), Rounded::sum(self.hi, other.hi));
        Self::around([lo, lo, hi, hi])
    }
}

impl Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }
}

impl Sub for Interval {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

/// `[MKC09]` eq. 2.23 and 2.24: the range is that of the corners.
fn corners(a: Interval, b: Interval, operate: fn(f64, f64) -> Rounded) -> Interval {
    Interval::around([
        operate(a.lo, b.lo),
        operate(a.lo, b.hi),
        operate(a.hi, b.lo),
        operate(a.hi, b.hi),
    ])
}

impl Mul for Interval {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        corners(self, other, Rounded::product)
    }
}

impl Div for Interval {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        if other.contains(0.0) {
            return Self::UNDEFINED;
        }
        corners(self, other, Rounded::quotient)
    }
}

impl From<u8> for Interval {
    fn from(value: u8) -> Self {
        Self::point(value.into())
    }
}

impl From<f32> for Interval {
    fn from(value: f32) -> Self {
        Self::point(value.into())
    }
}

impl FromStr for Interval {
    type Err = Infallible;

    /// The number that `f64` makes of the text, since this is the one that is calculated with.
    fn from_str(text: &str) -> Result<Self, Infallible> {
        Ok(text.parse().map_or(Self::UNDEFINED, Self::point))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_stay_exact() {
        let [two, three] = [2, 3].map(Interval::from);
        assert_eq!(two + three, Interval::point(5.0));
        assert_eq!(two - three, Interval::point(-1.0));
        assert_eq!(two * three, Interval::point(6.0));
        assert_eq!(three / two, Interval::point(1.5));
    }

    #[test]
    fn a_third_lies_between_two_neighbours() {
        let third = Interval::from(1) / Interval::from(3);
        assert!(third.lo < third.hi && third.contains(1.0 / 3.0));
        assert!((third * Interval::from(3)).contains(1.0));
        let tenth = Interval::point(0.1) + Interval::point(0.2);
        assert!(tenth.contains(0.3) && tenth.contains(0.1 + 0.2), "{tenth:?}");
    }

    #[test]
    fn signs_are_those_of_the_corners() {
        let (a, b) = (Interval::new(-2.0, 3.0), Interval::new(-5.0, 4.0));
        assert_eq!(a * b, Interval::new(-15.0, 12.0));
        assert_eq!(a - b, Interval::new(-6.0, 8.0));
        assert_eq!(-a, Interval::new(-3.0, 2.0));
    }

    #[test]
    fn what_is_undefined_stays_so() {
        let pole = Interval::from(1) / Interval::new(-1.0, 1.0);
        for it in [pole, pole * Interval::from(0), pole + Interval::from(1), -pole] {
            assert!(it.is_undefined() && it.magnitude().is_nan(), "{it:?}");
        }
    }
}
