//! Rounded corners: softplus, its slope and its integrals, for felts and drop screws.

use pode::math::{exp, ln};

/// Argument beyond which a softplus is its asymptote to the last bit of 1.
pub const FAR_SOFTPLUS: f64 = 40.0;

/// sp(x) = ln(1 + eˣ) and its slope σ(x) = 1/(1 + e⁻ˣ).
#[derive(Clone, Copy, Debug)]
pub struct Softplus {
    pub value: f64,
    pub slope: f64,
}

impl Softplus {
    /// Evaluates at `x`, from e^−|x|, which never overflows.
    #[inline]
    pub fn at(x: f64) -> Self {
        if x > FAR_SOFTPLUS {
            return Self { value: x, slope: 1.0 };
        }
        if x < -FAR_SOFTPLUS {
            return Self { value: 0.0, slope: 0.0 };
        }
        let e = exp(-x.abs());
        let tail = ln(1.0 + e);
        if x > 0.0 {
            Self { value: x + tail, slope: 1.0 / (1.0 + e) }
        } else {
            Self { value: tail, slope: e / (1.0 + e) }
        }
    }

    /// Returns ∫ sp from −∞ to x: the energy of a softened linear spring.
    ///
    /// With L = sp(x), dx = dL/(1 − e^−L): the integral of L/(1 − e^−L).
    pub fn area(&self) -> f64 {
        let l = self.value;
        if l < NEAR { series(l, 1) } else { 0.5 * l * l + ZETA_2 - tail(l, |k| (l + 1.0 / k) / k) }
    }

    /// Returns ∫ sp² from −∞ to x: the energy of a softened square law.
    pub fn area_of_square(&self) -> f64 {
        let l = self.value;
        if l < NEAR {
            series(l, 2)
        } else {
            let far = |k: f64| (l * l + 2.0 * (l + 1.0 / k) / k) / k;
            l * l * l / 3.0 + 2.0 * ZETA_3 - tail(l, far)
        }
    }
}

/// Limit between Bernoulli's series for the integrals, below, and exponentials, above.
const NEAR: f64 = 2.0;

const ZETA_2: f64 = core::f64::consts::PI * core::f64::consts::PI / 6.0;
/// ζ(3), Apéry's constant.
const ZETA_3: f64 = 1.202_056_903_159_594_3;

/// B₂ₙ/(2n)!, from n = 1: l/(1 − e^−l) = 1 + l/2 + Σ B₂ₙ l²ⁿ/(2n)!, for |l| < 2π.
const BERNOULLI: [f64; 12] = [
    8.333_333_333_333_333e-2,
    -1.388_888_888_888_889e-3,
    3.306_878_306_878_307e-5,
    -8.267_195_767_195_768e-7,
    2.087_675_698_786_81e-8,
    -5.284_190_138_687_493e-10,
    1.338_253_653_068_467_9e-11,
    -3.389_680_296_322_582_7e-13,
    8.586_062_056_277_845e-15,
    -2.174_868_698_558_062e-16,
    5.509_002_828_360_229_5e-18,
    -1.395_446_468_581_252_3e-19,
];

/// Returns ∫ lᵐ/(1 − e^−l) from 0 to `l`, for m = 1 or 2: to 1e-13 of it at l = 2.
fn series(l: f64, m: u8) -> f64 {
    let m = f64::from(m);
    let square = l * l;
    let (mut sum, mut power, mut n) = (1.0 / m + 0.5 * l / (m + 1.0), 1.0, m);
    for factor in BERNOULLI {
        power *= square;
        n += 2.0;
        sum += factor * power / n;
    }
    if m > 1.5 { sum * square } else { sum * l }
}

/// Returns Σ e^−kl `term`(k): the rest of a Debye integral beyond `l`.
fn tail(l: f64, term: impl Fn(f64) -> f64) -> f64 {
    /// Number of terms: e^−2k is 1e-16 then.
    const TERMS: u8 = 18;
    let ratio = exp(-l);
    let (mut sum, mut power) = (0.0, 1.0);
    for k in 1..=TERMS {
        power *= ratio;
        let more = power * term(f64::from(k));
        sum += more;
        if more < sum * f64::EPSILON {
            break;
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫ f from −60 to `x` by Simpson's rule over pieces of 1/64: h⁴/180 of the fourth
    /// derivative, below 1, is 3e-10 for all of it.
    fn integral(x: f64, f: impl Fn(f64) -> f64) -> f64 {
        const PIECE: f64 = 1.0 / 64.0;
        let mut sum = 0.0;
        let mut from = -60.0;
        while from < x {
            let h = PIECE.min(x - from);
            sum += h / 6.0 * (f(from) + 4.0 * f(from + 0.5 * h) + f(from + h));
            from += h;
        }
        sum
    }

    #[test]
    fn the_areas_are_the_integrals() {
        for x in [-50.0, -20.0, -3.0, -0.5, 0.0, 0.7, 1.8, 1.9, 2.1, 5.0, 17.0, 39.9, 41.0] {
            let here = Softplus::at(x);
            let area = integral(x, |t| Softplus::at(t).value);
            let square = integral(x, |t| Softplus::at(t).value.powi(2));
            let close = |a: f64, b: f64| (a - b).abs() < 1e-9 + 1e-12 * b;
            assert!(close(here.area(), area), "{x}: {} is not {area}", here.area());
            let got = here.area_of_square();
            assert!(close(got, square), "{x}: {got} is not {square}");
        }
    }

    #[test]
    fn the_two_forms_of_the_areas_meet() {
        // sp(x) = 2 at ln(e² − 1); 1e-9 to either side the areas grow by 2e-9 and 4e-9.
        let x = 2.0_f64.exp_m1().ln();
        let [below, above] = [x - 1e-9, x + 1e-9].map(Softplus::at);
        let gap = |f: fn(&Softplus) -> f64, slope: f64| f(&above) - f(&below) - 2e-9 * slope;
        assert!(gap(Softplus::area, 2.0).abs() < 1e-12, "{:e}", gap(Softplus::area, 2.0));
        assert!(gap(Softplus::area_of_square, 4.0).abs() < 1e-12);
    }

    #[test]
    fn far_out_it_is_its_asymptotes() {
        let [left, right] = [-1e300, 1e300].map(Softplus::at);
        assert!((left.value, left.slope) == (0.0, 0.0));
        assert!((right.value, right.slope) == (1e300, 1.0));
        for x in [-40.0_f64, 40.0] {
            let (inside, outside) = (Softplus::at(x), Softplus::at(x * (1.0 + 1e-15)));
            assert!((inside.value - outside.value).abs() < 1e-13, "{x}");
            assert!((inside.slope - outside.slope).abs() < 1e-16, "{x}");
        }
    }
}
