//! A state in one mode of the contacts: friction forces and the resulting motion.

use crate::State as _;
use crate::contacts::solve::{Mobility, PerFriction, least_norm};
use crate::contacts::{
    ContactIndices, ContactMode, Continued as _, FrictionForces, FrictionLimits, GuardedContacts,
    MAX_FRICTIONS, Surface,
};

pub(super) struct ContactPoint<'a, M: GuardedContacts> {
    pub(super) system: &'a M,
    pub(super) mode: ContactMode<M::Structure>,
    pub(super) x: &'a M::State,
    pub(super) input: &'a M::Input,
}

pub(super) struct ContactMotion<S> {
    pub(super) flow: S,
    pub(super) forces: FrictionForces,
}

struct Held<S> {
    contacts: ContactIndices,
    slips: [Surface<S>; MAX_FRICTIONS],
    responses: [S; MAX_FRICTIONS],
    mobility: Mobility,
}

impl<'a, M: GuardedContacts> ContactPoint<'a, M> {
    const fn moved<'b>(&self, x: &'b M::State, input: &'b M::Input) -> ContactPoint<'b, M>
    where
        'a: 'b,
    {
        ContactPoint { system: self.system, mode: self.mode, x, input }
    }

    pub(super) fn slip(&self, contact: usize) -> Surface<M::State> {
        self.system.slip(self.mode.structure, contact, self.x, self.input)
    }

    /// Returns what a stick keeps at zero: the slip speed, or a rate that its force does change.
    pub(super) fn kept(&self, contact: usize) -> Surface<M::State> {
        let kept = self.system.kept(self.mode.structure, contact, self.x, self.input);
        kept.unwrap_or_else(|| self.slip(contact))
    }

    pub(super) fn response(&self, contact: usize) -> M::State {
        let ContactMode { structure, contacts } = self.mode;
        self.system.response_among(structure, contacts, contact, self.x, self.input)
    }

    pub(super) fn limits(&self, contact: usize) -> FrictionLimits {
        self.system.friction(self.mode.structure, contact, self.x, self.input)
    }

    /// Computes the derivative with friction: one derivative, and one response per friction.
    pub(super) fn motion(&self) -> ContactMotion<M::State> {
        let (structure, contacts) = (self.mode.structure, self.mode.contacts);
        let mut flow = self.system.derivative(structure, contacts.closed(), self.x, self.input);
        if self.has_coupled_forces() {
            return self.coupled(flow);
        }
        let mut forces = self.sliding();
        for (contact, force) in forces.iter() {
            flow = flow.plus(force, &self.response(contact));
        }
        if !contacts.sticking().is_empty() {
            self.hold(&mut flow, &mut forces);
        }
        ContactMotion { flow, forces }
    }

    /// Computes all friction forces; only holding ones cost as much as [`ContactPoint::motion`].
    pub(super) fn forces(&self) -> FrictionForces {
        let is_simple = self.mode.contacts.sticking().is_empty() && !self.has_coupled_forces();
        if is_simple { self.sliding() } else { self.motion().forces }
    }

    fn sliding(&self) -> FrictionForces {
        let mut forces = FrictionForces::NONE;
        for contact in self.mode.contacts.sliding() {
            let sign = self.mode.contacts.state(contact).slip_sign();
            forces.add(contact, -sign * self.limits(contact).kinetic);
        }
        forces
    }

    fn hold(&self, flow: &mut M::State, forces: &mut FrictionForces) {
        let held = self.held(self.mode.contacts.sticking());
        let wanted = held.column(|slip| -slip.rate(flow));
        let solution = least_norm(&held.mobility, &wanted, held.contacts.len());
        for (index, contact) in held.contacts.iter().enumerate().take(MAX_FRICTIONS) {
            *flow = flow.plus(solution[index], &held.responses[index]);
            forces.add(contact, solution[index]);
        }
    }

    fn held(&self, contacts: ContactIndices) -> Held<M::State> {
        let none = Surface { value: 0.0, gradient: M::State::ZERO, drift: 0.0 };
        let mut slips = [none; MAX_FRICTIONS];
        let mut responses = [M::State::ZERO; MAX_FRICTIONS];
        let mut mobility = [[0.0; MAX_FRICTIONS]; MAX_FRICTIONS];
        for (index, contact) in contacts.iter().enumerate().take(MAX_FRICTIONS) {
            (slips[index], responses[index]) = (self.kept(contact), self.response(contact));
            for other in 0..=index {
                let entry = slips[index].slope(&responses[other]);
                (mobility[index][other], mobility[other][index]) = (entry, entry);
            }
        }
        Held { contacts, slips, responses, mobility }
    }

    /// Returns the state with the slip speed of all `contacts` at zero, moved along the motions of
    /// their forces, so that only what a friction can change changes.
    pub(super) fn without_slip(&self, contacts: ContactIndices) -> M::State {
        let held = self.held(contacts);
        let wanted = held.column(|slip| -slip.value);
        let impulses = least_norm(&held.mobility, &wanted, contacts.len());
        let moved = impulses.iter().zip(&held.responses).take(contacts.len());
        moved.fold(*self.x, |x, (impulse, response)| x.plus(*impulse, response))
    }

    /// Returns the point `dt` (s) later along `flow`, or earlier if negative.
    pub(super) fn after<T>(
        &self,
        dt: f64,
        flow: &M::State,
        ask: impl FnOnce(&ContactPoint<'_, M>) -> T,
    ) -> T {
        let (x, input) = (self.x.plus(dt, flow), self.input.after(dt));
        ask(&self.moved(&x, &input))
    }
}

impl<S: crate::State> Held<S> {
    fn column(&self, number: impl Fn(&Surface<S>) -> f64) -> PerFriction {
        let mut column = [0.0; MAX_FRICTIONS];
        let slips = self.slips.iter().take(self.contacts.len());
        for (entry, slip) in column.iter_mut().zip(slips) {
            *entry = number(slip);
        }
        column
    }
}
