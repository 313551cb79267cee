//! Where the energy of a mechanism with contacts came from and went.

use crate::{ContactIndices, ContactMode, ContactSystem, FrictionForces, WithContacts};
use pode::Energetic;

/// A mechanism that can account for its energy; what friction takes is known without it.
pub trait EnergeticContacts: ContactSystem {
    /// Returns the energy stored in `x`, and in the `closed` contacts (J).
    fn energy(
        &self,
        structure: Self::Structure,
        closed: ContactIndices,
        x: &Self::State,
        input: &Self::Input,
    ) -> f64;

    /// Returns the power that the drive of the input puts in (W), by friction too, as a belt
    /// does.
    fn supplied(
        &self,
        _structure: Self::Structure,
        _closed: ContactIndices,
        _forces: &FrictionForces,
        _x: &Self::State,
        _input: &Self::Input,
    ) -> f64 {
        0.0
    }

    /// Returns the power that dampers and the `closed` contacts take (W), without friction.
    fn dissipated(
        &self,
        _structure: Self::Structure,
        _closed: ContactIndices,
        _x: &Self::State,
        _input: &Self::Input,
    ) -> f64 {
        0.0
    }
}

impl<M: EnergeticContacts> Energetic for WithContacts<M> {
    fn energy(&self, mode: ContactMode<M::Structure>, x: &M::State, input: &M::Input) -> f64 {
        self.system().energy(mode.structure, mode.contacts.closed(), x, input)
    }

    fn supplied(&self, mode: ContactMode<M::Structure>, x: &M::State, input: &M::Input) -> f64 {
        let forces = self.friction_forces(mode, x, input);
        self.system().supplied(mode.structure, mode.contacts.closed(), &forces, x, input)
    }

    fn dissipated(&self, mode: ContactMode<M::Structure>, x: &M::State, input: &M::Input) -> f64 {
        let (structure, system) = (mode.structure, self.system());
        let forces = self.friction_forces(mode, x, input);
        let friction: f64 = forces
            .iter()
            .map(|(contact, force)| -force * system.slip(structure, contact, x, input).value)
            .sum();
        friction + system.dissipated(structure, mode.contacts.closed(), x, input)
    }
}
