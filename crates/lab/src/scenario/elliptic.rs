//! Elliptic functions, by the arithmetic-geometric mean. `[AS64]` 16.4, 17.6

/// Returns the complete elliptic integral of the first kind for the modulus `k` in 0 .. 1.
pub(super) fn quarter_period(k: f64) -> f64 {
    let means = means(k);
    core::f64::consts::FRAC_PI_2 / means.last().map_or(1.0, |mean| mean.a)
}

/// Returns sn and cn of `u` for the modulus `k`, by descending Landen transformations.
pub(super) fn sn_cn(u: f64, k: f64) -> (f64, f64) {
    let means = means(k);
    let mut phi = means.iter().skip(1).fold(u, |u, _| 2.0 * u) * means.last().map_or(1.0, |m| m.a);
    for mean in means.iter().skip(1).rev() {
        phi = 0.5 * (phi + (mean.c / mean.a * phi.sin()).asin());
    }
    phi.sin_cos()
}

/// A step of the arithmetic-geometric mean: a, and c = (a − b)/2 of the step before.
#[derive(Clone, Copy, Debug)]
struct AgmStep {
    a: f64,
    c: f64,
}

fn means(k: f64) -> Vec<AgmStep> {
    /// Convergence is quadratic: below k = 1 − ε no more are needed.
    const MOST: usize = 12;
    let (mut a, mut b) = (1.0, (1.0 - k * k).sqrt());
    let mut means = vec![AgmStep { a, c: k }];
    while means.len() < MOST && a - b > f64::EPSILON * a {
        let c = 0.5 * (a - b);
        (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
        means.push(AgmStep { a, c });
    }
    means
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_quarter_period_is_that_of_tables() {
        // [AS64] table 17.1: K(m = 0.5) and K(m = 0.25).
        assert!((quarter_period(0.5_f64.sqrt()) - 1.854_074_677_301_371_9).abs() < 4e-16);
        assert!((quarter_period(0.5) - 1.685_750_354_812_596).abs() < 4e-16);
        assert!((quarter_period(0.0) - core::f64::consts::FRAC_PI_2).abs() < 2e-16);
    }

    #[test]
    fn sn_and_cn_meet_their_identities() {
        for k in [0.0, 0.3, 0.9] {
            let quarter = quarter_period(k);
            let (sn, cn) = sn_cn(quarter, k);
            assert!((sn - 1.0).abs() < 1e-15 && cn.abs() < 1e-15, "k = {k}: {sn}, {cn}");
            // sn(K/2) = 1/√(1 + k'), k' = √(1 − k²).
            let half = (1.0 + (1.0 - k * k).sqrt()).sqrt().recip();
            assert!((sn_cn(0.5 * quarter, k).0 - half).abs() < 1e-15, "k = {k}");
            let (sn, cn) = sn_cn(1.7 * quarter, k);
            assert!((sn - sn_cn(0.3 * quarter, k).0).abs() < 3e-15 && cn < 0.0, "k = {k}");
        }
    }
}
