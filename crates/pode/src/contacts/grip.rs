//! How well a friction holds, and which way it goes where it does not.

use crate::contacts::point::{ContactMotion, ContactPoint};
use crate::contacts::{ContactState, FrictionSpec, GuardedContacts};
use crate::filippov::Surface;
use crate::{GuardSpec, GuardValue};

/// The guards of a friction are in parts of its own sizes.
pub(super) const UNIT: GuardSpec = GuardSpec::new(0, "");

/// A friction at a point of the motion.
pub(super) struct Friction<'a, M: GuardedContacts> {
    pub(super) point: ContactPoint<'a, M>,
    pub(super) contact: usize,
    pub(super) spec: FrictionSpec,
}

impl<M: GuardedContacts> Friction<'_, M> {
    /// The guard of the friction in the state of its mode; positive while that goes on.
    pub(super) fn guard(&self) -> GuardValue {
        let state = self.point.mode.contacts.state(self.contact);
        match state {
            ContactState::Stick => self.stick_guard(),
            ContactState::SlideUp | ContactState::SlideDown => self.slide_guard(state),
            ContactState::Open | ContactState::Closed => GuardValue::new(1.0, 0.0),
        }
    }

    /// Whether the slip speed is zero, as far as can be told where a guard of the friction, or of
    /// its contact, has fired.
    pub(super) fn is_stopped(&self) -> bool {
        let zero = match self.point.mode.contacts.state(self.contact) {
            ContactState::Stick => self.spec.slack,
            ContactState::SlideUp | ContactState::SlideDown => self.spec.located(),
            ContactState::Open | ContactState::Closed => self.spec.same(),
        };
        self.point.slip(self.contact).value.abs() <= zero
    }

    /// The state that it must be in at slip speed zero, if it is not the present one.
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

    /// Limit² − force² in parts of the friction's size, and its rate; negative where no force
    /// of this friction can hold.
    fn stick_guard(&self) -> GuardValue {
        let slip = self.point.slip(self.contact);
        if slip.value.abs() > self.spec.slack {
            return GuardValue::new(-slip.value.abs() / self.spec.slip, 0.0);
        }
        let motion = self.point.motion();
        if self.moves(&slip, &motion).is_some() {
            return GuardValue::new(-1.0, 0.0);
        }
        let value = self.margin_with(&self.point, motion.forces.at(self.contact));
        let dt = M::MOMENT;
        let [late, early] =
            [dt, -dt].map(|dt| self.point.after(dt, &motion.flow, |point| self.margin(point)));
        GuardValue::new(value, (late - early) / (2.0 * dt))
    }

    /// The slip acceleration, if it is more than rounding leaves.
    ///
    /// It can be that where a friction is to hold: others have taken from its force what it
    /// could move.
    fn moves(&self, slip: &Surface<M::State>, motion: &ContactMotion<M::State>) -> Option<f64> {
        /// Part of what the friction's own force can do that counts as none.
        const PART: f64 = 1e-10;
        let force = self.spec.force + motion.forces.at(self.contact).abs();
        let reach = slip.slope(&self.point.response(self.contact)) * force;
        let acceleration = slip.rate(&motion.flow);
        (acceleration.abs() > PART * reach).then_some(acceleration)
    }

    fn margin(&self, point: &ContactPoint<'_, M>) -> f64 {
        self.margin_with(point, point.motion().forces.at(self.contact))
    }

    fn margin_with(&self, point: &ContactPoint<'_, M>, force: f64) -> f64 {
        let limit = point.limits(self.contact).stiction / self.spec.force;
        let force = force / self.spec.force;
        // As a product it keeps its digits where both are nearly equal.
        (limit - force) * (limit + force)
    }

    /// The slip speed in the direction of the slide.
    ///
    /// A slide that begins where the force has come to its limit starts at zero, with a rate of
    /// zero that rounding may make negative.
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

    /// Whether the force that holds is within its limit, and not about to leave it.
    fn holds(&self) -> bool {
        /// Part of a moment: a force that is at its limit sooner does not hold.
        const SOON: f64 = 1.0 / 4096.0;
        let grip = self.stick_guard();
        let lost = (-grip.rate).max(0.0) * SOON * M::MOMENT;
        grip.value > UNIT.band() + lost || (grip.value.abs() <= UNIT.band() && grip.rate >= 0.0)
    }

    /// Where it slips if it is let go: as it does if it cannot be held, or against the force that
    /// holds it.
    pub(super) fn slip_direction(&self) -> ContactState {
        let motion = self.point.motion();
        let left = self.moves(&self.point.slip(self.contact), &motion);
        ContactState::slide(left.unwrap_or_else(|| -motion.forces.at(self.contact)))
    }
}
