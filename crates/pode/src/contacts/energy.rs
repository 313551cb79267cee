//! Sources and sinks of the energy of a mechanism with contacts.

use crate::contacts::{
    ContactIndices, ContactMode, FrictionForces, GuardedContacts, SlipKind, WithContacts,
};
use crate::{Energetic, EnergyBalance};

/// A mechanism that can account for its energy; friction's losses are computed for it.
pub trait EnergeticContacts: GuardedContacts {
    /// Returns the energy stored in `x` and in the `closed` contacts, independent of the friction
    /// `forces`; the power from the input's driver, also through friction, as from a belt; and the
    /// power that dampers and the `closed` contacts absorb, without friction.
    fn balance(
        &self,
        structure: Self::Structure,
        closed: ContactIndices,
        forces: &FrictionForces,
        x: &Self::State,
        input: &Self::Input,
    ) -> EnergyBalance;
}

impl<M: EnergeticContacts> Energetic for WithContacts<M> {
    fn energy(&self, mode: ContactMode<M::Structure>, x: &M::State, input: &M::Input) -> f64 {
        let (closed, forces) = (mode.contacts.closed(), FrictionForces::NONE);
        self.system().balance(mode.structure, closed, &forces, x, input).energy
    }

    fn supplied(&self, mode: ContactMode<M::Structure>, x: &M::State, input: &M::Input) -> f64 {
        self.balance_of_input(mode, x, input).supplied
    }

    fn dissipated(&self, mode: ContactMode<M::Structure>, x: &M::State, input: &M::Input) -> f64 {
        self.balance_of_input(mode, x, input).dissipated
    }

    /// Computes the friction forces once, since they may cost a derivative.
    fn balance_of_input(
        &self,
        mode: ContactMode<M::Structure>,
        x: &M::State,
        input: &M::Input,
    ) -> EnergyBalance {
        let (structure, system) = (mode.structure, self.system());
        let forces = self.friction_forces(mode, x, input);
        let of_system = system.balance(structure, mode.contacts.closed(), &forces, x, input);
        let takes_power = |contact: usize| {
            let spec = system.contacts().get(contact).and_then(|it| it.friction);
            spec.is_some_and(|it| it.kind == SlipKind::Speed)
        };
        let friction: f64 = forces
            .iter()
            .filter(|(contact, _)| takes_power(*contact))
            .map(|(contact, force)| -force * system.slip(structure, contact, x, input).value)
            .sum();
        EnergyBalance { dissipated: friction + of_system.dissipated, ..of_system }
    }
}
