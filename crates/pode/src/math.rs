//! The only door to elementary functions: from std, or from libm without it.
//!
//! `--no-default-features` gives the same bits on every machine.

macro_rules! door {
    ($($(#[$doc:meta])* $name:ident($($arg:ident),+) = $libm:ident;)+) => {$(
        $(#[$doc])*
        #[inline]
        pub fn $name($($arg: f64),+) -> f64 {
            #[cfg(any(test, feature = "std"))]
            { door!(@std $name, $($arg),+) }
            #[cfg(not(any(test, feature = "std")))]
            { libm::$libm($($arg),+) }
        }
    )+};
    (@std $name:ident, $first:ident $(, $rest:ident)*) => { $first.$name($($rest),*) };
}

door! {
    /// Square root.
    sqrt(x) = sqrt;
    /// Cube root.
    cbrt(x) = cbrt;
    /// Sine of `x` [rad].
    sin(x) = sin;
    /// Cosine of `x` [rad].
    cos(x) = cos;
    /// Tangent of `x` [rad].
    tan(x) = tan;
    /// Hyperbolic tangent.
    tanh(x) = tanh;
    /// Angle of the point (`x`, `y`) [rad].
    atan2(y, x) = atan2;
    /// Length of (`x`, `y`).
    hypot(x, y) = hypot;
    /// e to the power `x`.
    exp(x) = exp;
    /// Natural logarithm.
    ln(x) = log;
    /// `x` to the power `p`.
    powf(x, p) = pow;
    /// Largest integer not above `x`.
    floor(x) = floor;
    /// Smallest integer not below `x`.
    ceil(x) = ceil;
}

/// Sine and cosine of `x` [rad].
#[inline]
pub fn sin_cos(x: f64) -> (f64, f64) {
    (sin(x), cos(x))
}
