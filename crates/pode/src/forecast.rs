//! What a guard is known to do next, carried from step to step and from tick to tick.
//!
//! `[GC93]` 5.1: the burden of the root finder can be shared by prior steps if a root is
//! predicted in advance. Two numbers per guard do that. `quiet` is how long the guard stays
//! positive for certain, where the model bounds its curvature: until then the guard is not
//! even evaluated. And its curvature over the last step tells when it is due to vanish: a step
//! that would go past that ends just behind it instead, so that the crossing lies at a step's
//! end, where the method is at its best, and not on its dense output.

use crate::epoch::Stand;
use crate::guard::{GuardSpec, GuardValue};
use crate::math::sqrt;

/// One guard of the present mode: how it stands, and what is known of it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct GuardSlot {
    pub(crate) stand: Stand,
    /// Value and rate at the present instant, or where it was evaluated last.
    pub(crate) value: GuardValue,
    /// Whether `value` belongs to the present instant.
    pub(crate) is_fresh: bool,
    /// How long the guard stays positive for certain (s).
    pub(crate) quiet: f64,
    /// Its second derivative (1/s²) over the last step; infinite where there was none.
    pub(crate) curvature: f64,
}

impl GuardSlot {
    pub(crate) const EMPTY: Self = Self {
        stand: Stand::Resting,
        value: GuardValue { value: 0.0, rate: 0.0 },
        is_fresh: false,
        quiet: 0.0,
        curvature: f64::INFINITY,
    };

    /// A guard that stands so at the present instant; its curvature is at most `bound` (1/s²).
    #[inline]
    pub(crate) fn new(stand: Stand, spec: &GuardSpec, value: GuardValue, bound: f64) -> Self {
        let quiet = if stand == Stand::Armed { quiet(spec, value, bound) } else { 0.0 };
        Self { stand, value, is_fresh: true, quiet, curvature: f64::INFINITY }
    }

    /// Whether the guard is positive for certain over the `h` (s) ahead.
    #[inline]
    pub(crate) fn is_quiet(&self, h: f64) -> bool {
        self.quiet > h
    }

    /// Whether it is for so long that its value after them is not needed either.
    #[inline]
    pub(crate) fn is_asleep(&self, h: f64) -> bool {
        self.quiet > 2.0 * h
    }

    /// When (s) it is expected to vanish, if that is within `h` (s); infinite otherwise.
    #[inline]
    pub(crate) fn due_within(&self, h: f64) -> f64 {
        // A sleeping guard is not due, and most others are too far to fall that low.
        let fall = h * (self.value.rate.abs() + 0.5 * self.curvature.abs() * h);
        let is_far = !self.is_fresh || fall < self.value.value;
        if is_far { f64::INFINITY } else { due(self.value, self.curvature) }
    }

    /// The same `dt` (s) later, with nothing new known.
    #[inline]
    pub(crate) fn later(&mut self, dt: f64) {
        self.quiet -= dt;
        self.is_fresh = false;
    }
}

/// How long (s) a guard stays positive if its second derivative stays within ±`bound`.
#[inline]
pub(crate) fn quiet(spec: &GuardSpec, guard: GuardValue, bound: f64) -> f64 {
    let room = guard.value - spec.band();
    if !is_bounded(bound) || room <= 0.0 {
        return 0.0;
    }
    // g + g' t − ½ bound t² = 0, by the form that loses no digits.
    let root = sqrt(guard.rate * guard.rate + 2.0 * bound * room);
    if guard.rate > 0.0 { (guard.rate + root) / bound } else { 2.0 * room / (root - guard.rate) }
}

/// Whether the model has stated a bound; NaN is none.
#[inline]
fn is_bounded(bound: f64) -> bool {
    bound < f64::INFINITY
}

/// When (s) a guard with this curvature vanishes, from above; infinite if it does not.
fn due(guard: GuardValue, curvature: f64) -> f64 {
    let discriminant = guard.rate * guard.rate - 2.0 * curvature * guard.value;
    if discriminant < 0.0 || discriminant.is_nan() || guard.value <= 0.0 {
        return f64::INFINITY;
    }
    let root = sqrt(discriminant);
    let due = if guard.rate > 0.0 {
        -(guard.rate + root) / curvature
    } else {
        2.0 * guard.value / (root - guard.rate)
    };
    if due > 0.0 { due } else { f64::INFINITY }
}

/// Whether a guard whose second derivative stays within ±`bound` is positive all over a step
/// of `h` (s), at both ends of which it is known.
#[inline]
pub(crate) fn is_certain(
    band: f64,
    start: GuardValue,
    end: GuardValue,
    bound: f64,
    h: f64,
) -> bool {
    if !is_bounded(bound) {
        return false;
    }
    // From either end it lies above a parabola; where these meet, both are lowest inside.
    let (g0, g1) = (start.value - band, end.value - band);
    let meet = (g1 - g0 - end.rate * h - 0.5 * bound * h * h) / (start.rate - end.rate - bound * h);
    let t = if meet.is_finite() { meet.clamp(0.0, h) } else { 0.5 * h };
    let left = g0 + t * (start.rate - 0.5 * bound * t);
    let rest = h - t;
    let right = g1 - rest * (end.rate + 0.5 * bound * rest);
    g0 > 0.0 && g1 > 0.0 && left > 0.0 && right > 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPEC: GuardSpec = GuardSpec::new(0, "g");

    fn guard(value: f64, rate: f64) -> GuardValue {
        GuardValue::new(value, rate)
    }

    #[test]
    fn a_falling_guard_is_quiet_until_its_worst_parabola_vanishes() {
        // 1 − t − ½·4 t² = 0 at t = ½.
        assert!((quiet(&SPEC, guard(1.0, -1.0), 4.0) - 0.5).abs() < 1e-14);
        // 1 + t − ½·4 t² = 0 at t = 1.
        assert!((quiet(&SPEC, guard(1.0, 1.0), 4.0) - 1.0).abs() < 1e-14);
        assert_eq!(quiet(&SPEC, guard(1.0, 1.0), f64::INFINITY).to_bits(), 0);
        assert_eq!(quiet(&SPEC, guard(-1.0, 1.0), 1.0).to_bits(), 0);
    }

    #[test]
    fn a_root_is_due_where_the_parabola_falls_through_zero() {
        // 1 + t − 2t² and 1 − t: both at 1.
        for (rate, curvature) in [(1.0, -4.0), (-1.0, 0.0)] {
            assert!((due(guard(1.0, rate), curvature) - 1.0).abs() < 1e-15);
        }
        assert!(due(guard(1.0, 1.0), 0.0).is_infinite());
        assert!(due(guard(1.0, -1.0), 4.0).is_infinite(), "it turns before");
    }

    #[test]
    fn a_step_is_certain_just_as_far_as_its_parabolas_allow() {
        // Falls to 1 − ½ b t² in the middle of a step of 2: certain if b < 2.
        let (start, end) = (guard(1.0, 0.0), guard(1.0, 0.0));
        assert!(is_certain(0.0, start, end, 1.99, 2.0));
        assert!(!is_certain(0.0, start, end, 2.01, 2.0));
        assert!(!is_certain(0.0, start, end, f64::INFINITY, 2.0));
    }
}
