use core::fmt::Debug;

use crate::input::Motion;

/// An input that extrapolates itself by its rates, so that a moving surface has two rates.
pub trait Continued: Copy + PartialEq + Debug + Send {
    /// Returns the input `dt` (s) later, or earlier if negative.
    #[must_use]
    fn after(&self, dt: f64) -> Self;
}

impl Continued for () {
    fn after(&self, _dt: f64) -> Self {}
}

impl Continued for Motion {
    fn after(&self, dt: f64) -> Self {
        let Self { position, rate, acceleration, jerk } = *self;
        Self {
            position: position + dt * (rate + dt * (acceleration / 2.0 + dt * jerk / 6.0)),
            rate: rate + dt * (acceleration + dt * jerk / 2.0),
            acceleration: acceleration + dt * jerk,
            jerk,
        }
    }
}
