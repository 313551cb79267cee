//! Compliant contacts and dry friction beside the structural mode: thirteen contacts are
//! thirteen guards, not 8192 modes.
//!
//! Each contact is an automaton of its own, and so is each friction. [`ContactSystem`]
//! describes the mechanism, and [`WithContacts`] is the whole model; its mode is a
//! [`ContactMode`], the structural mode and one [`ContactState`] for each contact:
//!
//! | state | holds while | ends where | next |
//! |---|---|---|---|
//! | `Open` | gap > 0 | gap = 0 | `Closed`; with friction, a slide, or `Stick` |
//! | `Closed` and below | gap < 0 | gap = 0 | `Open`, and its friction with it |
//! | `Stick` | slip = 0, force < stiction | force = stiction | the slide against the force |
//! | | | the input tears it off by a jump | the slide that it was torn into |
//! | `SlideUp`, `SlideDown` | slip > 0, or < 0 | slip = 0 | `Stick` if that holds; else it goes on, or back |
//!
//! A bearing has a friction and no gap: it never opens.
//!
//! # Friction
//!
//! Friction forces λ enter the equations linearly, and each slip speed is a function of the
//! state:
//!
//! ```text
//! x' = f(x, u) + Σ λ_k r_k(x, u)        derivative, and responses
//! s_k = s_k(x, u)                        slip speeds
//! λ_k = −sign(s_k) μ_k N_k               where it slides
//! s_k' = 0                               where it sticks, all of them together
//! ```
//!
//! The last line is a linear system of one row for each contact that sticks, [`MAX_FRICTIONS`]
//! at most; its matrix is symmetric. Where several contacts hold the same motion, the forces
//! are not unique: of all that hold, those with the least sum of squares act. A stick ends
//! where its force comes to its limit, by the guard limit² − force², which is smooth, or where
//! others have taken from its force what it could move. The state is kept at slip speed zero
//! by a move along the responses, so that nothing accumulates.
//!
//! # Changes at one instant
//!
//! They happen one after another, each with what it changes for the others taken into account:
//! first the structure's own guards by their priority, then contacts that open or close, then
//! frictions; among contacts, and among frictions, the lower number goes first. Each change
//! counts to [`Limits::cascade`](crate::Limits::cascade): thirteen contacts that close at once
//! need a cascade of thirteen.
//!
//! Frictions that are at slip speed zero when one of them changes are one change: of those that
//! stick and cannot hold, or slide and are drawn back, the one with the lowest number is
//! revised until there is none, four times per contact at most, as in the least-index pivoting
//! of complementarity problems. What is not consistent then is left to the guards, and to the
//! limits on events.
//!
//! # Work
//!
//! An open contact costs the evaluation of its gap where guards are taken, and nothing in the
//! derivative. A derivative costs one [`ContactSystem::derivative`], to which only the closed
//! contacts are given, one [`FrictionalContacts::response`] and [`FrictionalContacts::friction`]
//! for each contact that slides, and one response and [`FrictionalContacts::slip`] for each that
//! sticks. The
//! guard of a slide costs one derivative and that of a stick three, which
//! [`Work`](crate::Work) counts as one guard each; a change of n frictions at one instant costs
//! at most 16 n² derivatives.
//!
//! # Beside [`filippov`](crate::filippov)
//!
//! A bearing with the response ½ (f₋ − f₊), the derivative ½ (f₋ + f₊) and a stiction of 1 is
//! Filippov's surface where that attracts or is crossed, and both share the description of a
//! [`Surface`](crate::filippov::Surface). Here many surfaces live together, with further guards;
//! there both sides may be any equations, and a surface may repel.
//!
//! # What is not here
//!
//! Rigid contacts are guards and reset maps of the structure, whose impulses [`restitution`]
//! finds, not automata. Friction in a plane: the
//! slip has one direction. Normal forces that depend on the friction itself.
//!
//! # References
//! `[Fil88]` §4 for the slide, `[DL09]` for its end, `[PG96]` for several
//! contacts at once, `[Mur74]` for the pivoting.

mod energy;
mod forces;
mod grip;
mod guards;
mod model;
mod point;
mod resets;
mod set;
mod slopes;
mod solve;
mod spec;
mod system;

pub mod restitution;

pub use energy::EnergeticContacts;
pub use forces::FrictionForces;
pub use guards::TooManyGuards;
pub use set::{ContactIndices, ContactSet, ContactState, IndexIter, MAX_CONTACTS};
pub use spec::{ContactGuard, ContactSpec, FrictionSpec, MAX_FRICTIONS};
pub use system::{ContactSystem, FrictionLimits, FrictionalContacts, GuardedContacts};

use guards::GuardList;
use point::ContactPoint;

/// The structural mode, and beside it what each contact does.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ContactMode<S> {
    /// The mode of the structure.
    pub structure: S,
    /// The states of the contacts.
    pub contacts: ContactSet,
}

/// A mechanism with contacts as a model with the modes [`ContactMode`].
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct WithContacts<M> {
    system: M,
    guards: GuardList,
}

impl<M: GuardedContacts> WithContacts<M> {
    /// Makes a model of `system`, with the contacts that it has now.
    ///
    /// # Errors
    /// More contacts, frictions or guards than one model can have.
    pub fn new(system: M) -> Result<Self, TooManyGuards> {
        let guards = GuardList::of(&system)?;
        Ok(Self { system, guards })
    }

    /// Returns the mechanism of which this is the model.
    pub const fn system(&self) -> &M {
        &self.system
    }

    /// Returns the friction forces as they are in `mode` (N).
    pub fn friction_forces(
        &self,
        mode: ContactMode<M::Structure>,
        x: &M::State,
        input: &M::Input,
    ) -> FrictionForces {
        self.point(mode, x, input).forces()
    }

    const fn point<'a>(
        &'a self,
        mode: ContactMode<M::Structure>,
        x: &'a M::State,
        input: &'a M::Input,
    ) -> ContactPoint<'a, M> {
        ContactPoint { system: &self.system, mode, x, input }
    }
}
