//! Compliant contacts and dry friction beside the structural mode: thirteen contacts are
//! thirteen guards, not 8192 modes.
//!
//! Each contact and each friction is an automaton of its own. [`ContactSystem`] describes the
//! mechanism, [`WithContacts`] is the whole model, and its mode is a [`ContactMode`]: the
//! structural mode and one [`ContactState`] for each contact:
//!
//! | state | holds while | ends where | next |
//! |---|---|---|---|
//! | `Open` | gap > 0 | gap = 0 | `Closed`; with friction, a slide, or `Stick` |
//! | `Closed` and below | gap < 0 | gap = 0 | `Open`, and its friction with it |
//! | `Stick` | slip = 0, force < stiction | force = stiction | the slide against the force |
//! | | | a jump of the input tears it off | the slide into which it is torn |
//! | `SlideUp`, `SlideDown` | slip > 0, or < 0 | slip = 0 | `Stick` if it holds; else on, or back |
//!
//! A bearing has a friction and no gap: it never opens.
//!
//! # Friction
//!
//! Friction forces λ enter the equations linearly; slip speeds are functions of the state:
//!
//! ```text
//! x' = f(x, u) + Σ λ_k r_k(x, u)        derivative, and responses
//! s_k = s_k(x, u)                        slip speeds
//! λ_k = −sign(s_k) μ_k N_k               where it slides
//! s_k' = 0                               where it sticks, all of them together
//! ```
//!
//! The last line is a symmetric linear system with one row for each sticking contact,
//! [`MAX_FRICTIONS`] at most. Where several contacts hold the same motion, the forces are not
//! unique: those with the least sum of squares act. A stick ends where its force reaches its limit,
//! by the smooth guard limit² − force², or where others have taken away from its force what it
//! could move. A move along the responses keeps the state at slip speed zero, so no error
//! accumulates.
//!
//! # Changes at one instant
//!
//! Changes happen one after another, each with the effects of those before: first the structure's
//! own guards by their priority, then contacts that open or close, then frictions; the lower number
//! goes first within each kind. Each change counts to [`Limits::cascade`](crate::Limits::cascade):
//! thirteen contacts that close at once need a cascade of thirteen.
//!
//! All frictions at slip speed zero when one of them changes are one change: of those that stick
//! and cannot hold, or slide and are drawn back, the lowest number is revised until there is none,
//! four times per contact at most, as in the least-index pivoting of complementarity problems. Any
//! remaining inconsistency is left to the guards and to the limits on events.
//!
//! # Work
//!
//! An open contact costs its gap where guards are evaluated, and nothing in the derivative. A
//! derivative costs one [`ContactSystem::derivative`] with the closed contacts only, one
//! [`FrictionalContacts::response`] and [`FrictionalContacts::friction`] for each sliding contact,
//! and one response and [`FrictionalContacts::slip`] for each sticking one. A slide's guard costs
//! one derivative, a stick's three; [`Work`](crate::Work) counts each as one guard. A change of n
//! frictions at one instant costs at most 16 n² derivatives.
//!
//! # Switches
//!
//! A branch of the equations by the sign of a condition c(x, u), with f₊ above and f₋ below, is a
//! bearing as well ([`FrictionSpec::switch`]): the slip is c, the derivative ½ (f₋ + f₊), the
//! response ½ (f₋ − f₊), and both limits are 1. It takes no power. A stick is Filippov's slide, with
//! the force 1 − 2α:
//!
//! ```text
//! x' = (1 − α) f₋ + α f₊,   α = c'₋ / (c'₋ − c'₊),   so that c' = 0
//! ```
//!
//! At c = 0 the rates on both sides decide, and where one is zero, its own derivative:
//!
//! | c'₊ | c'₋ | c = 0 | next |
//! |---|---|---|---|
//! | − | + | attracts | `Stick` |
//! | − | − | is crossed | `SlideDown` |
//! | + | + | is crossed | `SlideUp` |
//! | + | − | repels | the slide along the mean of both; `SlideUp` if that keeps c' = 0 |
//!
//! A stick ends tangentially, with c = c' = 0: the next side departs from there and fires nothing.
//! Where f₊ − f₋ does not change c', as of a force that sets in at a place,
//! [`FrictionalContacts::kept`] is c' with its derivatives: a stick keeps c' = 0 there. It begins
//! where both sides drive the state back to c = 0 within 32 [`FrictionalContacts::MOMENT`], so that
//! a key that rests on a step does not chatter.
//!
//! # What is not here
//!
//! Rigid contacts are not automata: they are guards and reset maps of the structure, with impulses
//! from [`restitution`]. Slip has one direction: no friction in a plane. The normal force of a
//! compliant contact does not depend on the friction itself; that of a rigid one does
//! ([`CoupledFrictions::pressed_by`]).
//!
//! # References
//! `[Fil88]` §4, §10 and §19 for the slide, `[PK08]` for its event functions, `[DL09]` for its end,
//! `[PG96]` for several contacts at once, `[Mur74]` for the pivoting.

mod continued;
mod coupled;
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
mod surface;
mod system;

pub mod restitution;

pub use continued::Continued;
pub use energy::EnergeticContacts;
pub use forces::FrictionForces;
pub use guards::TooManyGuards;
pub use set::{ContactIndices, ContactSet, ContactState, IndexIter, MAX_CONTACTS};
pub use spec::{ContactGuard, ContactSpec, FrictionSpec, MAX_FRICTIONS, SlipKind};
pub use surface::Surface;
pub use system::{
    ContactSystem, CoupledFrictions, FrictionLimits, FrictionalContacts, GuardedContacts,
};

use guards::GuardList;
use point::ContactPoint;

/// The structural mode and the states of all contacts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ContactMode<S> {
    pub structure: S,
    pub contacts: ContactSet,
}

/// A mechanism with contacts as a model with the modes [`ContactMode`].
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct WithContacts<M> {
    system: M,
    guards: GuardList,
}

impl<M: GuardedContacts> WithContacts<M> {
    /// Builds a model of `system` with its present contacts.
    pub fn new(system: M) -> Result<Self, TooManyGuards> {
        let guards = GuardList::of(&system)?;
        Ok(Self { system, guards })
    }

    pub const fn system(&self) -> &M {
        &self.system
    }

    /// Returns the friction forces in `mode` (N).
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
