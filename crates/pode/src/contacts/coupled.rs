//! Frictions that press contacts, as on a rigid one: its normal force depends on the friction.
//!
//! Limits are linear in the friction forces λ, `limit_k + Σ_j c_kj λ_j`, and so is the motion:
//!
//! ```text
//! λ_k + sign(s_k) Σ_j c_kj λ_j = −sign(s_k) limit_k      where it slides
//! Σ_j (∂s_k/∂x · r_j) λ_j = −s_k' without friction        where it sticks
//! ```
//!
//! Where friction presses a sliding contact more than it is pressed, no such forces exist, or
//! several do (Painlevé): a pivot of the upper lines is then not positive, the forces are NaN, and
//! the step is a fault.

use super::point::{ContactMotion, ContactPoint};
use super::solve::{Mobility, PerFriction};
use super::{ContactGuard, FrictionForces, GuardedContacts, MAX_FRICTIONS, Surface};
use crate::{GuardId, GuardValue, State as _};

/// Fraction of its diagonal below which a pivot of a stick counts as zero: others hold it.
const DEPENDENT: f64 = 1e-11;

struct CoupledForces {
    /// Rows of slides first, then of sticks.
    a: Mobility,
    b: PerFriction,
    /// Diagonal entries before the elimination.
    sizes: PerFriction,
    count: usize,
    slides: usize,
}

impl<M: GuardedContacts> ContactPoint<'_, M> {
    fn is_coupled(&self) -> bool {
        self.system.is_coupled(self.mode.structure)
    }

    /// Whether frictions act that change each other's limits.
    pub(super) fn has_coupled_forces(&self) -> bool {
        self.acting().next().is_some() && self.is_coupled()
    }

    fn acting(&self) -> impl Iterator<Item = usize> + use<M> {
        let contacts = self.mode.contacts;
        contacts.sliding().iter().chain(contacts.sticking()).take(MAX_FRICTIONS)
    }

    /// Adds to `flow`, the derivative without friction, all forces that act.
    pub(super) fn coupled(&self, flow: M::State) -> ContactMotion<M::State> {
        let slides = self.mode.contacts.sliding().len();
        let mut equations =
            CoupledForces { a: [[0.0; _]; _], b: [0.0; _], sizes: [0.0; _], count: 0, slides };
        let mut responses = [M::State::ZERO; MAX_FRICTIONS];
        for (response, contact) in responses.iter_mut().zip(self.acting()) {
            *response = self.response(contact);
        }
        for (row, contact) in self.acting().enumerate() {
            let (entries, right) = if row < slides {
                self.slide_row((row, contact))
            } else {
                held_row(&self.slip(contact), &flow, &responses)
            };
            (equations.a[row], equations.b[row]) = (entries, right);
            equations.sizes[row] = entries[row].abs();
            equations.count = row + 1;
        }
        let solution = equations.solved();
        let (mut flow, mut forces) = (flow, FrictionForces::NONE);
        for ((contact, force), response) in self.acting().zip(solution).zip(&responses) {
            flow = flow.plus(force, response);
            forces.add(contact, force);
        }
        ContactMotion { flow, forces }
    }

    fn slide_row(&self, (row, contact): (usize, usize)) -> (PerFriction, f64) {
        let sign = self.mode.contacts.state(contact).slip_sign();
        let mut entries = [0.0; MAX_FRICTIONS];
        for (entry, other) in entries.iter_mut().zip(self.acting()) {
            *entry = sign * self.pressed(ContactGuard::Friction(contact), other).kinetic;
        }
        entries[row] += 1.0;
        (entries, -sign * self.limits(contact).kinetic)
    }

    fn pressed(&self, pressed: ContactGuard, by: usize) -> super::FrictionLimits {
        self.system.pressed_by(self.mode.structure, by, pressed, self.x, self.input)
    }

    /// Returns the largest force that holds `contact` (N), pressed by `forces`.
    pub(super) fn stiction(&self, contact: usize, forces: &FrictionForces) -> f64 {
        let own = self.limits(contact).stiction;
        if !self.is_coupled() {
            return own;
        }
        let pressed = ContactGuard::Friction(contact);
        let more = forces.iter().map(|(by, force)| force * self.pressed(pressed, by).stiction);
        (own + more.sum::<f64>()).max(0.0)
    }

    /// Returns a guard of the structure with what frictions add to it; its rate by differences
    /// where they do.
    pub(super) fn structure_guard(&self, guard: GuardId) -> GuardValue {
        let pressed = ContactGuard::Structure(guard);
        let at = |point: &ContactPoint<'_, M>| {
            point.system.structure_guard(point.mode.structure, guard, point.x, point.input)
        };
        let own = at(self);
        let is_pressed = |by| self.pressed(pressed, by).stiction != 0.0;
        if !self.is_coupled() || !self.acting().any(is_pressed) {
            return own;
        }
        let whole = |point: &ContactPoint<'_, M>, forces: &FrictionForces| {
            let more = forces.iter().map(|(by, force)| force * point.pressed(pressed, by).stiction);
            at(point).value + more.sum::<f64>()
        };
        let motion = self.motion();
        let dt = M::MOMENT;
        let [late, early] = [dt, -dt]
            .map(|dt| self.after(dt, &motion.flow, |point| whole(point, &point.motion().forces)));
        GuardValue::new(whole(self, &motion.forces), (late - early) / (2.0 * dt))
    }
}

fn held_row<S: crate::State>(
    slip: &Surface<S>,
    flow: &S,
    responses: &[S; MAX_FRICTIONS],
) -> (PerFriction, f64) {
    (core::array::from_fn(|column| slip.slope(&responses[column])), -slip.rate(flow))
}

impl CoupledForces {
    /// Eliminates row by row; a stick that others hold gets no force.
    fn solved(mut self) -> PerFriction {
        for k in 0..self.count {
            let pivot = self.a[k][k];
            if k < self.slides && (pivot <= 0.0 || pivot.is_nan()) {
                return [f64::NAN; MAX_FRICTIONS];
            }
            if k >= self.slides && pivot.abs() <= DEPENDENT * self.sizes[k] {
                self.a[k][k] = f64::INFINITY;
            }
            self.eliminate(k);
        }
        let mut forces = [0.0; MAX_FRICTIONS];
        for k in (0..self.count).rev() {
            let known: f64 = (k + 1..self.count).map(|j| self.a[k][j] * forces[j]).sum();
            forces[k] = (self.b[k] - known) / self.a[k][k];
        }
        forces
    }

    fn eliminate(&mut self, k: usize) {
        let (row, right) = (self.a[k], self.b[k]);
        for i in k + 1..self.count {
            let by = self.a[i][k] / row[k];
            for (entry, own) in self.a[i].iter_mut().zip(&row).skip(k + 1) {
                *entry -= by * own;
            }
            self.b[i] -= by * right;
        }
    }
}
