//! One step of a method. One method per file, each answering the same questions:
//! order, stages, embedded error, dense output, evaluations, what a reset discards.

mod bogacki_shampine;
mod controlled;
mod dop853;
mod exact;
mod field;
mod heun;
mod memory;
mod rk4;
mod semi_implicit_euler;

pub use bogacki_shampine::BogackiShampine;
pub use controlled::{Control, Controlled, Tolerance};
pub use dop853::{Dense8, Dop853};
pub use exact::{Either, Exact, Flow};
pub use field::{Field, Given};
pub(crate) use field::{differences, unit_differences};
pub use heun::Heun;
pub use memory::{Memory, Slope};
pub use rk4::Rk4;
pub use semi_implicit_euler::SemiImplicitEuler;

use core::fmt::Debug;

use crate::dense::Dense;
use crate::nature::Nature;
use crate::state::State;

/// A step that was taken.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Step<S, D> {
    /// The solution over the step.
    pub dense: D,
    /// The embedded estimate of the end's error, entry by entry; zero without one.
    pub error: S,
    /// Whether the step is good enough; one that is not is taken again, shorter.
    pub is_accepted: bool,
}

impl<S: State, D> Step<S, D> {
    /// A step without an error estimate.
    #[inline]
    pub const fn new(dense: D) -> Self {
        Self { dense, error: S::ZERO, is_accepted: true }
    }

    /// The same with an estimate of the end's error, entry by entry.
    #[inline]
    #[must_use]
    pub fn with_error(self, error: S) -> Self {
        Self { error, ..self }
    }
}

/// A method that takes one step at a time.
pub trait Stepper: Copy + Default + Debug + PartialEq {
    /// Order of convergence.
    const ORDER: u32;
    /// Order of the dense output where a crossing is looked for.
    const DENSE: u32 = Self::ORDER;
    /// Most evaluations of the derivative in one step, those for the Jacobian apart.
    const EVALUATIONS: u32;
    /// Its name on the command line.
    const NAME: &'static str;

    /// What it carries from one step to the next.
    type Memory<S: State>: Memory;
    /// Its dense output.
    type Dense<S: State>: Dense<S> + Copy + PartialEq;

    /// Steps from `x0` by `h` [s].
    fn step<S: State>(
        &self,
        field: &mut impl Field<S>,
        x0: &S,
        memory: &mut Self::Memory<S>,
        h: f64,
    ) -> Step<S, Self::Dense<S>>;

    /// Brings the dense output of the step just taken to its full order, where that costs
    /// evaluations of its own: asked for only where a crossing is looked for inside.
    #[inline]
    fn refine<S: State>(&self, _field: &mut impl Field<S>, _dense: &mut Self::Dense<S>, _h: f64) {}

    /// Longest step [s] in a mode of this `nature`, where the model itself asks for `own`.
    #[inline]
    fn longest_step(&self, _nature: &Nature, own: f64) -> f64 {
        own
    }
}
