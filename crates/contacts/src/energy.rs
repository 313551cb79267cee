//! Where the energy of a mechanism with contacts came from and went.

use crate::{ContactIndices, ContactMode, ContactSystem, FrictionForces, WithContacts};
use pode::{Energetic, EnergyBalance};

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

    /// Returns the three together; for a system whose energy and powers share costly terms.
    fn balance(
        &self,
        structure: Self::Structure,
        closed: ContactIndices,
        forces: &FrictionForces,
        x: &Self::State,
        input: &Self::Input,
    ) -> EnergyBalance {
        EnergyBalance {
            energy: self.energy(structure, closed, x, input),
            supplied: self.supplied(structure, closed, forces, x, input),
            dissipated: self.dissipated(structure, closed, x, input),
        }
    }
}

impl<M: EnergeticContacts> WithContacts<M> {
    /// Power that friction takes (W).
    fn taken_by_friction(
        &self,
        structure: M::Structure,
        forces: &FrictionForces,
        x: &M::State,
        input: &M::Input,
    ) -> f64 {
        let slip = |contact| self.system().slip(structure, contact, x, input).value;
        forces.iter().map(|(contact, force)| -force * slip(contact)).sum()
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
        let forces = self.friction_forces(mode, x, input);
        let closed = mode.contacts.closed();
        self.taken_by_friction(mode.structure, &forces, x, input)
            + self.system().dissipated(mode.structure, closed, x, input)
    }

    /// The friction forces, which cost a derivative, are worked out once.
    fn balance_of_input(
        &self,
        mode: ContactMode<M::Structure>,
        x: &M::State,
        input: &M::Input,
    ) -> EnergyBalance {
        let forces = self.friction_forces(mode, x, input);
        let closed = mode.contacts.closed();
        let of_system = self.system().balance(mode.structure, closed, &forces, x, input);
        let friction = self.taken_by_friction(mode.structure, &forces, x, input);
        EnergyBalance { dissipated: friction + of_system.dissipated, ..of_system }
    }
}
