//! The input inside a tick: a measured motion, as a function of θ.

mod reconstruct;

pub use reconstruct::{Cubic, Reconstruction, Reconstructor};

/// A measured motion with its rates.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Motion {
    /// s, in the unit of the model's input.
    pub position: f64,
    /// s' (1/s).
    pub rate: f64,
    /// s'' (1/s²).
    pub acceleration: f64,
    /// s''' (1/s³).
    pub jerk: f64,
}

impl Motion {
    /// Largest magnitudes over the `dt` (s) that follow, if the jerk stays as it is.
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
    /// The input at `theta`.
    fn at(&self, theta: f64) -> I;

    /// Largest magnitudes of the input's entries between two places of the tick; `None` where
    /// they are not known. A step under an input without bounds is not certain as soon as a
    /// guard depends on that input.
    fn bound(&self, _from: f64, _to: f64) -> Option<I> {
        None
    }

    /// Writes the input at `theta` + `span` τ as a power series in τ, one entry of `out` for each
    /// power; returns `false` where it has none. Of a [`Motion`] only the positions are asked for.
    fn series(&self, _theta: f64, _span: f64, _out: &mut [I]) -> bool {
        false
    }
}

impl<I, F: Fn(f64) -> I> Signal<I> for F {
    #[inline]
    fn at(&self, theta: f64) -> I {
        self(theta)
    }
}
