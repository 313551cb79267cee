//! Compensation of the device's own inertia, friction and weight.

use crate::estimate::KeyMotion;
use crate::plant::KeyParameters;

/// Speed at which half of the dry friction is compensated (m/s), above the noise of its estimate.
const SLIDING: f64 = 5e-3;

/// A force that cancels part of a key's own mechanics.
///
/// The motor compensates by an estimate that is late. It generates energy where the estimate is
/// wrong, so the loop is stable only with a smaller action.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeviceCompensation {
    key: KeyParameters,
    /// Compensated fractions of inertia, and of friction, damping and weight.
    inertia: f64,
    losses: f64,
}

impl DeviceCompensation {
    /// Compensates the fraction `inertia` of the mass of `key`, and `losses` of its dry friction,
    /// damping and weight, each `0 ..= 1`.
    pub const fn new(key: KeyParameters, inertia: f64, losses: f64) -> Self {
        Self { key, inertia, losses }
    }

    /// Returns the force on the finger, up positive, for a motion of the key (N).
    ///
    /// # Real-time
    /// A dozen operations.
    pub fn force(&self, motion: &KeyMotion) -> f64 {
        let KeyParameters { mass, damping, coulomb, weight, .. } = self.key;
        let KeyMotion { velocity, acceleration, .. } = *motion;
        let friction = coulomb * velocity / (velocity.abs() + SLIDING);
        let lost = damping * velocity + friction + weight;
        -self.inertia * mass * acceleration - self.losses * lost
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plant::RigParameters;

    #[test]
    fn a_whole_compensation_is_what_the_key_itself_resists_with() {
        let key = RigParameters::default().key;
        let motion = KeyMotion { position: 3e-3, velocity: 2.0, acceleration: -7.0 };
        let force = DeviceCompensation::new(key, 1.0, 1.0).force(&motion);
        let resistance = key.mass * -7.0 + key.damping * 2.0 + key.coulomb + key.weight;
        // The missing share of the dry friction at 2 m/s.
        assert!((force + resistance).abs() < key.coulomb * SLIDING / 2.0, "{force}");
        assert!(DeviceCompensation::new(key, 0.0, 0.0).force(&motion).abs() < f64::EPSILON);
    }
}
