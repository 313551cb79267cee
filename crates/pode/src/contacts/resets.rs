//! The mode in which a state starts, and resets: a contact, a friction or the structure changes.

use crate::contacts::grip::SOON;
use crate::contacts::spec::STRUCTURE;
use crate::contacts::{
    ContactGuard, ContactIndices, ContactMode, ContactSet, ContactState, GuardedContacts,
    WithContacts,
};
use crate::{GuardId, Guarded as _, Reset, Resets};

impl<M: GuardedContacts> Resets for WithContacts<M> {
    fn reset(
        &self,
        mode: ContactMode<M::Structure>,
        guard: GuardId,
        x: &M::State,
        input: &M::Input,
    ) -> Reset<Self> {
        match ContactGuard::of(guard) {
            ContactGuard::Gap(contact) if mode.contacts.is_closed(contact) => {
                Reset::to(mode.with(contact, ContactState::Open), *x)
            }
            ContactGuard::Gap(contact) => {
                self.touch(mode.with(contact, ContactState::Closed), contact, x, input)
            }
            ContactGuard::Friction(contact) => self.touch(mode, contact, x, input),
            ContactGuard::Structure(guard) => {
                let reset = self.system.reset(mode.structure, mode.contacts, guard, x, input);
                let released =
                    reset.released.map(|guard| GuardId(guard.0.saturating_add(STRUCTURE)));
                let mode = self.released(reset.mode, &reset.state, input);
                let rests = reset.rests.map(|(mode, x)| (self.released(mode, &x, input), x));
                Reset { mode, rests, released, ..reset }
            }
        }
    }
}

impl<S> ContactMode<S> {
    #[must_use]
    pub fn with(self, contact: usize, state: ContactState) -> Self {
        Self { contacts: self.contacts.with(contact, state), ..self }
    }
}

impl<M: GuardedContacts> WithContacts<M> {
    /// Returns the mode in which `x` starts in `structure`, and `x` with sticking contacts at rest.
    ///
    /// A contact starts closed where its gap is negative; its friction slides where the slip speed
    /// is not zero, and sticks where the holding forces are within their limits.
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
        for contact in mode.contacts.sticking() {
            let crossing = self.friction(mode, contact, x, input).and_then(|it| it.crosses(SOON));
            mode = crossing.map_or(mode, |state| mode.with(contact, state));
        }
        let x = self.constrain(mode, x, input);
        (self.decided(mode, mode.contacts.sticking(), &x, input), x)
    }

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

    fn touch(
        &self,
        mode: ContactMode<M::Structure>,
        contact: usize,
        x: &M::State,
        input: &M::Input,
    ) -> Reset<Self> {
        let Some(friction) = self.friction(mode, contact, x, input) else {
            return Reset::to(mode, *x);
        };
        if !friction.is_stopped() {
            let slip = friction.point.slip(contact).value;
            return Reset::to(mode.with(contact, ContactState::slide(slip)), *x);
        }
        // A stick at its limit lets go first; all others may stick.
        let before = mode.contacts.state(contact);
        let held = before == ContactState::Stick;
        // A method that cannot follow the way back comes again at once.
        let crossing = friction.crosses(SOON).and_then(|state| {
            if state == before { friction.crosses(f64::INFINITY) } else { Some(state) }
        });
        if let (false, Some(state)) = (held, crossing) {
            return Reset::to(mode.with(contact, state), *x);
        }
        let first = if held { friction.slip_direction() } else { ContactState::Stick };
        let stopped = self.stopped_with(mode, contact, x, input);
        let resting = stopped.contacts.sticking();
        // A slide that turns back also starts at zero.
        let x = self.point(stopped, x, input).without_slip(resting);
        Reset::to(self.decided(stopped.with(contact, first), resting, &x, input), x)
    }

    fn stopped_with(
        &self,
        mode: ContactMode<M::Structure>,
        contact: usize,
        x: &M::State,
        input: &M::Input,
    ) -> ContactMode<M::Structure> {
        let mut stopped = mode.with(contact, ContactState::Stick);
        for other in mode.contacts.sliding() {
            let Some(friction) = self.friction(mode, other, x, input) else { continue };
            let is_zero = friction.point.slip(other).value.abs() <= friction.spec.same();
            if is_zero && friction.crosses(SOON).is_none() {
                stopped = stopped.with(other, ContactState::Stick);
            }
        }
        stopped
    }

    /// Returns the mode in which each of `resting`, with slip speeds zero, holds or slides as its
    /// own force permits: the lowest contact that does neither is revised until none is left.
    pub(super) fn decided(
        &self,
        mut mode: ContactMode<M::Structure>,
        resting: ContactIndices,
        x: &M::State,
        input: &M::Input,
    ) -> ContactMode<M::Structure> {
        /// Revisions per contact; each has three states to try.
        const MOST: usize = 4;
        for _ in 0..MOST * resting.len() {
            let revised = resting.iter().find_map(|contact| {
                let state = self.friction(mode, contact, x, input)?.revised()?;
                Some(mode.with(contact, state))
            });
            let Some(next) = revised else { break };
            mode = next;
        }
        mode
    }

    /// Returns the mode with those contacts let go that the structure's impulse makes slip.
    fn released(
        &self,
        mode: ContactMode<M::Structure>,
        x: &M::State,
        input: &M::Input,
    ) -> ContactMode<M::Structure> {
        let point = self.point(mode, x, input);
        let mut after = mode;
        for contact in mode.contacts.sticking() {
            let Some(friction) = self.friction(mode, contact, x, input) else { continue };
            let slip = point.kept(contact).value;
            if slip.abs() > friction.spec.same() {
                after = after.with(contact, ContactState::slide(slip));
            }
        }
        after
    }
}
