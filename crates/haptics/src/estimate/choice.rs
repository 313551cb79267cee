use super::Levant;
use super::{AdaptiveWindow, BackwardDifference, Estimator, FilteredDifference, Kalman, KeyMotion};

/// Estimators that scenes and commands choose by name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum EstimatorName {
    /// Kalman filter of position, velocity and acceleration.
    Kalman,
    BackwardDifference,
    FilteredDifference,
    AdaptiveWindow,
    /// Sliding-mode differentiator, for keys of bounded jerk.
    Levant,
}

impl EstimatorName {
    /// Every estimator, the default first.
    pub const ALL: [Self; 5] = [
        Self::Kalman,
        Self::BackwardDifference,
        Self::FilteredDifference,
        Self::AdaptiveWindow,
        Self::Levant,
    ];

    pub const fn name(self) -> &'static str {
        match self {
            Self::Kalman => "kalman",
            Self::BackwardDifference => "backward-difference",
            Self::FilteredDifference => "filtered-difference",
            Self::AdaptiveWindow => "adaptive-window",
            Self::Levant => "levant",
        }
    }
}

/// Constants of estimators; each uses those that it needs.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct EstimatorSettings {
    /// Regular time between samples (s).
    pub period: f64,
    /// Displacement of one count (m).
    pub quantum: f64,
    /// Power density of the key's jerk (m²/s⁵), see [`Kalman::new`].
    pub jerk_density: f64,
    /// Cutoff of the low pass (Hz), see [`FilteredDifference::new`].
    pub cutoff: f64,
    /// Largest jerk (m/s³), see [`Levant::new`].
    pub jerk_limit: f64,
}

impl EstimatorSettings {
    /// Cutoff above the frequencies of a finger's motion (Hz).
    pub const KEY_CUTOFF: f64 = 100.0;

    /// Jerk of a key that is struck (m/s³): 100 m/s² within 5 ms (estimate).
    pub const KEY_JERK_LIMIT: f64 = 2e4;
}

/// An estimator of any kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AnyEstimator {
    Kalman(Kalman),
    BackwardDifference(BackwardDifference),
    FilteredDifference(FilteredDifference),
    AdaptiveWindow(AdaptiveWindow),
    Levant(Levant),
}

impl AnyEstimator {
    /// Creates the estimator called `name`, at rest at zero.
    ///
    /// # Panics
    /// Unless all constants that it needs are finite and positive.
    pub fn new(name: EstimatorName, settings: &EstimatorSettings) -> Self {
        let EstimatorSettings { period, quantum, jerk_density, cutoff, jerk_limit } = *settings;
        match name {
            EstimatorName::Kalman => Self::Kalman(Kalman::new(period, quantum, jerk_density)),
            EstimatorName::BackwardDifference => {
                Self::BackwardDifference(BackwardDifference::new(period))
            }
            EstimatorName::FilteredDifference => {
                Self::FilteredDifference(FilteredDifference::new(cutoff))
            }
            EstimatorName::AdaptiveWindow => Self::AdaptiveWindow(AdaptiveWindow::new(quantum)),
            EstimatorName::Levant => Self::Levant(Levant::new(jerk_limit)),
        }
    }
}

impl AnyEstimator {
    /// Sets the steps of measured speeds to `step` (m/s).
    #[must_use]
    pub fn with_measured_speed(self, step: f64) -> Self {
        if let Self::Kalman(it) = self { Self::Kalman(it.with_measured_speed(step)) } else { self }
    }
}

impl Estimator for AnyEstimator {
    #[inline]
    fn update(&mut self, position: f64, elapsed: f64) -> KeyMotion {
        match self {
            Self::Kalman(it) => it.update(position, elapsed),
            Self::BackwardDifference(it) => it.update(position, elapsed),
            Self::FilteredDifference(it) => it.update(position, elapsed),
            Self::AdaptiveWindow(it) => it.update(position, elapsed),
            Self::Levant(it) => it.update(position, elapsed),
        }
    }

    #[inline]
    fn update_with_speed(&mut self, position: f64, velocity: f64, elapsed: f64) -> KeyMotion {
        match self {
            Self::Kalman(it) => it.update_with_speed(position, velocity, elapsed),
            Self::BackwardDifference(it) => it.update_with_speed(position, velocity, elapsed),
            Self::FilteredDifference(it) => it.update_with_speed(position, velocity, elapsed),
            Self::AdaptiveWindow(it) => it.update_with_speed(position, velocity, elapsed),
            Self::Levant(it) => it.update_with_speed(position, velocity, elapsed),
        }
    }

    fn reset(&mut self, position: f64) {
        match self {
            Self::Kalman(it) => it.reset(position),
            Self::BackwardDifference(it) => it.reset(position),
            Self::FilteredDifference(it) => it.reset(position),
            Self::AdaptiveWindow(it) => it.reset(position),
            Self::Levant(it) => it.reset(position),
        }
    }
}
