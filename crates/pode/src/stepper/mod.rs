//! One step of a method. One method per file, each answering the same questions:
//! order, stages, embedded error, dense output, evaluations, what a reset discards.

mod bogacki_shampine;
mod heun;
mod rk4;
mod semi_implicit_euler;

pub use bogacki_shampine::BogackiShampine;
pub use heun::Heun;
pub use rk4::Rk4;
pub use semi_implicit_euler::SemiImplicitEuler;

use core::fmt::Debug;

use crate::dense::Dense;
use crate::state::State;

/// A step that was taken.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Step<S> {
    /// The solution over the step.
    pub dense: Dense<S>,
    /// The derivative at its end, if the method has it: the next step's first stage.
    pub last: Option<S>,
    /// Largest entry of the embedded error estimate; 0 without one.
    pub error: f64,
    /// Evaluations of the derivative.
    pub evaluations: u32,
}

/// A one-step method.
pub trait Stepper: Copy + Default + Debug {
    /// Order of convergence.
    const ORDER: u32;
    /// Most evaluations of the derivative in one step.
    const EVALUATIONS: u32;
    /// Its name on the command line.
    const NAME: &'static str;

    /// Steps from `x0` by `h` [s]; `f(τ, x)` is the derivative at the fraction τ.
    ///
    /// `first` is the derivative at the start, where the step before has left it.
    /// `coords` is the number of leading coordinates in the state.
    fn step<S: State>(
        &self,
        f: impl FnMut(f64, &S) -> S,
        x0: &S,
        first: Option<&S>,
        h: f64,
        coords: usize,
    ) -> Step<S>;
}
