//! The last gate before a motor: it stops forces that are not finite, too large or too sudden.

use core::error::Error;
use core::fmt;

/// An invalid limit of a gate, with its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LimitError {
    /// The force limit (N) is not finite and positive.
    Force(f64),
    /// The slew limit (N/s) is not finite and positive.
    Slew(f64),
}

impl fmt::Display for LimitError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Force(value) => {
                write!(formatter, "force limit must be finite and positive, got {value} N")
            }
            Self::Slew(value) => {
                write!(formatter, "slew limit must be finite and positive, got {value} N/s")
            }
        }
    }
}

impl Error for LimitError {}

/// A force that passed the gate, with the gate's interventions.
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
pub struct Gated {
    /// Force that may be sent (N); always finite and within the limit.
    pub force: f64,
    /// `true` if the wanted force was finite; otherwise zero replaced it.
    pub finite: bool,
    pub limited: bool,
    /// `true` if the slew limit still holds the force back.
    pub slewed: bool,
}

/// Limits a force in size and slew, and rejects NaN and infinity.
///
/// Forces change by ramps at the slew limit; a wanted force that is not finite counts as zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ForceGate {
    limit: f64,
    slew: f64,
    force: f64,
}

impl ForceGate {
    /// Creates a gate at zero force.
    ///
    /// # Errors
    /// If `limit_newtons` (N) or `slew_newtons_per_s` (N/s) is not finite and positive.
    pub fn new(limit_newtons: f64, slew_newtons_per_s: f64) -> Result<Self, LimitError> {
        if !is_limit(limit_newtons) {
            return Err(LimitError::Force(limit_newtons));
        }
        if !is_limit(slew_newtons_per_s) {
            return Err(LimitError::Slew(slew_newtons_per_s));
        }
        Ok(Self { limit: limit_newtons, slew: slew_newtons_per_s, force: 0.0 })
    }

    /// Returns the largest force that passes (N).
    pub const fn limit(&self) -> f64 {
        self.limit
    }

    /// Returns the force nearest to `force` (N) that is allowed one `period` (s) later. A period
    /// that is not positive and finite allows no change.
    ///
    /// # Real-time
    /// A dozen operations; never fails, never panics.
    pub fn apply(&mut self, force: f64, period: f64) -> Gated {
        let finite = force.is_finite();
        // `f64::clamp` passes NaN through, so check finiteness first.
        let wanted = if finite { force } else { 0.0 };
        let target = wanted.clamp(-self.limit, self.limit);
        let change = target - self.force;
        let slewed = self.reach(period) < change.abs();
        self.force = if slewed { self.towards(target, period) } else { target };
        Gated { force: self.force, finite, limited: self.limit < wanted.abs(), slewed }
    }

    /// Returns the force that passed last (N).
    pub const fn force(&self) -> f64 {
        self.force
    }

    /// Continues from `force` (N), which was sent instead and is nearer to zero.
    pub const fn go_on_from(&mut self, force: f64) {
        self.force = force;
    }

    fn reach(&self, period: f64) -> f64 {
        if period.is_finite() && 0.0 < period { self.slew * period } else { 0.0 }
    }

    fn towards(&self, target: f64, period: f64) -> f64 {
        self.force + self.reach(period).copysign(target - self.force)
    }
}

fn is_limit(value: f64) -> bool {
    value.is_finite() && 0.0 < value
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn gate() -> ForceGate {
        ForceGate::new(20.0, 5000.0).unwrap()
    }

    #[test]
    fn what_is_not_finite_ramps_to_zero() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut gate = gate();
            for _ in 0..4 {
                let _warm = gate.apply(12.0, 1e-3);
            }
            let forces = [0; 4].map(|_| gate.apply(bad, 1e-3).force);
            assert_eq!(forces.map(f64::to_bits), [7.0, 2.0, 0.0, 0.0].map(f64::to_bits));
            assert!(!gate.apply(bad, 1e-3).finite);
        }
    }

    #[test]
    fn limits_that_cannot_be_kept_are_refused_with_their_value() {
        assert_eq!(ForceGate::new(0.0, 1.0), Err(LimitError::Force(0.0)));
        assert_eq!(ForceGate::new(1.0, -3.0), Err(LimitError::Slew(-3.0)));
        assert!(ForceGate::new(f64::NAN, 1.0).is_err());
        assert!(ForceGate::new(1.0, f64::INFINITY).is_err());
    }

    proptest! {
        #[test]
        fn whatever_is_wanted_the_limits_are_kept(
            wanted in prop::collection::vec((any::<f64>(), any::<f64>()), 1..50),
        ) {
            let mut gate = gate();
            for (force, period) in wanted {
                let before = gate.force();
                let passed = gate.apply(force, period).force;
                let reach = if period.is_finite() { 5000.0 * period.max(0.0) } else { 0.0 };
                prop_assert!(passed.is_finite() && passed.abs() <= 20.0);
                // One rounding of a sum that is at most 20 N.
                let step = (passed - before).abs();
                prop_assert!(step <= reach + 20.0 * f64::EPSILON, "{step} of {reach}");
            }
        }

        #[test]
        fn in_ordinary_ticks_the_limits_are_kept(
            wanted in prop::collection::vec(-50.0..50.0_f64, 1..200),
        ) {
            let mut gate = gate();
            for force in wanted {
                let before = gate.force();
                let gated = gate.apply(force, 1e-3);
                prop_assert!((gated.force - before).abs() <= 5.0 + 20.0 * f64::EPSILON);
                prop_assert_eq!(gated.limited, 20.0 < force.abs());
                prop_assert!(gated.slewed || gated.force.total_cmp(&force.clamp(-20.0, 20.0)).is_eq());
            }
        }
    }
}
