//! What a modeller implements: two sides and the surface between them.

use core::fmt::Debug;

use crate::filippov::Continued;
use crate::nature::Nature;
use crate::state::State;

/// A side of the surface.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SurfaceSide {
    /// Where the surface function is positive.
    Above,
    /// Where it is negative.
    Below,
}

impl SurfaceSide {
    /// The sign of the surface function there.
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
    /// The side on which they hold.
    pub side: SurfaceSide,
    /// Whether the state is on the surface and the question is what can keep it there: with
    /// friction, the static limit towards this side. Otherwise the state moves freely.
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
    /// The rate of h along the derivative `flow` (1/s).
    pub fn rate(&self, flow: &S) -> f64 {
        self.slope(flow) + self.drift
    }

    /// The rate of h along `direction` at a fixed time.
    pub fn slope(&self, direction: &S) -> f64 {
        let pairs = self.gradient.entries().iter().zip(direction.entries());
        pairs.map(|(a, b)| a * b).sum()
    }
}

/// A system with equations on either side of a surface, h(x, u) = 0.
///
/// Each side's equations are asked for a little beyond the surface too, within a step: they
/// go on there as if the surface were not, and never look at the sign of h.
pub trait Sided {
    /// Coordinates, then speeds.
    type State: State;
    /// What drives the system.
    type Input: Continued;

    /// How many leading entries of the state are coordinates.
    const COORDS: usize;
    /// Typical size of h's terms, in its own unit.
    const SIZE: f64;
    /// Typical size of the one-sided rates of h (1/s).
    const RATE: f64;
    /// Largest jump of the surface, where the input jumps, that a sliding state follows.
    ///
    /// A larger one tears it off, onto a side. An input that is put together from samples
    /// jumps a little at each tick, where the real one went on: say how much that can be.
    const SLACK: f64 = Self::SIZE / 64.0;

    /// Returns the derivative of `x` on `branch`.
    fn derivative(&self, branch: Branch, x: &Self::State, input: &Self::Input) -> Self::State;

    /// Returns the readout on `branch`.
    fn readout(&self, branch: Branch, x: &Self::State, input: &Self::Input) -> f64;

    /// Returns the surface function with its derivatives.
    fn surface(&self, x: &Self::State, input: &Self::Input) -> Surface<Self::State>;

    /// Returns what is constant on a side; both longest steps hold along the surface too.
    fn nature(&self, _side: SurfaceSide) -> Nature {
        Nature::default()
    }
}
