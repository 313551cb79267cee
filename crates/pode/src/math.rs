//! The only access to elementary functions: std, or libm with `--no-default-features`, which gives
//! the same bits on every machine. Angles are in rad.

use core::ops::{Add, Mul, Sub};

use wide::f64x2;

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
    sqrt(x) = sqrt;
    cbrt(x) = cbrt;
    sin(x) = sin;
    cos(x) = cos;
    tan(x) = tan;
    tanh(x) = tanh;
    asin(x) = asin;
    acos(x) = acos;
    atan2(y, x) = atan2;
    hypot(x, y) = hypot;
    exp(x) = exp;
    ln(x) = log;
    powf(x, p) = pow;
    floor(x) = floor;
    ceil(x) = ceil;
}

/// Returns sine and cosine of `x` (rad). Within ±π/4 both come from one pair of polynomials
/// (fdlibm's kernels, below 1 ulp): the same bits on every machine, in half the time.
#[inline]
pub fn sin_cos(x: f64) -> (f64, f64) {
    if is_small(x) {
        let z = x * x;
        (small_sine(x, z), small_cosine(z))
    } else {
        large(x)
    }
}

/// [`sin_cos`] beyond ±π/4; out of line, so that the caller's numbers stay in registers.
#[cold]
#[inline(never)]
fn large(x: f64) -> (f64, f64) {
    (sin(x), cos(x))
}

#[cold]
#[inline(never)]
fn large_of_two(x: [f64; 2]) -> ([f64; 2], [f64; 2]) {
    let [first, second] = x.map(sin_cos);
    ([first.0, second.0], [first.1, second.1])
}

/// Returns sines and cosines of two adjacent angles (rad), with [`sin_cos`]'s bits and time.
#[expect(clippy::inline_always, reason = "a call takes angles and results through memory")]
#[inline(always)]
pub fn sin_cos_of_two(x: [f64; 2]) -> ([f64; 2], [f64; 2]) {
    if x.iter().all(|x| is_small(*x)) {
        let x = f64x2::new(x);
        let z = x * x;
        (small_sine(x, z).to_array(), small_cosine(z).to_array())
    } else {
        large_of_two(x)
    }
}

/// Returns `true` if the polynomials hold; `false` for NaN.
#[inline]
fn is_small(x: f64) -> bool {
    x.abs() <= core::f64::consts::FRAC_PI_4
}

trait SimdLanes:
    Copy + From<f64> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self>
{
}

impl SimdLanes for f64 {}

impl SimdLanes for f64x2 {}

/// fdlibm `k_sin.c`.
const S: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];

/// fdlibm `k_cos.c`.
const C: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// Sine of `x`, |x| ≤ π/4, with `z` = x².
#[inline]
fn small_sine<T: SimdLanes>(x: T, z: T) -> T {
    let s = |i: usize| T::from(S[i]);
    // Two halves side by side: half the depth of Horner's rule, and the depth costs the time.
    let w = z * z;
    let tail = (s(1) + z * s(2)) + w * ((s(3) + z * s(4)) + w * s(5));
    x + z * x * (s(0) + z * tail)
}

/// Cosine for |x| ≤ π/4 with `z` = x².
#[inline]
fn small_cosine<T: SimdLanes>(z: T) -> T {
    let c = |i: usize| T::from(C[i]);
    let w = z * z;
    let tail = (c(0) + z * c(1)) + w * ((c(2) + z * c(3)) + w * (c(4) + z * c(5)));
    (T::from(1.0) - T::from(0.5) * z) + w * tail
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
    fn two_angles_at_once_are_the_same_bits() {
        for n in -1000..=1000_i32 {
            let [a, b] = [f64::from(n) * 7.9e-4, f64::from(n) * 1.1e-3 - 0.2];
            let (sines, cosines) = sin_cos_of_two([a, b]);
            for (i, x) in [a, b].into_iter().enumerate() {
                assert_eq!((sines[i], cosines[i]), sin_cos(x), "{a} and {b}");
            }
        }
        let (sines, cosines) = sin_cos_of_two([f64::NAN, 2.0]);
        assert!(sines[0].is_nan() && cosines[0].is_nan());
        assert_eq!((sines[1], cosines[1]), sin_cos(2.0));
    }
}
