//! Functions beyond the elementary ones: the same bits in native code and when interpreted.

use crate::equations::softplus::Softplus;

#[inline]
pub fn sign(x: f64) -> f64 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        x
    }
}

/// Returns the smaller of two numbers; the first if one of them is NaN.
///
/// One instruction, with one result on every machine: `f64::min` leaves the sign of zero open.
#[inline]
pub fn smaller(x: f64, y: f64) -> f64 {
    if y < x { y } else { x }
}

/// Returns the larger of two numbers; the first if one of them is NaN.
#[inline]
pub fn larger(x: f64, y: f64) -> f64 {
    if y > x { y } else { x }
}

/// Returns ln(1 + eˣ), without overflow.
#[inline]
pub fn softplus(x: f64) -> f64 {
    Softplus::at(x).value
}

/// Returns 1/(1 + e⁻ˣ), the slope of [`softplus`].
#[inline]
pub fn logistic(x: f64) -> f64 {
    Softplus::at(x).slope
}

/// Returns ∫ softplus from −∞ to `x`.
#[inline]
pub fn softplus_area(x: f64) -> f64 {
    Softplus::at(x).area()
}

/// Returns ∫ softplus² from −∞ to `x`.
#[inline]
pub fn softplus_square_area(x: f64) -> f64 {
    Softplus::at(x).area_of_square()
}
