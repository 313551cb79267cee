//! The equations of motion with the friction forces of the mode.

use crate::contacts::{ContactMode, ContactState, GuardedContacts, WithContacts};
use crate::{Model, Nature};

impl<M: GuardedContacts> Model for WithContacts<M> {
    type Mode = ContactMode<M::Structure>;
    type State = M::State;
    type Input = M::Input;
    const COORDS: usize = M::COORDS;

    #[inline]
    fn coordinates(&self) -> usize {
        self.system.coordinates()
    }

    fn derivative(&self, mode: Self::Mode, x: &M::State, input: &M::Input) -> M::State {
        self.point(mode, x, input).motion().flow
    }

    fn readout(&self, mode: Self::Mode, x: &M::State, input: &M::Input) -> f64 {
        let forces = self.friction_forces(mode, x, input);
        self.system.readout(mode.structure, mode.contacts.closed(), &forces, x, input)
    }

    fn nature(&self, mode: Self::Mode) -> Nature {
        self.system.nature(mode.structure, mode.contacts)
    }
}

impl<M: GuardedContacts> WithContacts<M> {
    pub(super) fn stopped(
        &self,
        mode: ContactMode<M::Structure>,
        x: &M::State,
        input: &M::Input,
    ) -> M::State {
        let point = self.point(mode, x, input);
        let (mut held, mut moves) = (mode.contacts, false);
        for contact in mode.contacts.sticking() {
            let Some(friction) = self.friction(mode, contact, x, input) else { continue };
            // A contact torn off by the input is left to the guard.
            if point.slip(contact).value.abs() > friction.spec.slack {
                held = held.with(contact, ContactState::Closed);
            }
            moves |= point.kept(contact).value.abs() > friction.spec.rounding();
        }
        let held = held.sticking();
        if moves && !held.is_empty() { point.without_slip(held) } else { *x }
    }
}
