//! Whether a guard crosses zero within a step, and where it is shut in.
//!
//! Found are: a sign change; a pair of roots (both ends positive), by looking at the
//! true guard once at the minimum of its cubic; a guard that starts at zero, rises and
//! falls again; and one that rests at zero and then turns negative.

use crate::cubic::Cubic;
use crate::epoch::Stand;
use crate::guard::{GuardSpec, GuardValue};
use crate::locate::Bracket;

/// One guard over one step: its stand and its values at both ends, rates per step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Span<'a> {
    pub(crate) spec: &'a GuardSpec,
    pub(crate) stand: Stand,
    pub(crate) start: GuardValue,
    pub(crate) end: GuardValue,
    /// Length of the step [s].
    pub(crate) h: f64,
}

/// What a step holds for a guard.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Crossing {
    /// Nothing.
    None,
    /// It fires at the very start of the step.
    AtStart,
    /// It falls through `level` (zero, or just below) inside the bracket.
    Within {
        bracket: Bracket,
        level: f64,
        /// Where the guard's cubic vanishes, and its slope there.
        seed: Option<(f64, f64)>,
    },
}

impl Span<'_> {
    /// Looks for the first crossing; `guard` evaluates the true guard inside the step.
    pub(crate) fn crossing(&self, guard: impl FnMut(f64) -> f64) -> Crossing {
        match self.stand {
            Stand::Leaving => Crossing::AtStart,
            Stand::Disarmed => Crossing::None,
            Stand::Resting => self.from_rest(),
            Stand::Armed | Stand::Departing => self.from_above(guard),
        }
    }

    fn cubic(&self) -> Cubic {
        let (start, end) = (self.start, self.end);
        Cubic::hermite(start.value, start.rate * self.h, end.value, end.rate * self.h)
    }

    /// Whether the end of the step lies below zero, or on it and falling.
    fn ends_below(&self) -> bool {
        self.end.value < -self.spec.band() || (self.end.value <= 0.0 && self.end.rate < 0.0)
    }

    fn from_above(&self, mut guard: impl FnMut(f64) -> f64) -> Crossing {
        let armed = self.stand == Stand::Armed;
        let below = self.ends_below();
        // Far guards cost the comparison above and these two.
        if armed && !below && (self.start.rate >= 0.0 || self.end.rate <= 0.0) {
            return Crossing::None;
        }
        let cubic = self.cubic();
        let (maximum, minimum) = cubic.turns();
        let Some((hi, at_hi)) = self.low_end(below, minimum, &mut guard) else {
            return Crossing::None;
        };
        let low = if armed {
            Some((0.0, self.start.value))
        } else {
            high_point(maximum.filter(|tau| *tau < hi), hi, self.spec.band(), guard)
        };
        low.map_or(Crossing::AtStart, |(lo, at_lo)| Crossing::Within {
            bracket: Bracket { lo, at_lo, hi, at_hi },
            level: 0.0,
            seed: cubic.first_root(lo, hi).map(|tau| (tau, cubic.slope(tau))),
        })
    }

    /// A point after the crossing: the end of the step, or the dip of a pair of roots.
    fn low_end(
        &self,
        below: bool,
        minimum: Option<f64>,
        mut guard: impl FnMut(f64) -> f64,
    ) -> Option<(f64, f64)> {
        if below {
            return Some((1.0, self.end.value));
        }
        let dip = minimum?;
        let value = guard(dip);
        // A touch within rounding is not a crossing.
        (value < -self.spec.band()).then_some((dip, value))
    }

    fn from_rest(&self) -> Crossing {
        if self.end.value >= -self.spec.band() {
            return Crossing::None;
        }
        if self.cubic().curvature() < -self.spec.band() {
            return Crossing::AtStart;
        }
        // No derivative says when it turns negative: take where it leaves the band.
        let level = -self.spec.band();
        let at_lo = (self.start.value - level).max(f64::MIN_POSITIVE);
        let bracket = Bracket { lo: 0.0, at_lo, hi: 1.0, at_hi: self.end.value - level };
        Crossing::Within { bracket, level, seed: None }
    }
}

/// A point before `hi` at which a guard that started at zero is positive.
fn high_point(
    maximum: Option<f64>,
    hi: f64,
    band: f64,
    mut guard: impl FnMut(f64) -> f64,
) -> Option<(f64, f64)> {
    /// After the cubic's own maximum, two places ever nearer to the start.
    const TRIES: [f64; 2] = [1.0 / 16.0, 1.0 / 1024.0];
    let places = [maximum, Some(TRIES[0] * hi), Some(TRIES[1] * hi)];
    places
        .into_iter()
        .flatten()
        .map(|tau| (tau, guard(tau)))
        .find(|(_, value)| *value > band)
}
