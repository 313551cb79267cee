//! The modeller's interface: two sides and the surface between them.

use core::fmt::Debug;

use crate::filippov::Continued;
use crate::nature::Nature;
use crate::state::State;

/// A side of the surface.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SurfaceSide {
    Above,
    Below,
}

impl SurfaceSide {
    pub const fn sign(self) -> f64 {
        match self {
            Self::Above => 1.0,
            Self::Below => -1.0,
        }
    }
}

/// One of the sets of equations of a two-sided system.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Branch {
    pub side: SurfaceSide,
    /// `true` for equations that can hold the state on the surface, as stiction; `false` for free.
    pub holds: bool,
}

/// The surface function h at a point.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Surface<S> {
    /// h: positive above, negative below.
    pub value: f64,
    /// ∂h/∂x, entry by entry, not zero.
    pub gradient: S,
    /// ∂h/∂t at a fixed state: how the input moves the surface (1/s).
    pub drift: f64,
}

impl<S: State> Surface<S> {
    /// Returns the rate of h along the derivative `flow` (1/s).
    pub fn rate(&self, flow: &S) -> f64 {
        self.slope(flow) + self.drift
    }

    /// Returns the rate of h along `direction` at a fixed time.
    pub fn slope(&self, direction: &S) -> f64 {
        let pairs = self.gradient.entries().iter().zip(direction.entries());
        pairs.map(|(a, b)| a * b).sum()
    }
}

/// A system with equations on either side of a surface, h(x, u) = 0. They are also evaluated a
/// little beyond it within a step: they continue smoothly there and never test the sign of h.
pub trait Sided {
    type State: State;
    type Input: Continued;

    const COORDS: usize;
    /// Typical size of h's terms, in its own unit.
    const SIZE: f64;
    /// Typical size of the one-sided rates of h (1/s).
    const RATE: f64;
    /// Largest jump of the surface, where the input jumps, that a sliding state follows; a larger
    /// one tears it off, onto a side. For a sampled input declare its largest jump.
    const SLACK: f64 = Self::SIZE / 64.0;

    fn derivative(&self, branch: Branch, x: &Self::State, input: &Self::Input) -> Self::State;

    fn readout(&self, branch: Branch, x: &Self::State, input: &Self::Input) -> f64;

    fn surface(&self, x: &Self::State, input: &Self::Input) -> Surface<Self::State>;

    /// Returns the constants of a side; both longest steps hold along the surface, too.
    fn nature(&self, _side: SurfaceSide) -> Nature {
        Nature::default()
    }
}
