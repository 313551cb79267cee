//! The series of a bell, the input of strokes given as formulas.

use super::PER_ORDER;
use crate::math::exp;

/// Adds the coefficients of height exp(−(z + dz τ)²) by power of τ to `terms`; each follows from
/// the two before it, by f' = −2 dz (z + dz τ) f.
#[inline]
pub fn add_bell(terms: &mut [f64], height: f64, z: f64, dz: f64) {
    let (by_last, by_last_but_one) = (-2.0 * z * dz, -2.0 * dz * dz);
    let (mut before, mut now) = (0.0, height * exp(-z * z));
    for (k, term) in terms.iter_mut().enumerate() {
        *term += now;
        let per = PER_ORDER.get(k + 1).copied().unwrap_or(0.0);
        (before, now) = (now, (by_last * now + by_last_but_one * before) * per);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bell_is_its_series() {
        for (z, dz) in [(0.0, 0.3), (1.5, -0.4), (-3.0, 0.5)] {
            let mut terms = [0.0; 28];
            add_bell(&mut terms, 2.0, z, dz);
            for tau in [0.0, 0.4, 1.0] {
                let found = terms.iter().rev().fold(0.0, |sum, term| term + tau * sum);
                let z = z + dz * tau;
                let expected = 2.0 * (-z * z).exp();
                assert!((found - expected).abs() < 1e-13, "{z}: {found} is not {expected}");
            }
        }
    }
}
