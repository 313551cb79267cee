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
///
/// Within ±π/4, where levers and hammers live, both come from one pair of polynomials
/// (fdlibm's kernels, below 1 ulp): the same bits on every machine, in half the time.
#[inline]
pub fn sin_cos(x: f64) -> (f64, f64) {
    if x.abs() <= core::f64::consts::FRAC_PI_4 {
        let z = x * x;
        (small_sine(x, z), small_cosine(z))
    } else {
        (sin(x), cos(x))
    }
}

/// Sine of `x`, |x| ≤ π/4, with `z` = x². fdlibm `k_sin.c`.
#[inline]
fn small_sine(x: f64, z: f64) -> f64 {
    const S: [f64; 6] = [
        -1.666_666_666_666_663_2e-1,
        8.333_333_333_322_49e-3,
        -1.984_126_982_985_795e-4,
        2.755_731_370_707_006_8e-6,
        -2.505_076_025_340_686_3e-8,
        1.589_690_995_211_55e-10,
    ];
    // Two halves side by side: half the depth of Horner's rule, and the depth is the time.
    let w = z * z;
    let tail = (S[1] + z * S[2]) + w * ((S[3] + z * S[4]) + w * S[5]);
    x + z * x * (S[0] + z * tail)
}

/// Cosine for |x| ≤ π/4 with `z` = x². fdlibm `k_cos.c`.
#[inline]
fn small_cosine(z: f64) -> f64 {
    const C: [f64; 6] = [
        4.166_666_666_666_66e-2,
        -1.388_888_888_887_411e-3,
        2.480_158_728_947_673e-5,
        -2.755_731_435_139_066_3e-7,
        2.087_572_321_298_175e-9,
        -1.135_964_755_778_819_5e-11,
    ];
    let w = z * z;
    let tail = (C[0] + z * C[1]) + w * ((C[2] + z * C[3]) + w * (C[4] + z * C[5]));
    (1.0 - 0.5 * z) + w * tail
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_angles_agree_with_std_to_an_ulp() {
        for n in -100_000..=100_000_i32 {
            let x = f64::from(n) * 7.9e-6;
            let (s, c) = sin_cos(x);
            let ulp = |value: f64| (value.abs() * f64::EPSILON).max(f64::MIN_POSITIVE);
            assert!((s - x.sin()).abs() <= ulp(s), "sin {x}: {s:e}");
            assert!((c - x.cos()).abs() <= ulp(c), "cos {x}: {c:e}");
        }
    }

    #[test]
    fn large_angles_and_nan_are_std_s() {
        assert_eq!(sin_cos(2.0), (2.0_f64.sin(), 2.0_f64.cos()));
        assert!(sin_cos(f64::NAN).0.is_nan());
    }
}
