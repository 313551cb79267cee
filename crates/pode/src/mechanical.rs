//! Steps of modes in mechanical form: M(q) u' = Q(q, u, z), with slopes of the forces.

use crate::dense::Cubic;

/// Maximum number of generalised speeds of a mechanical form.
pub const MAX_SPEEDS: usize = 8;

/// A step in mechanical form, before it is taken. See [`Newmark`](crate::stepper::Newmark).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct MechanicalStep {
    /// Length (s).
    pub h: f64,
    /// Accelerations that predict the step, one for each speed.
    pub acceleration: [f64; MAX_SPEEDS],
}

/// A step in mechanical form that was taken.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct MechanicalEnd<S> {
    pub dense: Cubic<S>,
    pub acceleration: [f64; MAX_SPEEDS],
    /// Largest force of an element that the correction moved (N).
    pub error: f64,
    /// Closed contacts, but for one that is followed apart.
    pub contact: Option<PressedContact>,
    /// Energy (J) that a contact followed apart absorbed, beyond what the powers at the ends show.
    pub absorbed: f64,
}

/// A step in mechanical form, or the reason why it must be shorter.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum MechanicalOutcome<S> {
    End(MechanicalEnd<S>),
    /// A contact that is followed apart opens inside the step: it must end `after` (s).
    Opens {
        after: f64,
    },
}

/// Closed contacts in a step.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PressedContact {
    /// Force that the correction moved (N).
    pub error: f64,
    /// Fastest rate (rad/s).
    pub rate: f64,
}

/// A model with modes in mechanical form.
pub trait Mechanical<M, S, I> {
    /// Whether `mode` has a mechanical form, and is not so slow that another method suits it better.
    fn suits(&self, mode: M) -> bool;

    /// Returns the acceleration of each speed at `x`, without a contact that is followed apart; `None`
    /// in a mode that it does not suit.
    fn acceleration(&self, mode: M, x: &S, input: &I) -> Option<[f64; MAX_SPEEDS]>;

    /// Takes a step from `x`, with the input at the step's end; `None` in a mode that it does not
    /// suit.
    ///
    /// # Real-time
    /// Bounded: three functions of the mode, and one of each closed contact; of one that is followed
    /// apart, its law at most 512 times.
    fn step(
        &self,
        mode: M,
        x: &S,
        input: &I,
        step: &MechanicalStep,
    ) -> Option<MechanicalOutcome<S>>;
}
