//! The mode in which a state starts.

use super::{ContactMode, ContactSet, ContactState, ContactSystem, WithContacts};
use crate::model::Model as _;

impl<M: ContactSystem> WithContacts<M> {
    /// The mode in which `x` starts in `structure`, and `x` with what sticks put to rest.
    ///
    /// A contact starts closed where its gap is negative; its friction slides where the slip
    /// speed is not zero, and sticks where the forces that hold are within their limits.
    pub fn start(
        &self,
        structure: M::Structure,
        x: &M::State,
        input: &M::Input,
    ) -> (ContactMode<M::Structure>, M::State) {
        let mut mode = ContactMode { structure, contacts: ContactSet::OPEN };
        for contact in 0..self.system.contacts().len() {
            mode = mode.with(contact, self.first_state(structure, contact, x, input));
        }
        let x = self.constrain(mode, x, input);
        (self.decided(mode, mode.contacts.sticking(), &x, input), x)
    }

    /// What a contact does as far as its gap and its slip speed tell.
    fn first_state(
        &self,
        structure: M::Structure,
        contact: usize,
        x: &M::State,
        input: &M::Input,
    ) -> ContactState {
        let Some(spec) = self.system.contacts().get(contact) else { return ContactState::Open };
        let is_open =
            spec.gap.is_some() && self.system.gap(structure, contact, x, input).value >= 0.0;
        let Some(friction) = spec.friction.filter(|_| !is_open) else {
            return if is_open { ContactState::Open } else { ContactState::Closed };
        };
        let slip = self.system.slip(structure, contact, x, input).value;
        if slip.abs() > friction.same() { ContactState::slide(slip) } else { ContactState::Stick }
    }
}
