//! Estimates position, velocity and acceleration from quantised positions.
//!
//! An estimator receives positions and the times between them, which are a period unless samples
//! were lost, late or skipped. It trusts every position and every measured speed. Extrapolation
//! beyond the newest sample is the caller's task.

mod adaptive_window;
mod backward_difference;
mod choice;
mod filtered_difference;
mod kalman;
mod levant;

pub use adaptive_window::AdaptiveWindow;
pub use backward_difference::BackwardDifference;
pub use choice::{AnyEstimator, EstimatorName, EstimatorSettings};
pub use filtered_difference::FilteredDifference;
pub use kalman::Kalman;
pub use levant::Levant;

/// Motion of a key's front at the latest sample, down positive (m, m/s, m/s²).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct KeyMotion {
    pub position: f64,
    pub velocity: f64,
    pub acceleration: f64,
}

impl KeyMotion {
    /// Returns rest at `position` (m).
    #[must_use]
    pub const fn at_rest(position: f64) -> Self {
        Self { position, velocity: 0.0, acceleration: 0.0 }
    }

    /// Returns the motion `t` (s) later under constant acceleration.
    #[must_use]
    pub fn after(&self, t: f64) -> Self {
        let Self { position, velocity, acceleration } = *self;
        Self {
            position: position + t * (velocity + 0.5 * t * acceleration),
            velocity: velocity + t * acceleration,
            acceleration,
        }
    }
}

/// Estimates motion from positions, regularly one per period.
pub trait Estimator {
    /// Accepts the next measured position (m), finite, `elapsed` (s), above 0, after the previous
    /// one; returns the motion at that sample.
    ///
    /// # Real-time
    /// A bounded number of operations; no allocation.
    fn update(&mut self, position: f64, elapsed: f64) -> KeyMotion;

    /// Like [`Self::update`], but with the speed (m/s) that was measured at the position.
    fn update_with_speed(&mut self, position: f64, velocity: f64, elapsed: f64) -> KeyMotion {
        KeyMotion { velocity, ..self.update(position, elapsed) }
    }

    /// Forgets the past: the key rests at `position` (m).
    fn reset(&mut self, position: f64);
}

/// Rejects an invalid constant.
///
/// # Panics
/// Unless `value` is finite and positive: a bug in the caller's set-up.
#[track_caller]
fn assert_positive(value: f64, name: &str) {
    assert!(value.is_finite() && 0.0 < value, "{name} must be finite and positive, got {value}");
}
