//! The hold of a friction, and the direction of its slip.

use crate::contacts::point::{ContactMotion, ContactPoint};
use crate::contacts::{ContactState, FrictionForces, FrictionSpec, GuardedContacts, Surface};
use crate::{GuardSpec, GuardValue};

/// Largest time (in moments) between two crossings that are no longer followed.
pub(super) const SOON: f64 = 32.0;

pub(super) const UNIT: GuardSpec = GuardSpec::new(0, "");

pub(super) struct Friction<'a, M: GuardedContacts> {
    pub(super) point: ContactPoint<'a, M>,
    pub(super) contact: usize,
    pub(super) spec: FrictionSpec,
}

impl<M: GuardedContacts> Friction<'_, M> {
    pub(super) fn guard(&self) -> GuardValue {
        let state = self.point.mode.contacts.state(self.contact);
        match state {
            ContactState::Stick => self.stick_guard(),
            ContactState::SlideUp | ContactState::SlideDown => self.slide_guard(state),
            ContactState::Open | ContactState::Closed => GuardValue::new(1.0, 0.0),
        }
    }

    /// Returns `true` if the slip speed is zero within the width of a located guard.
    pub(super) fn is_stopped(&self) -> bool {
        let zero = match self.point.mode.contacts.state(self.contact) {
            ContactState::Stick => self.spec.slack,
            ContactState::SlideUp | ContactState::SlideDown => self.spec.located(),
            ContactState::Open | ContactState::Closed => self.spec.same(),
        };
        self.point.slip(self.contact).value.abs() <= zero
    }

    pub(super) fn revised(&self) -> Option<ContactState> {
        let state = self.point.mode.contacts.state(self.contact);
        match state {
            ContactState::Stick => (!self.holds()).then(|| self.slip_direction()),
            ContactState::SlideUp | ContactState::SlideDown => {
                let (slip, motion) = (self.point.slip(self.contact), self.point.motion());
                let moves = self.moves(&slip, &motion)?;
                (moves * state.slip_sign() < 0.0).then_some(ContactState::Stick)
            }
            ContactState::Open | ContactState::Closed => None,
        }
    }

    /// Limit² − force² relative to the friction's size, and its rate; below 0 if none holds.
    fn stick_guard(&self) -> GuardValue {
        let slip = self.point.slip(self.contact);
        if slip.value.abs() > self.spec.slack {
            return GuardValue::new(-slip.value.abs() / self.spec.slip, 0.0);
        }
        let motion = self.point.motion();
        if self.moves(&self.point.kept(self.contact), &motion).is_some() {
            return GuardValue::new(-1.0, 0.0);
        }
        let value = self.margin_with(&self.point, &motion.forces);
        let dt = M::MOMENT;
        let [late, early] =
            [dt, -dt].map(|dt| self.point.after(dt, &motion.flow, |point| self.margin(point)));
        GuardValue::new(value, (late - early) / (2.0 * dt))
    }

    /// Returns the slip acceleration, if it is more than rounding. It is not zero at a held
    /// friction if others have taken away its force's effect.
    fn moves(&self, slip: &Surface<M::State>, motion: &ContactMotion<M::State>) -> Option<f64> {
        /// Fraction of the acceleration by the friction's own force that counts as zero.
        const PART: f64 = 1e-10;
        let force = self.spec.force + motion.forces.at(self.contact).abs();
        let reach = slip.slope(&self.point.response(self.contact)) * force;
        let acceleration = slip.rate(&motion.flow);
        (acceleration.abs() > PART * reach).then_some(acceleration)
    }

    fn margin(&self, point: &ContactPoint<'_, M>) -> f64 {
        self.margin_with(point, &point.motion().forces)
    }

    fn margin_with(&self, point: &ContactPoint<'_, M>, forces: &FrictionForces) -> f64 {
        let limit = point.stiction(self.contact, forces) / self.spec.force;
        let force = forces.at(self.contact) / self.spec.force;
        // As a product it keeps its digits where both are nearly equal.
        (limit - force) * (limit + force)
    }

    /// Returns the slip speed in the direction of the slide. A slide that starts as the force
    /// reaches its limit has speed zero and rate zero, which rounding may make negative.
    fn slide_guard(&self, state: ContactState) -> GuardValue {
        let (slip, motion) = (self.point.slip(self.contact), self.point.motion());
        let part = state.slip_sign() / self.spec.slip;
        let value = part * slip.value;
        let rate = part * slip.rate(&motion.flow);
        let is_zero = value.abs() <= UNIT.band();
        if is_zero && rate < 0.0 && self.moves(&slip, &motion).is_none() {
            return GuardValue::new(value.max(0.0), 0.0);
        }
        GuardValue::new(value, rate)
    }

    /// Returns the side to which a state at zero slip moves, if the friction force does not change
    /// the slip's rate; `None` if it does, or if both sides drive the state back within `soon`
    /// moments.
    pub(super) fn crosses(&self, soon: f64) -> Option<ContactState> {
        let ContactPoint { system, mode, x, input } = self.point;
        let kept = system.kept(mode.structure, self.contact, x, input)?;
        let mode = mode.with(self.contact, ContactState::Closed);
        let free = ContactPoint { system, mode, x, input };
        let flow = free.motion().flow;
        let rate = free.slip(self.contact).rate(&flow);
        let push = kept.rate(&flow);
        let back = kept.slope(&free.response(self.contact)) - push.abs();
        if 2.0 * rate.abs() <= soon * M::MOMENT * back {
            return None;
        }
        Some(ContactState::slide(if rate.abs() > 0.0 { rate } else { push }))
    }

    /// Returns `true` if the holding force is within its limit, and not about to leave it.
    fn holds(&self) -> bool {
        /// Relative time: a force at its limit sooner does not hold.
        const SOON: f64 = 1.0 / 4096.0;
        let grip = self.stick_guard();
        let lost = (-grip.rate).max(0.0) * SOON * M::MOMENT;
        grip.value > UNIT.band() + lost || (grip.value.abs() <= UNIT.band() && grip.rate >= 0.0)
    }

    /// Returns the slip's direction if let go: its acceleration's, or against the holding force.
    pub(super) fn slip_direction(&self) -> ContactState {
        let motion = self.point.motion();
        let left = self.moves(&self.point.kept(self.contact), &motion);
        ContactState::slide(left.unwrap_or_else(|| -motion.forces.at(self.contact)))
    }
}
