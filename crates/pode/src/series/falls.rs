//! The first fall of a polynomial through zero, with certainty.
//!
//! In Bernstein's basis a polynomial lies between its least and its largest coefficient, and has no
//! more roots than its coefficients have sign changes. A stretch in which neither decides is
//! halved, by de Casteljau's scheme. `[LR81]`

use super::TERMS;
use super::guards::GuardPolynomial;

#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Fall {
    None,
    Within(f64, f64),
    /// Too many halvings: the polynomial touches zero or comes close to it.
    Open,
}

const HALVINGS: u32 = 48;

/// Cut of a stretch: near its middle, at an unlikely place for a root.
const CUT: f64 = 0.486_3;

/// A stretch of the step, and the polynomial's coefficients there in Bernstein's basis.
#[derive(Clone, Copy)]
struct Stretch {
    terms: [f64; TERMS],
    from: f64,
    width: f64,
}

enum StretchVerdict {
    Positive,
    FallsOnce,
    Unknown,
}

/// Finds the first fall of `guard`; values within `band` of zero count as zero.
pub(crate) fn first_fall(guard: &GuardPolynomial, band: f64) -> Fall {
    let order = guard.order;
    let whole = Stretch { terms: bernstein(guard), from: 0.0, width: 1.0 };
    match whole.verdict(order, band) {
        StretchVerdict::Positive => Fall::None,
        StretchVerdict::FallsOnce => Fall::Within(0.0, 1.0),
        StretchVerdict::Unknown => by_halving(whole, order, band),
    }
}

#[cold]
fn by_halving(whole: Stretch, order: usize, band: f64) -> Fall {
    /// Maximum of stretches that wait: each is about half as wide as the one before.
    const DEPTH: usize = 24;
    let mut waiting = [whole; DEPTH];
    let mut count = 1;
    for _ in 0..HALVINGS {
        let Some(index) = usize::checked_sub(count, 1) else { return Fall::None };
        let now = waiting[index];
        match now.verdict(order, band) {
            StretchVerdict::Positive => count = index,
            StretchVerdict::FallsOnce => return Fall::Within(now.from, now.from + now.width),
            StretchVerdict::Unknown if count < DEPTH => {
                let [left, right] = now.halves(order);
                (waiting[index], waiting[count]) = (right, left);
                count += 1;
            }
            StretchVerdict::Unknown => return Fall::Open,
        }
    }
    if count == 0 { Fall::None } else { Fall::Open }
}

/// b(i) = Σ C(i, k)/C(n, k) c(k): Pascal's triangle, by sums alone.
fn bernstein(guard: &GuardPolynomial) -> [f64; TERMS] {
    let order = guard.order;
    let mut terms = guard.terms;
    let mut binomial = 1.0;
    for (k, term) in terms.iter_mut().enumerate().take(order + 1) {
        *term /= binomial;
        binomial *= (order - k) as f64 / (k + 1) as f64;
    }
    for from in 0..order {
        for index in (from..order).rev() {
            terms[index + 1] += terms[index];
        }
    }
    terms
}

impl Stretch {
    fn verdict(&self, order: usize, band: f64) -> StretchVerdict {
        let terms = self.terms.get(..=order).unwrap_or(&self.terms);
        let [first, .., last] = terms else { return StretchVerdict::Unknown };
        let least = terms.iter().fold(f64::INFINITY, |least: f64, term| least.min(*term));
        let changes = terms.windows(2).filter(|pair| (pair[0] > 0.0) != (pair[1] > 0.0)).count();
        if least > band {
            StretchVerdict::Positive
        } else if changes == 1 && *first > band && *last < -band {
            StretchVerdict::FallsOnce
        } else {
            StretchVerdict::Unknown
        }
    }

    fn halves(&self, order: usize) -> [Self; 2] {
        let part = CUT * self.width;
        let mut left = Self { width: part, ..*self };
        let mut right = Self { width: self.width - part, from: self.from + part, ..*self };
        for done in 0..=order {
            left.terms[done] = right.terms[0];
            for index in 0..order - done {
                let [here, next] = [right.terms[index], right.terms[index + 1]];
                right.terms[index] = here + CUT * (next - here);
            }
        }
        [left, right]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with_roots(roots: &[f64]) -> (GuardPolynomial, Fall) {
        let mut terms = [0.0; TERMS];
        terms[0] = 1.0;
        for root in roots {
            let below: [f64; TERMS] =
                std::array::from_fn(|k| if k > 0 { terms[k - 1] } else { 0.0 });
            terms.iter_mut().zip(below).for_each(|(term, below)| *term -= below / root);
        }
        let guard = GuardPolynomial { terms, order: roots.len().max(1) };
        (guard, first_fall(&guard, 1e-14))
    }

    #[test]
    fn the_first_of_several_roots_is_shut_in_alone() {
        for roots in [&[0.3, 0.5, 0.9][..], &[0.7, 3.0, -2.0], &[0.01, 0.02], &[0.5, 0.500_1]] {
            let (_, fall) = with_roots(roots);
            let Fall::Within(from, to) = fall else { panic!("{roots:?}: {fall:?}") };
            let inside = roots.iter().filter(|root| **root > from && **root < to).count();
            assert!(inside == 1 && from < roots[0] && roots[0] < to, "{roots:?}: {from}, {to}");
        }
    }

    #[test]
    fn roots_elsewhere_are_none() {
        for roots in [&[1.1, 2.0][..], &[-0.5, 1.5, 1.001], &[-1.0], &[5.0, 6.0, 7.0, 8.0]] {
            assert_eq!(with_roots(roots).1, Fall::None, "{roots:?}");
        }
    }

    #[test]
    fn what_is_proven_positive_is_positive_wherever_one_looks() {
        let mut seed = 7_u64;
        let mut next = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        };
        let mut counts = [0; 3];
        for n in 0..3000 {
            let order = 2 + n % 23;
            let mut terms = [0.0; TERMS];
            terms.iter_mut().take(order + 1).for_each(|term| *term = next());
            terms[0] = terms[0].abs();
            let guard = GuardPolynomial { terms, order };
            let least = |from: f64, to: f64| {
                let at = |n: i32| guard.at(from + (to - from) * f64::from(n) / 500.0).0;
                (0..=500).map(at).fold(f64::INFINITY, f64::min)
            };
            match first_fall(&guard, 1e-12) {
                Fall::None => {
                    assert!(least(0.0, 1.0) > 0.0, "{guard:?}");
                    counts[0] += 1;
                }
                Fall::Within(from, to) => {
                    assert!(least(0.0, from) > 0.0 && guard.at(to).0 < 0.0, "{guard:?}");
                    counts[1] += 1;
                }
                Fall::Open => counts[2] += 1,
            }
        }
        assert!(counts[0] > 500 && counts[1] > 500 && counts[2] < 30, "{counts:?}");
    }
}
