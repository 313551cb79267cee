//! The mean of a readout over a piece with known values at both ends.

/// Simpson's rule, exact up to cubics: one place inside, with the weights of the ends and of it.
pub(crate) const SIMPSON: Rule<1> = Rule { ends: 1.0 / 6.0, inside: [(0.5, 4.0 / 6.0)], looks: 1 };

/// Gauss–Lobatto with six places: exact up to degree 9. `[AS64]` table 25.6.
pub(crate) const LOBATTO: Rule<4> = Rule {
    ends: 1.0 / 30.0,
    inside: [
        (0.117_472_338_035_267_65, 0.189_237_478_148_923_5),
        (0.357_384_241_759_677_5, 0.277_429_188_517_743_2),
        (0.642_615_758_240_322_5, 0.277_429_188_517_743_2),
        (0.882_527_661_964_732_3, 0.189_237_478_148_923_5),
    ],
    looks: 4,
};

/// Order of a dense output at which Simpson's rule becomes the larger error.
pub(crate) const HIGH: u32 = 5;

pub(crate) const fn looks(dense: u32) -> u32 {
    if dense >= HIGH { LOBATTO.looks() } else { SIMPSON.looks() }
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Rule<const N: usize> {
    ends: f64,
    inside: [(f64, f64); N],
    looks: u32,
}

impl<const N: usize> Rule<N> {
    pub(crate) const fn looks(&self) -> u32 {
        self.looks
    }

    #[inline]
    pub(crate) fn mean(&self, ends: [f64; 2], mut value: impl FnMut(f64) -> f64) -> f64 {
        let inside: f64 = self.inside.iter().map(|(place, weight)| weight * value(*place)).sum();
        self.ends * (ends[0] + ends[1]) + inside
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check<const N: usize>(rule: Rule<N>, degree: i32) {
        for power in 0..=degree + 1 {
            let f = |x: f64| (0.2 + x).powi(power);
            let exact = (1.2_f64.powi(power + 1) - 0.2_f64.powi(power + 1)) / f64::from(power + 1);
            let error = (rule.mean([f(0.0), f(1.0)], f) - exact).abs();
            assert_eq!(error < 1e-14, power <= degree, "x^{power}: {error:e}");
        }
    }

    #[test]
    fn each_rule_is_exact_up_to_its_degree_and_no_further() {
        check(SIMPSON, 3);
        check(LOBATTO, 9);
    }
}
