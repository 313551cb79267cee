//! Force between two frames: F0 + K (s0 − s) + B (s0' − s'); s0 moves at s0' for a limited time.

use firmware_protocol::acyclic::arm::PATH_US;
use firmware_protocol::frame::key_forces::{KeyForces, KeySlopes};
use firmware_protocol::frame::key_samples::KeySamples;
use firmware_protocol::quantity::Millinewtons;

use crate::calibration;

#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(super) struct Law {
    /// Force at the position and velocity, F0 (N).
    force: f64,
    /// Stiffness of the force, K (N/m).
    stiffness: f64,
    /// Damping of the force, B (N s/m).
    damping: f64,
    /// Position of the samples, s0 (m).
    position: f64,
    /// Velocity of the samples, s0' (m/s).
    velocity: f64,
    taken_us: u64,
}

impl Law {
    /// Returns the law of the key in `slot` in `frame`, which answers `samples`.
    ///
    /// `quantum` is the size of a count (m). The flag "no force" concerns all keys of a frame.
    pub(super) fn answering(
        frame: &KeyForces,
        samples: &KeySamples,
        slot: usize,
        quantum: f64,
        taken_us: u64,
    ) -> Self {
        let Some(force) = frame.forces.as_slice().get(slot) else { return Self::default() };
        if frame.header.flag {
            return Self::default();
        }
        let slopes = frame.slopes.as_slice().get(slot).copied().unwrap_or_default();
        let counts = samples.positions.as_slice().get(slot).copied().unwrap_or_default();
        let speed = samples.velocities.as_slice().get(slot).copied().unwrap_or_default();
        let here = (f64::from(counts.get()) * quantum, calibration::metres_per_second(speed));
        Self::here(*force, slopes, here, taken_us)
    }

    /// Returns the law of a force that holds at a position (m) and velocity (m/s) of `now_us`.
    pub(super) fn here(
        force: Millinewtons,
        slopes: KeySlopes,
        (position, velocity): (f64, f64),
        taken_us: u64,
    ) -> Self {
        let (stiffness, damping) = calibration::slopes(slopes);
        let force = calibration::newtons(force);
        Self { force, stiffness, damping, position, velocity, taken_us }
    }

    /// Returns `true` if the force does not depend on the key's motion.
    pub(super) const fn is_held(&self) -> bool {
        self.stiffness.abs() == 0.0 && self.damping.abs() == 0.0
    }

    /// Returns the force (N) at `now_us` on a key at `position` (m) with `velocity` (m/s).
    pub(super) fn force(&self, now_us: u64, (position, velocity): (f64, f64)) -> f64 {
        let along_us = now_us.saturating_sub(self.taken_us).min(PATH_US.into());
        let expected = self.position + self.velocity * (along_us as f64 * 1e-6);
        self.force
            + self.stiffness * (expected - position)
            + self.damping * (self.velocity - velocity)
    }
}
