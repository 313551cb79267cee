use super::TERMS;
use crate::guard::GuardValue;

/// Polynomials of a mode's guards along one step.
#[derive(Clone, Copy, Debug)]
pub struct GuardSeries<'a> {
    /// Coefficients by power of the time in units of the expansion.
    pub(crate) terms: &'a [[f64; TERMS]],
    pub(crate) known: usize,
    pub(crate) order: usize,
    /// Length of the step in units of the expansion.
    pub(crate) ratio: f64,
}

impl GuardSeries<'_> {
    /// Returns the guard at `index` of the mode's list, by power of the fraction of the step.
    #[inline]
    pub(crate) fn guard(&self, index: usize) -> Option<GuardPolynomial> {
        if index >= self.known {
            return None;
        }
        let known = self.terms.get(index)?;
        let (mut terms, mut power) = ([0.0; TERMS], 1.0);
        for (term, known) in terms.iter_mut().zip(known).take(self.order + 1) {
            *term = power * known;
            power *= self.ratio;
        }
        Some(GuardPolynomial { terms, order: self.order })
    }
}

/// A guard along one step: Σ c τᵏ for τ in 0 ..= 1.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct GuardPolynomial {
    pub(crate) terms: [f64; TERMS],
    pub(crate) order: usize,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct GuardSums {
    /// Value and rate (per second) at both ends of the step.
    pub(crate) start: GuardValue,
    pub(crate) end: GuardValue,
    /// Largest fall below its start: no power of τ exceeds 1, and none is negative.
    pub(crate) falls: f64,
    /// Largest contribution of the unknown coefficients.
    pub(crate) rest: f64,
}

impl GuardPolynomial {
    #[inline]
    pub(crate) fn terms(&self) -> &[f64] {
        self.terms.get(..=self.order).unwrap_or(&self.terms)
    }

    /// Returns the guard's ends and its largest fall over a step of `h` (s).
    #[inline]
    pub(crate) fn sums(&self, h: f64) -> GuardSums {
        let (mut value, mut slope, mut falls) = (0.0, 0.0, 0.0);
        for (k, term) in self.terms().iter().enumerate().skip(1).rev() {
            value += term;
            slope += k as f64 * term;
            falls += if *term < 0.0 { *term } else { 0.0 };
        }
        let [first, second, ..] = self.terms;
        let last = |n: usize| self.order.checked_sub(n).map_or(0.0, |at| self.terms[at].abs());
        GuardSums {
            start: GuardValue::new(first, second / h),
            end: GuardValue::new(first + value, slope / h),
            falls,
            rest: last(0) + last(1),
        }
    }

    pub(crate) fn bend(&self) -> f64 {
        let bend = |(k, term): (usize, &f64)| (k * k.saturating_sub(1)) as f64 * term.abs();
        self.terms().iter().enumerate().map(bend).sum()
    }

    #[inline]
    pub(crate) fn at(&self, tau: f64) -> (f64, f64) {
        self.terms()
            .iter()
            .rev()
            .fold((0.0, 0.0), |(value, slope), term| (term + tau * value, value + tau * slope))
    }

    pub(crate) fn negated(&self) -> Self {
        Self { terms: self.terms.map(|term| -term), order: self.order }
    }

    /// Returns the polynomial less its start, divided by τ: the motion of a guard that leaves zero.
    #[inline]
    pub(crate) fn departed(&self) -> Self {
        let mut terms = [0.0; TERMS];
        for (term, next) in terms.iter_mut().zip(self.terms.iter().skip(1)) {
            *term = *next;
        }
        Self { terms, order: self.order.saturating_sub(1) }
    }
}
