//! The first fall of a polynomial through zero, with certainty.
//!
//! In Bernstein's basis a polynomial lies between its least and its largest coefficient, and has
//! no more roots than its coefficients change their sign. A piece in which neither decides is
//! halved, by de Casteljau's scheme. `[LR81]`

use super::TERMS;
use super::guards::GuardPolynomial;

/// Where a polynomial that is positive at 0 first falls through zero.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Fall {
    /// It is positive all over the step.
    None,
    /// Between these places, and nowhere before.
    Within(f64, f64),
    /// Too many halvings: it comes close to zero, or touches it.
    Open,
}

/// Most halvings of one search.
const HALVINGS: u32 = 32;

/// A piece of the step and the polynomial's coefficients there, in Bernstein's basis.
#[derive(Clone, Copy)]
struct Stretch {
    terms: [f64; TERMS],
    from: f64,
    width: f64,
}

/// What the coefficients of a piece say.
enum Verdict {
    Positive,
    FallsOnce,
    Unknown,
}

/// The first fall of `guard`, where what is within `band` of zero is not told from zero.
pub(crate) fn first_fall(guard: &GuardPolynomial, band: f64) -> Fall {
    let order = guard.order;
    let whole = Stretch { terms: bernstein(guard), from: 0.0, width: 1.0 };
    match whole.verdict(order, band) {
        Verdict::Positive => Fall::None,
        Verdict::FallsOnce => Fall::Within(0.0, 1.0),
        Verdict::Unknown => by_halving(whole, order, band),
    }
}

/// The first fall in the pieces of `whole`.
#[cold]
fn by_halving(whole: Stretch, order: usize, band: f64) -> Fall {
    /// Halvings that can wait: each one is half as wide.
    const DEPTH: usize = 12;
    let mut waiting = [whole; DEPTH];
    let mut count = 1;
    for _ in 0..HALVINGS {
        let Some(index) = usize::checked_sub(count, 1) else { return Fall::None };
        let now = waiting[index];
        match now.verdict(order, band) {
            Verdict::Positive => count = index,
            Verdict::FallsOnce => return Fall::Within(now.from, now.from + now.width),
            Verdict::Unknown if count < DEPTH => {
                let [left, right] = now.halves(order);
                (waiting[index], waiting[count]) = (right, left);
                count += 1;
            }
            Verdict::Unknown => return Fall::Open,
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
    fn verdict(&self, order: usize, band: f64) -> Verdict {
        let terms = self.terms.get(..=order).unwrap_or(&self.terms);
        let [first, .., last] = terms else { return Verdict::Unknown };
        let least = terms.iter().fold(f64::INFINITY, |least: f64, term| least.min(*term));
        let changes = terms.windows(2).filter(|pair| (pair[0] > 0.0) != (pair[1] > 0.0)).count();
        if least > band {
            Verdict::Positive
        } else if changes == 1 && *first > band && *last < -band {
            Verdict::FallsOnce
        } else {
            Verdict::Unknown
        }
    }

    /// Its halves, by means of neighbours.
    fn halves(&self, order: usize) -> [Self; 2] {
        let half = 0.5 * self.width;
        let mut left = Self { width: half, ..*self };
        let mut right = Self { width: half, from: self.from + half, ..*self };
        for done in 0..=order {
            left.terms[done] = right.terms[0];
            for index in 0..order - done {
                right.terms[index] = 0.5 * (right.terms[index] + right.terms[index + 1]);
            }
        }
        [left, right]
    }
}
