//! The guards of all contacts, frictions and structural modes in one list.

use crate::contacts::grip::Friction;
use crate::contacts::spec::{ContactGuard, FRICTIONS, STRUCTURE};
use crate::contacts::{
    ContactMode, ContactState, GuardedContacts, MAX_CONTACTS, MAX_FRICTIONS, WithContacts,
};
use crate::{
    Enclosure, GuardBound, GuardId, GuardSpec, GuardValue, Guarded, MAX_GUARDS, Mechanical,
};

/// Error for a model with too many contacts, frictions or guards.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TooManyGuards {
    /// Number of contacts, more than [`MAX_CONTACTS`].
    Contacts(usize),
    Frictions,
    /// More guards than [`MAX_GUARDS`](crate::MAX_GUARDS), with one per contact and friction.
    Guards,
    /// Structure guard whose id is not below 128.
    Id(GuardId),
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct GuardList {
    specs: [GuardSpec; MAX_GUARDS],
    len: usize,
}

impl GuardList {
    /// Priority of contacts: after the structure, before frictions.
    const CONTACT_PRIORITY: u8 = 64;
    const FRICTION_PRIORITY: u8 = 128;

    pub(super) fn of<M: GuardedContacts>(system: &M) -> Result<Self, TooManyGuards> {
        let mut list = Self { specs: [GuardSpec::new(0, ""); MAX_GUARDS], len: 0 };
        let contacts = system.contacts();
        if contacts.len() > MAX_CONTACTS {
            return Err(TooManyGuards::Contacts(contacts.len()));
        }
        if contacts.iter().filter(|contact| contact.friction.is_some()).count() > MAX_FRICTIONS {
            return Err(TooManyGuards::Frictions);
        }
        for (number, contact) in (0..).zip(contacts) {
            if let Some(scale) = contact.gap {
                let spec = GuardSpec::new(number, contact.name).scaled(scale);
                list.add(spec.with_priority(Self::CONTACT_PRIORITY))?;
            }
            if let Some(friction) = contact.friction {
                let spec = GuardSpec::new(FRICTIONS + number, friction.name);
                list.add(spec.with_priority(Self::FRICTION_PRIORITY))?;
            }
        }
        for spec in system.structure_guards() {
            let id = spec.id.0.checked_add(STRUCTURE).ok_or(TooManyGuards::Id(spec.id))?;
            list.add(GuardSpec { id: GuardId(id), ..*spec })?;
        }
        Ok(list)
    }

    fn add(&mut self, spec: GuardSpec) -> Result<(), TooManyGuards> {
        *self.specs.get_mut(self.len).ok_or(TooManyGuards::Guards)? = spec;
        self.len += 1;
        Ok(())
    }

    fn specs(&self) -> &[GuardSpec] {
        &self.specs[..self.len]
    }
}

impl<M: GuardedContacts> Guarded for WithContacts<M> {
    fn longest_step_at(&self, mode: Self::Mode, x: &M::State, input: &M::Input) -> f64 {
        self.system.longest_step_at(mode.structure, mode.contacts, x, input)
    }

    fn mechanical(&self) -> Option<&dyn Mechanical<Self::Mode, M::State, M::Input>> {
        self.system.mechanical()
    }

    fn constrain(&self, mode: Self::Mode, x: &M::State, input: &M::Input) -> M::State {
        let x = self.system.constrain(mode.structure, x, input);
        if mode.contacts.sticking().is_empty() { x } else { self.stopped(mode, &x, input) }
    }

    fn guards(&self, _: ContactMode<M::Structure>) -> &[GuardSpec] {
        self.guards.specs()
    }

    fn is_watched(&self, mode: ContactMode<M::Structure>, guard: GuardId) -> bool {
        match ContactGuard::of(guard) {
            ContactGuard::Gap(_) => true,
            ContactGuard::Friction(contact) => {
                !matches!(mode.contacts.state(contact), ContactState::Open | ContactState::Closed)
                    && self.system.acts(mode.structure, contact)
            }
            ContactGuard::Structure(guard) => self.system.is_watched(mode.structure, guard),
        }
    }

    fn guard_bound(
        &self,
        mode: ContactMode<M::Structure>,
        guard: GuardId,
        over: &Enclosure<M::State, M::Input>,
    ) -> GuardBound {
        match ContactGuard::of(guard) {
            ContactGuard::Friction(contact) => self.friction_bound(mode, contact, over),
            guard @ (ContactGuard::Gap(_) | ContactGuard::Structure(_)) => {
                self.system.guard_bound(mode.structure, guard, over)
            }
        }
    }

    fn guard(
        &self,
        mode: ContactMode<M::Structure>,
        guard: GuardId,
        x: &M::State,
        input: &M::Input,
    ) -> GuardValue {
        match ContactGuard::of(guard) {
            ContactGuard::Gap(contact) => {
                let gap = self.system.gap(mode.structure, contact, x, input);
                if mode.contacts.is_closed(contact) { -gap } else { gap }
            }
            ContactGuard::Friction(contact) => {
                let friction = self.friction(mode, contact, x, input);
                friction.map_or(GuardValue::new(1.0, 0.0), |it| it.guard())
            }
            ContactGuard::Structure(guard) => self.point(mode, x, input).structure_guard(guard),
        }
    }
}

impl<M: GuardedContacts> WithContacts<M> {
    /// Bounds a friction's guard: a slide's by the slip speed relative to its size. A stick's guard
    /// depends on all frictions that act with it and has no bound.
    fn friction_bound(
        &self,
        mode: ContactMode<M::Structure>,
        contact: usize,
        over: &Enclosure<M::State, M::Input>,
    ) -> GuardBound {
        let spec = self.system.contacts().get(contact).and_then(|it| it.friction);
        match (mode.contacts.state(contact), spec) {
            (ContactState::SlideUp | ContactState::SlideDown, Some(spec)) => {
                let guard = ContactGuard::Friction(contact);
                self.system.guard_bound(mode.structure, guard, over).times(1.0 / spec.slip)
            }
            _ => GuardBound::UNKNOWN,
        }
    }

    pub(super) fn friction<'a>(
        &'a self,
        mode: ContactMode<M::Structure>,
        contact: usize,
        x: &'a M::State,
        input: &'a M::Input,
    ) -> Option<Friction<'a, M>> {
        let spec = self.system.contacts().get(contact)?.friction?;
        Some(Friction { point: self.point(mode, x, input), contact, spec })
    }
}
