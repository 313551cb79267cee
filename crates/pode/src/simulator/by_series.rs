//! Guards with a series from the method: searched as polynomials, not evaluated.

use super::Simulator;
use super::detect::GuardVerdict;
use crate::crossing::{Crossing, GuardSpan};
use crate::epoch::Stand;
use crate::guard::GuardSpec;
use crate::locate::Bracket;
use crate::model::Resets;
use crate::outcome::Fault;
use crate::series::{Fall, GuardPolynomial, first_fall};
use crate::stepper::{Memory as _, Stepper};

impl<M: Resets, T: Stepper> Simulator<M, T> {
    #[inline]
    pub(super) fn has_series(&self, guards: usize) -> bool {
        let [memory, ..] = &self.memory;
        T::IS_EXPANDED && memory.method().guards().is_some_and(|it| it.known >= guards)
    }

    #[inline]
    pub(super) fn guard_along(&self, index: usize) -> Option<GuardPolynomial> {
        let [memory, ..] = &self.memory;
        memory.method().guards()?.guard(index)
    }

    /// Sets a guard's values at both ends of a step of `h` (s); returns its verdict.
    pub(super) fn look_along(
        &mut self,
        guard: &GuardPolynomial,
        (index, spec): (usize, &GuardSpec),
        h: f64,
    ) -> Result<GuardVerdict, Fault> {
        let slot = &mut self.guards[index];
        let sums = guard.sums(h);
        if !sums.start.is_finite() || !sums.end.is_finite() {
            return Err(Fault::Guard);
        }
        (slot.start, slot.value, slot.is_fresh) = (sums.start, sums.end, true);
        (slot.bend, slot.curvature) = (f64::INFINITY, f64::INFINITY);
        let band = spec.band() + sums.rest;
        if slot.stand == Stand::Armed && sums.start.value + sums.falls > band {
            return Ok(GuardVerdict::Clear);
        }
        let is_falling = match slot.stand {
            Stand::Armed => first_fall(guard, band) != Fall::None,
            Stand::Departing => first_fall(&guard.departed(), band) != Fall::None,
            Stand::Resting
            | Stand::Disarmed
            | Stand::Spent
            | Stand::Sinking
            | Stand::Leaving
            | Stand::Unwatched => true,
        };
        slot.bend = if slot.stand == Stand::Armed { guard.bend() } else { f64::INFINITY };
        Ok(if is_falling { GuardVerdict::Candidate } else { GuardVerdict::Clear })
    }

    /// Finds the first crossing of a guard that starts positive, or leaves zero: its polynomial
    /// brackets it, and the true guard decides. `None` where both disagree.
    pub(super) fn crossing_along(
        &self,
        index: usize,
        span: &GuardSpan,
        guard: impl Fn(f64) -> f64,
    ) -> Option<(Crossing, bool)> {
        let series = self.guard_along(index)?;
        if span.stand == Stand::Armed && span.start.value <= 0.0 {
            return Some((Crossing::AtStart, true));
        }
        let rest = span.spec.band() + series.sums(1.0).rest;
        let fall = match span.stand {
            Stand::Armed => first_fall(&series, rest),
            Stand::Departing => first_fall(&series.departed(), rest),
            Stand::Resting
            | Stand::Disarmed
            | Stand::Spent
            | Stand::Sinking
            | Stand::Leaving
            | Stand::Unwatched => return None,
        };
        match fall {
            Fall::None => Some((Crossing::None, true)),
            Fall::Open => None,
            Fall::Within(from, to) => {
                let bracket = shut_in(&series, (from, to), rest, guard)?;
                Some((Crossing::Within { bracket, level: 0.0, seed: None }, true))
            }
        }
    }
}

/// Evaluates the true guard on both sides of its `series`' only root, as close as `rest` permits.
fn shut_in(
    series: &GuardPolynomial,
    (mut lo, mut hi): (f64, f64),
    rest: f64,
    guard: impl Fn(f64) -> f64,
) -> Option<Bracket> {
    /// Newton doubles the digits, and bisection covers the rest.
    const ROUNDS: usize = 60;
    /// Distance from the root to both sides, in units of the series' error.
    const SIDES: f64 = 4.0;
    let (whole, mut tau) = ((lo, hi), 0.5 * (lo + hi));
    for _ in 0..ROUNDS {
        let (value, slope) = series.at(tau);
        (lo, hi) = if value > 0.0 { (tau, hi) } else { (lo, tau) };
        let next = tau - value / slope;
        let step = (next - tau).abs();
        tau = if next > lo && next < hi { next } else { 0.5 * (lo + hi) };
        if step <= 2.0 * f64::EPSILON || hi - lo <= 2.0 * f64::EPSILON {
            break;
        }
    }
    let (_, slope) = series.at(tau);
    let reach = SIDES * (rest / slope.abs() + f64::EPSILON);
    let (lo, hi) = ((tau - reach).max(whole.0), (tau + reach).min(whole.1));
    let (at_lo, at_hi) = (guard(lo), guard(hi));
    (at_lo > 0.0 && at_hi <= 0.0).then_some(Bracket { lo, at_lo, hi, at_hi })
}
