//! Detection and bracketing of a guard's zero crossing within a step.
//!
//! Four kinds are detected: a sign change; a pair of roots, by evaluating the true guard where its
//! cubic, corrected by earlier evaluations, is lowest; a guard that starts at zero or below, rises
//! and falls again; and one that rests at zero and then turns negative.

use crate::cubic::{Cubic, Turns};
use crate::dip::Dip;
use crate::enclosure::least;
use crate::epoch::Stand;
use crate::guard::{GuardSpec, GuardValue};
use crate::isolate::{self, Isolated, isolate};
use crate::locate::Bracket;

#[derive(Clone, Copy, Debug)]
pub(crate) struct GuardSpan {
    pub(crate) spec: GuardSpec,
    pub(crate) stand: Stand,
    pub(crate) start: GuardValue,
    pub(crate) end: GuardValue,
    /// Length of the step (s).
    pub(crate) h: f64,
    /// Bound of the guard's second derivative (per step²).
    pub(crate) bend: f64,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Crossing {
    None,
    AtStart,
    /// Falls through `level` (zero, or just below) inside the bracket.
    Within {
        bracket: Bracket,
        level: f64,
        /// Root of the guard's cubic, and its slope there.
        seed: Option<(f64, f64)>,
    },
}

impl GuardSpan {
    pub(crate) const LOOKS: u32 = isolate::LOOKS + Dip::LOOKS + TRIES;

    /// Returns `true` if the guard is certainly positive over the whole step.
    #[inline]
    pub(crate) fn is_clear(&self) -> bool {
        let [start, end] = [self.start, self.end].map(|it| it.value - self.spec.band());
        self.stand == Stand::Armed && least(start, end, self.bend) > 0.0
    }

    /// Returns `true` if no root before a crossing at `tau` can have been missed: from a positive
    /// start the guard lies above a parabola that first vanishes there.
    pub(crate) fn is_first(&self, tau: f64) -> bool {
        self.stand == Stand::Armed && self.start.value > 0.5 * self.bend * tau * tau
    }

    /// Returns `true` if the values at both ends permit a crossing; the only cost of a far guard.
    #[expect(clippy::inline_always, reason = "two comparisons for most guards of most ticks")]
    #[inline(always)]
    pub(crate) fn may_cross(&self) -> bool {
        match self.stand {
            Stand::Leaving | Stand::Departing | Stand::Sinking => true,
            Stand::Resting => self.end.value < -self.spec.band(),
            Stand::Disarmed | Stand::Spent if self.ends_below() => self.may_turn(-1.0),
            Stand::Disarmed | Stand::Spent => self.may_dip(),
            // The bound permits a root, so search, whatever the cubic's shape.
            Stand::Armed if self.bend < f64::INFINITY => true,
            Stand::Armed => self.ends_below() || self.may_turn(1.0),
            Stand::Unwatched => false,
        }
    }

    /// Searches for the first crossing of the true `guard`; `true` if no earlier one can be missed.
    #[inline]
    pub(crate) fn crossing(&self, mut guard: impl FnMut(f64) -> f64) -> (Crossing, bool) {
        let crossing = match self.stand {
            Stand::Armed if self.bend < f64::INFINITY => return self.isolated(&mut guard),
            Stand::Leaving => Crossing::AtStart,
            Stand::Resting => self.falls_from_rest(guard),
            Stand::Sinking => self.leaves_zero(),
            Stand::Disarmed | Stand::Spent => self.rises_and_falls(guard),
            Stand::Armed | Stand::Departing => self.falls(guard),
            Stand::Unwatched => Crossing::None,
        };
        (crossing, false)
    }

    /// Finds the first crossing by the bound of the guard's bend, otherwise by its cubic.
    fn isolated(&self, guard: &mut impl FnMut(f64) -> f64) -> (Crossing, bool) {
        let ends = (self.start.value, self.end.value);
        match isolate(ends, self.bend, self.spec.band(), &mut *guard) {
            Isolated::Free => (Crossing::None, true),
            Isolated::Root { lo, hi } => {
                let cubic = self.cubic();
                (shut_in((&cubic, cubic.turns()), lo.0, lo.1, hi.0, hi.1), true)
            }
            Isolated::Open { low } => {
                let found = self.falls(guard);
                (low.map_or(found, |(hi, at_hi)| self.no_later(found, hi, at_hi)), false)
            }
        }
    }

    /// Returns `found`, or an earlier crossing before `hi`, where the guard is negative.
    fn no_later(&self, found: Crossing, hi: f64, at_hi: f64) -> Crossing {
        match found {
            Crossing::Within { bracket, .. } if bracket.hi <= hi => found,
            Crossing::AtStart => found,
            Crossing::Within { .. } | Crossing::None => {
                let cubic = self.cubic();
                shut_in((&cubic, cubic.turns()), 0.0, self.start.value, hi, at_hi)
            }
        }
    }

    #[inline]
    fn cubic(&self) -> Cubic {
        let (start, end) = (self.start, self.end);
        Cubic::hermite(start.value, start.rate * self.h, end.value, end.rate * self.h)
    }

    #[inline]
    fn ends_below(&self) -> bool {
        self.end.value < -self.spec.band() || (self.end.value <= 0.0 && self.end.rate < 0.0)
    }

    /// Returns `true` if `sign` times the guard, positive at both ends, can dip to zero inside.
    #[inline]
    fn may_turn(&self, sign: f64) -> bool {
        let (g0, g1) = (sign * self.start.value, sign * self.end.value);
        let (d0, d1) = (sign * self.start.rate * self.h, sign * self.end.rate * self.h);
        // A cubic stays within 4/27 (|d0| + |d1|) of its chord; the true guard gets 7 times that.
        if g0.min(g1) > d0.abs() + d1.abs() {
            return false;
        }
        if d0 < 0.0 && d1 > 0.0 {
            return true;
        }
        // With slopes of one sign a cubic is monotone if neither exceeds 3 times the rise.
        let rise = 3.0 * (g1 - g0);
        (d0 >= 0.0 && d1 >= 0.0 && d0.max(d1) > rise)
            || (d0 <= 0.0 && d1 <= 0.0 && d0.min(d1) < rise)
    }

    /// Finds the first fall of a guard that starts positive, or at zero on its way up.
    #[inline]
    fn falls(&self, mut guard: impl FnMut(f64) -> f64) -> Crossing {
        let cubic = self.cubic();
        if self.ends_below() && cubic.is_concave() {
            return self.falls_once(&cubic, guard);
        }
        let turns = cubic.turns();
        let (maximum, minimum) = turns;
        let band = self.spec.band();
        let low = minimum.and_then(|tau| Dip::below(&cubic, tau, band, &mut guard));
        let low = low.or_else(|| self.ends_below().then_some((1.0, self.end.value)));
        let Some((hi, at_hi)) = low else { return Crossing::None };
        let high = if self.stand == Stand::Armed {
            Some((0.0, self.start.value))
        } else {
            high_point(maximum.filter(|tau| *tau < hi), hi, guard)
        };
        high.map_or(Crossing::AtStart, |(lo, at_lo)| shut_in((&cubic, turns), lo, at_lo, hi, at_hi))
    }

    /// Finds the only fall of a guard that is concave over the whole step.
    #[inline]
    fn falls_once(&self, cubic: &Cubic, guard: impl FnMut(f64) -> f64) -> Crossing {
        let root = cubic.root_between(0.0, 1.0);
        let high = if self.stand == Stand::Armed {
            Some((0.0, self.start.value))
        } else {
            high_point(Some(0.5 * root), 1.0, guard)
        };
        high.map_or(Crossing::AtStart, |(lo, at_lo)| Crossing::Within {
            bracket: Bracket { lo, at_lo, hi: 1.0, at_hi: self.end.value },
            level: 0.0,
            seed: Some((root, cubic.slope(root))),
        })
    }

    /// Returns `true` if a guard from below to above zero can rise, fall and rise again.
    #[inline]
    fn may_dip(&self) -> bool {
        self.start.rate > 0.0 && self.end.rate > 0.0 && {
            let (maximum, minimum) = self.cubic().turns();
            maximum.zip(minimum).is_some_and(|(top, bottom)| top < bottom)
        }
    }

    fn rises_and_falls(&self, mut guard: impl FnMut(f64) -> f64) -> Crossing {
        let cubic = self.cubic();
        let turns = cubic.turns();
        let (Some(top), minimum) = turns else { return Crossing::None };
        let at_top = guard(top);
        if at_top <= self.spec.band() {
            return Crossing::None;
        }
        let low = if self.ends_below() {
            Some((1.0, self.end.value))
        } else {
            minimum.and_then(|tau| Dip::below(&cubic, tau, self.spec.band(), guard))
        };
        // The low point of a guard that is no cubic may lie before its cubic's maximum.
        let low = low.filter(|(tau, _)| *tau > top);
        low.map_or(Crossing::None, |(hi, at_hi)| shut_in((&cubic, turns), top, at_top, hi, at_hi))
    }

    fn falls_from_rest(&self, mut guard: impl FnMut(f64) -> f64) -> Crossing {
        /// Fraction of the step at which the guard's curvature is compared with its cubic's.
        const NEAR: f64 = 1.0 / 1024.0;
        let curvature = self.cubic().curvature();
        if curvature < -self.spec.band() {
            let bent = guard(NEAR) - self.start.value;
            let ratio = bent / (curvature * NEAR * NEAR);
            if (0.5..2.0).contains(&ratio) {
                return Crossing::AtStart;
            }
        }
        // No derivative gives the time at which it turns negative.
        self.leaves_zero()
    }

    fn leaves_zero(&self) -> Crossing {
        let level = -self.spec.band();
        let at_lo = (self.start.value - level).max(f64::MIN_POSITIVE);
        let bracket = Bracket { lo: 0.0, at_lo, hi: 1.0, at_hi: self.end.value - level };
        Crossing::Within { bracket, level, seed: None }
    }
}

/// Returns the crossing between a high and a low point, seeded by the cubic's root.
fn shut_in((cubic, turns): (&Cubic, Turns), lo: f64, at_lo: f64, hi: f64, at_hi: f64) -> Crossing {
    let seed = cubic.first_root(turns, lo, hi).map(|tau| (tau, cubic.slope(tau)));
    Crossing::Within { bracket: Bracket { lo, at_lo, hi, at_hi }, level: 0.0, seed }
}

const TRIES: u32 = 3;

fn high_point(
    maximum: Option<f64>,
    hi: f64,
    mut guard: impl FnMut(f64) -> f64,
) -> Option<(f64, f64)> {
    // After the cubic's maximum, two places nearer to the start.
    let places: [_; TRIES as usize] = [maximum, Some(hi / 16.0), Some(hi / 1024.0)];
    places.into_iter().flatten().map(|tau| (tau, guard(tau))).find(|(_, value)| *value > 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dip_before_the_top_is_no_fall() {
        // The guard's cubic rises to 5/8 and falls to 2/3; the true guard differs.
        let span = GuardSpan {
            spec: GuardSpec::new(0, "g"),
            stand: Stand::Disarmed,
            start: GuardValue::new(-0.45, 5.0),
            end: GuardValue::new(0.8, 1.5),
            h: 1.0,
            bend: f64::INFINITY,
        };
        assert!(span.may_cross());
        let (mut looks, mut lowest) = (0, 1.0_f64);
        let crossing = span.crossing(|tau| {
            (looks, lowest) = (looks + 1, lowest.min(tau));
            if tau < 0.6 {
                -0.6
            } else if tau < 0.65 {
                0.4
            } else {
                0.0
            }
        });
        assert_eq!((crossing, looks), ((Crossing::None, false), 3));
        assert!(lowest < 0.5, "the dip was not seen: {lowest}");
    }
}
