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

/// An input over one tick, as a function of θ in 0 ..= 1.
pub trait Signal<I> {
    /// The input at `theta`.
    fn at(&self, theta: f64) -> I;
}

impl<I, F: Fn(f64) -> I> Signal<I> for F {
    #[inline]
    fn at(&self, theta: f64) -> I {
        self(theta)
    }
}
