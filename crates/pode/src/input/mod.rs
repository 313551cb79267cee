//! The input inside a tick: a measured motion as a function of θ.

mod reconstruct;

pub use reconstruct::{Cubic, Reconstruction, Reconstructor};

/// A measured motion with its rates.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Motion {
    /// s, in the model's unit of length or angle.
    pub position: f64,
    /// s' (1/s).
    pub rate: f64,
    /// s'' (1/s²).
    pub acceleration: f64,
    /// s''' (1/s³).
    pub jerk: f64,
}

impl Motion {
    /// Returns the largest magnitudes over the next `dt` (s) at constant jerk.
    #[inline]
    #[must_use]
    pub const fn bound_over(&self, dt: f64) -> Self {
        let jerk = self.jerk.abs();
        let acceleration = self.acceleration.abs();
        let rate = self.rate.abs();
        Self {
            position: self.position.abs()
                + dt * (rate + dt * (0.5 * acceleration + dt * jerk * (1.0 / 6.0))),
            rate: rate + dt * (acceleration + 0.5 * dt * jerk),
            acceleration: acceleration + dt * jerk,
            jerk,
        }
    }
}

/// An input over one tick, as a function of θ in 0 ..= 1.
pub trait Signal<I> {
    fn at(&self, theta: f64) -> I;

    /// Returns the largest magnitudes of the input's entries between two places of the tick; `None`
    /// if unknown. Without them no step is certain if a guard depends on the input.
    fn bound(&self, _from: f64, _to: f64) -> Option<I> {
        None
    }
}

impl<I, F: Fn(f64) -> I> Signal<I> for F {
    #[inline]
    fn at(&self, theta: f64) -> I {
        self(theta)
    }
}
