//! The traits of a modeller: a mechanism, its frictions, and the guards of its structure.

use core::fmt::Debug;

use crate::contacts::{
    ContactGuard, ContactIndices, ContactMode, ContactSet, ContactSpec, Continued, FrictionForces,
    Surface, WithContacts,
};
use crate::{
    Enclosure, GuardBound, GuardId, GuardSpec, GuardValue, Mechanical, Nature, ReadoutSlopes,
    Reset, State,
};

/// The largest friction forces of a closed contact (N, or N m).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FrictionLimits {
    /// What can hold at slip speed zero: μ_s N.
    pub stiction: f64,
    /// What brakes a slide, not more than that: μ_k N.
    pub kinetic: f64,
}

impl FrictionLimits {
    /// Coulomb's law with one coefficient: `force` at any slip speed (N).
    pub const fn coulomb(force: f64) -> Self {
        Self { stiction: force, kinetic: force }
    }
}

/// A mechanism with compliant contacts and dry frictions.
///
/// Contacts have numbers, from 0, by their place in [`Self::contacts`]. Methods of a contact
/// are also called slightly past its end, within a step: the force there either continues as if the
/// contact still existed, or is zero.
pub trait ContactSystem: Sized {
    type Structure: Copy + Eq + Debug + Send;
    type State: State;
    type Input: Continued;

    const COORDS: usize;

    /// Returns the number of leading coordinates, which may depend on values of the system.
    #[inline]
    fn coordinates(&self) -> usize {
        Self::COORDS
    }

    /// Returns the contacts and bearings; their number may come from a file.
    fn contacts(&self) -> &[ContactSpec];

    /// Returns the gap between a contact's surfaces (m), negative while they press, and its rate.
    fn gap(
        &self,
        structure: Self::Structure,
        contact: usize,
        x: &Self::State,
        input: &Self::Input,
    ) -> GuardValue;

    /// Returns the derivative with the normal forces of the `closed` contacts, without friction.
    fn derivative(
        &self,
        structure: Self::Structure,
        closed: ContactIndices,
        x: &Self::State,
        input: &Self::Input,
    ) -> Self::State;

    /// Returns the readout, with the friction forces as they are (N).
    fn readout(
        &self,
        _structure: Self::Structure,
        _closed: ContactIndices,
        _forces: &FrictionForces,
        _x: &Self::State,
        _input: &Self::Input,
    ) -> f64 {
        0.0
    }

    /// Returns the readout's slopes with these contacts; `None` requests differences.
    fn slopes(
        &self,
        _structure: Self::Structure,
        _contacts: ContactSet,
        _x: &Self::State,
        _input: &Self::Input,
    ) -> Option<ReadoutSlopes> {
        None
    }

    /// Returns the constants with these contacts; only the structure limits projections.
    fn nature(&self, _structure: Self::Structure, _contacts: ContactSet) -> Nature {
        Nature::default()
    }
}

/// Effect of friction forces on each other's limits and on guards, as of normal forces that friction
/// changes; without any, `impl CoupledFrictions for X {}` is enough.
pub trait CoupledFrictions: ContactSystem {
    /// Whether friction forces change the limits of frictions, or guards, in `structure`.
    fn is_coupled(&self, _structure: Self::Structure) -> bool {
        false
    }

    /// Returns what 1 N of the friction of `contact`, in the direction of positive slip, adds to
    /// the limits of another friction, or to a guard of the structure.
    fn pressed_by(
        &self,
        _structure: Self::Structure,
        _contact: usize,
        _pressed: ContactGuard,
        _x: &Self::State,
        _input: &Self::Input,
    ) -> FrictionLimits {
        FrictionLimits::coulomb(0.0)
    }
}

/// Frictions of a mechanism; without any, `impl FrictionalContacts for X {}` is enough.
pub trait FrictionalContacts: CoupledFrictions {
    /// A time (s) of little motion, over which rates of holding forces are differenced.
    const MOMENT: f64 = 1e-6;

    /// Returns the slip speed of a closed contact with friction (m/s), with its derivatives.
    fn slip(
        &self,
        _structure: Self::Structure,
        _contact: usize,
        _x: &Self::State,
        _input: &Self::Input,
    ) -> Surface<Self::State> {
        Surface { value: 0.0, gradient: Self::State::ZERO, drift: 0.0 }
    }

    /// Returns the modes in mechanical form, each without sticking or sliding contacts.
    fn mechanical(
        &self,
    ) -> Option<&dyn Mechanical<ContactMode<Self::Structure>, Self::State, Self::Input>> {
        None
    }

    /// Returns `false` where a friction does not exist in `structure`, so that nothing ends it.
    fn acts(&self, _structure: Self::Structure, _contact: usize) -> bool {
        true
    }

    /// Returns what a stick keeps at zero if the response does not change the slip's rate: that rate.
    fn kept(
        &self,
        _structure: Self::Structure,
        _contact: usize,
        _x: &Self::State,
        _input: &Self::Input,
    ) -> Option<Surface<Self::State>> {
        None
    }

    /// Returns what a friction force of 1 N in the direction of positive slip adds to the
    /// derivative: a matter of `x` alone, since friction enters linearly. Force times slip is a
    /// power, so that the forces act by a symmetric matrix.
    fn response(
        &self,
        _structure: Self::Structure,
        _contact: usize,
        _x: &Self::State,
        _input: &Self::Input,
    ) -> Self::State {
        Self::State::ZERO
    }

    /// Returns the response where other contacts have the states `contacts`: of a switch, whose sides
    /// may depend on those of other switches.
    fn response_among(
        &self,
        structure: Self::Structure,
        _contacts: ContactSet,
        contact: usize,
        x: &Self::State,
        input: &Self::Input,
    ) -> Self::State {
        self.response(structure, contact, x, input)
    }

    /// Returns the largest friction forces (N), not negative. Kinetic may depend on the slip, as an
    /// even function: a step also evaluates it slightly past slip zero, where |s| has a kink.
    fn friction(
        &self,
        _structure: Self::Structure,
        _contact: usize,
        _x: &Self::State,
        _input: &Self::Input,
    ) -> FrictionLimits {
        FrictionLimits::coulomb(0.0)
    }
}

/// What ends a structural mode of a mechanism with contacts, and how far a step may go.
///
/// One with a single structure needs no more than `impl GuardedContacts for X {}`.
pub trait GuardedContacts: FrictionalContacts {
    /// Returns the guards of all structural modes, with ids below 128 and priorities below 64.
    fn structure_guards(&self) -> &[GuardSpec] {
        &[]
    }

    /// Whether a guard of the structure is watched in `structure`.
    fn is_watched(&self, _structure: Self::Structure, _guard: GuardId) -> bool {
        true
    }

    fn structure_guard(
        &self,
        _structure: Self::Structure,
        _guard: GuardId,
        _x: &Self::State,
        _input: &Self::Input,
    ) -> GuardValue {
        GuardValue::new(1.0, 0.0)
    }

    /// Bounds what a gap, a slip speed or a guard of the structure does along a computed orbit, as
    /// [`Guarded::guard_bound`](crate::Guarded::guard_bound) does.
    fn guard_bound(
        &self,
        _structure: Self::Structure,
        _guard: ContactGuard,
        _over: &Enclosure<Self::State, Self::Input>,
    ) -> GuardBound {
        GuardBound::UNKNOWN
    }

    /// Longest step (s) from `x`, as of a hard felt; at most [`Nature::longest_step`].
    fn longest_step_at(
        &self,
        structure: Self::Structure,
        contacts: ContactSet,
        _x: &Self::State,
        _input: &Self::Input,
    ) -> f64 {
        self.nature(structure, contacts).longest_step
    }

    /// Returns `x` with the coordinates that `structure` slaves to the input put in place.
    fn constrain(
        &self,
        _structure: Self::Structure,
        x: &Self::State,
        _input: &Self::Input,
    ) -> Self::State {
        *x
    }

    /// Applies the reset map of a guard of the structure; the contacts follow by themselves. A
    /// friction of finite force takes no part in an impulse: where it leaves a slip speed, a
    /// contact that held slides from there.
    fn reset(
        &self,
        structure: Self::Structure,
        contacts: ContactSet,
        _guard: GuardId,
        x: &Self::State,
        _input: &Self::Input,
    ) -> Reset<WithContacts<Self>> {
        Reset::to(ContactMode { structure, contacts }, *x)
    }
}
