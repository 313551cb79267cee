//! One step of a method. One method per file, each answering the same questions:
//! order, stages, embedded error, dense output, evaluations, what a reset discards.

mod adams_bashforth2;
mod adams_bashforth3;
mod any;
mod bogacki_shampine;
mod by_need;
mod controlled;
mod dop853;
mod exact;
mod explicit_euler;
mod field;
mod heun;
mod history;
mod linear_implicit_midpoint;
mod memory;
mod newmark;
mod rk4;
mod rodas3;
mod rosenbrock;
mod semi_implicit_euler;
mod shifted;
mod time_slope;
mod tsitouras5;
mod velocity_verlet;

pub use adams_bashforth2::AdamsBashforth2;
pub use adams_bashforth3::AdamsBashforth3;
pub use any::{Any, AnyDense, AnyMemory, Fits};
pub use bogacki_shampine::BogackiShampine;
pub use by_need::{ByNeed, Choice, MENU, NeededMethod, Offer};
pub use controlled::{Control, Controlled, Tolerance};
pub use dop853::{Dense8, Dop853};
pub use exact::{Exact, Flow, FlowOrCubic, RoundingCarry};
pub use explicit_euler::ExplicitEuler;
pub use field::{Field, Given};
pub(crate) use field::{differences, unit_differences};
pub use heun::Heun;
pub use history::DerivativeHistory;
pub use linear_implicit_midpoint::LinearImplicitMidpoint;
pub use memory::{EndDerivative, Memory};
pub use newmark::{Newmark, NewmarkMemory};
pub use rk4::Rk4;
pub use rodas3::Rodas3;
pub use semi_implicit_euler::SemiImplicitEuler;
pub use tsitouras5::Tsitouras5;
pub use velocity_verlet::VelocityVerlet;

use core::fmt::Debug;

use crate::dense::Dense;
use crate::nature::Nature;
use crate::quadrature::HIGH;
use crate::state::State;

/// Integral of powers over a step, in an energy audit.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum PowerRule {
    /// Simpson's rule, which looks into the middle of the step.
    Simpson,
    /// The trapezoidal rule: enough for a method of order 2 with even steps, where its errors cancel.
    /// `absorbed` (J) is the loss in the step that its ends do not show.
    Trapezoid { absorbed: f64 },
}

/// A step that was taken.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Step<S, D> {
    pub dense: D,
    pub powers: PowerRule,
    /// The embedded estimate of the end's error, entry by entry; zero without one.
    pub error: S,
    /// Whether the step is good enough; one that is not is taken again, shorter.
    pub is_accepted: bool,
}

impl<S: State, D> Step<S, D> {
    /// A step without an error estimate.
    #[inline]
    pub const fn new(dense: D) -> Self {
        Self { dense, powers: PowerRule::Simpson, error: S::ZERO, is_accepted: true }
    }

    #[inline]
    pub(crate) fn map<E>(self, form: impl FnOnce(D) -> E) -> Step<S, E> {
        let Self { dense, powers, error, is_accepted } = self;
        Step { dense: form(dense), powers, error, is_accepted }
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
    const ORDER: u32;
    /// Order of the dense output where a crossing is looked for.
    const DENSE: u32 = Self::ORDER;
    /// Most evaluations of the derivative in one step, those for the Jacobian apart.
    const EVALUATIONS: u32;
    /// Most evaluations of the derivative in one [`refine`](Self::refine).
    const REFINEMENT: u32 = 0;
    /// Most evaluations of the Jacobian in one step.
    const JACOBIANS: u32 = 0;
    const NAME: &'static str;

    /// What it carries from one step to the next.
    type Memory<S: State>: Memory;
    type Dense<S: State>: Dense<S> + Copy + PartialEq + Send;

    /// Steps from `x0` by `h` (s).
    fn step<S: State>(
        &self,
        field: &mut impl Field<S>,
        x0: &S,
        memory: &mut Self::Memory<S>,
        h: f64,
    ) -> Step<S, Self::Dense<S>>;

    /// Brings the dense output of the step just taken to its full order, where that costs
    /// evaluations of its own: asked for only where the inside of a step is looked at.
    #[inline]
    fn refine<S: State>(
        &self,
        _field: &mut impl Field<S>,
        _memory: &Self::Memory<S>,
        _dense: &mut Self::Dense<S>,
        _h: f64,
    ) {
    }

    /// Returns `true` if steps end behind expected events: the end's order exceeds the inside's.
    #[inline]
    fn aims(&self, _nature: &Nature) -> bool {
        Self::DENSE < Self::ORDER
    }

    /// Whether the dense output is so smooth that Simpson's rule would lose what it has gained.
    #[inline]
    fn is_smooth_inside(&self) -> bool {
        Self::DENSE >= HIGH
    }

    /// Whether the parts of a mode, in a state with `entries` entries, are stepped apart.
    ///
    /// A part's step does arithmetic with the whole state, and its dense output is merged with the
    /// others': 1.5 times the time of one step for all of the paper's key and hammer. It pays where
    /// evaluations cost more, or where each part gets a method of its own.
    #[inline]
    fn steps_apart(&self, entries: usize) -> bool {
        /// Most entries of a state whose derivative costs less than a step beside it.
        const SMALL: usize = 8;
        entries > SMALL
    }

    /// Whether modes in mechanical form are stepped in it, with all their parts together.
    #[inline]
    fn is_mechanical(&self) -> bool {
        false
    }

    /// Longest step (s) in a mode of this `nature`, where the model itself asks for `own`.
    #[inline]
    fn longest_step(&self, _nature: &Nature, own: f64) -> f64 {
        own
    }
}
