//! Search for a dip of a guard below zero between two positive ends.
//!
//! The cubic Hermite of a step misplaces the minimum of a guard that is no cubic, and a dip of
//! 1e-12 is narrow. Each evaluation of the true guard raises the degree of the interpolating
//! polynomial by one, and the minimum of that polynomial is the next place to evaluate.

use crate::cubic::Cubic;

/// Evaluations that correct the polynomial: all but the last.
const PLACES: usize = Dip::LOOKS as usize - 1;

/// The cubic of a step, corrected by evaluations of the true guard inside it:
/// p(τ) = c(τ) + w(τ) n(τ) with w = τ² (1 − τ)², which keeps values and slopes at both ends.
struct Corrected<'a> {
    cubic: &'a Cubic,
    nodes: [f64; PLACES],
    /// Coefficients of n in Newton's form.
    terms: [f64; PLACES],
    used: usize,
}

type Jet = [f64; 3];

fn product([a, a1, a2]: Jet, [b, b1, b2]: Jet) -> Jet {
    [a * b, a1 * b + a * b1, a2 * b + 2.0 * a1 * b1 + a * b2]
}

fn sum(a: Jet, b: Jet) -> Jet {
    core::array::from_fn(|i| a[i] + b[i])
}

fn weight(tau: f64) -> Jet {
    let root = [tau * (1.0 - tau), 1.0 - 2.0 * tau, -2.0];
    product(root, root)
}

impl<'a> Corrected<'a> {
    const fn new(cubic: &'a Cubic) -> Self {
        Self { cubic, nodes: [0.0; PLACES], terms: [0.0; PLACES], used: 0 }
    }

    fn correction(&self, tau: f64) -> Jet {
        let known = self.nodes.iter().zip(&self.terms).take(self.used);
        known.rev().fold([0.0; 3], |sum_, (node, term)| {
            sum([*term, 0.0, 0.0], product([tau - node, 1.0, 0.0], sum_))
        })
    }

    fn jet(&self, tau: f64) -> Jet {
        let cubic = [self.cubic.at(tau), self.cubic.slope(tau), self.cubic.bend(tau)];
        sum(cubic, product(weight(tau), self.correction(tau)))
    }

    fn learn(&mut self, tau: f64, value: f64) {
        let missing = value - self.jet(tau)[0];
        let reach: f64 = self.nodes.iter().take(self.used).map(|node| tau - node).product();
        (self.nodes[self.used], self.terms[self.used]) = (tau, missing / (weight(tau)[0] * reach));
        self.used += 1;
    }

    /// Returns the minimum of the polynomial next to `tau`, by Newton, if it is convex there.
    fn lowest(&self, mut tau: f64) -> Option<f64> {
        const ROUNDS: usize = 4;
        for _ in 0..ROUNDS {
            let [_, slope, bend] = self.jet(tau);
            let next = tau - slope / bend;
            if !(bend > 0.0 && next > 0.0 && next < 1.0) {
                return None;
            }
            tau = next;
        }
        Some(tau)
    }
}

pub(crate) struct Dip;

impl Dip {
    pub(crate) const LOOKS: u32 = 4;

    /// Returns a place where `guard` is below `-band`, searched from the `cubic`'s minimum `tau`.
    /// The search continues while the polynomial predicts less than half of the lowest value found.
    pub(crate) fn below(
        cubic: &Cubic,
        tau: f64,
        band: f64,
        mut guard: impl FnMut(f64) -> f64,
    ) -> Option<(f64, f64)> {
        let mut model = Corrected::new(cubic);
        let mut at = tau;
        loop {
            let value = guard(at);
            if value < -band {
                return Some((at, value));
            }
            if model.used == PLACES || model.nodes[..model.used].contains(&at) {
                return None;
            }
            model.learn(at, value);
            at = model.lowest(at)?;
            let expected = model.jet(at)[0];
            if expected >= 0.5 * value || expected.is_nan() {
                return None;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn looks(guard: impl Fn(f64) -> [f64; 2]) -> (bool, usize) {
        let ([g0, d0], [g1, d1]) = (guard(0.0), guard(1.0));
        let cubic = Cubic::hermite(g0, d0, g1, d1);
        let mut looks = 0;
        let minimum = cubic.turns().1.expect("a minimum");
        let found = Dip::below(&cubic, minimum, 1e-15, |tau| {
            looks += 1;
            guard(tau)[0]
        });
        (found.is_some(), looks)
    }

    #[test]
    fn a_dip_far_from_zero_takes_one_look() {
        let (found, looks) = looks(|tau| [1.0 + (tau - 0.4).powi(2), 2.0 * (tau - 0.4)]);
        assert_eq!((found, looks), (false, 1));
    }

    #[test]
    fn a_deep_dip_takes_one_look() {
        let (found, looks) = looks(|tau| [(tau - 0.4).powi(2) - 0.01, 2.0 * (tau - 0.4)]);
        assert_eq!((found, looks), (true, 1));
    }

    #[test]
    fn what_is_not_finite_ends_the_search() {
        let cubic = Cubic::hermite(1.0, -4.0, 1.0, 4.0);
        for bad in [f64::NAN, f64::INFINITY] {
            let mut looks = 0;
            let found = Dip::below(&cubic, 0.5, 1e-15, |_| {
                looks += 1;
                bad
            });
            assert!(found.is_none() && looks <= 2, "{bad}: {looks}");
        }
    }
}
