use crate::contacts::MAX_FRICTIONS;

/// Friction forces (N, or N m), each in the direction of positive slip.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FrictionForces {
    contacts: [u8; MAX_FRICTIONS],
    forces: [f64; MAX_FRICTIONS],
    len: usize,
}

impl FrictionForces {
    pub const NONE: Self =
        Self { contacts: [0; MAX_FRICTIONS], forces: [0.0; MAX_FRICTIONS], len: 0 };

    pub(super) fn add(&mut self, contact: usize, force: f64) {
        let Ok(number) = u8::try_from(contact) else { return };
        if self.len < MAX_FRICTIONS {
            (self.contacts[self.len], self.forces[self.len]) = (number, force);
            self.len += 1;
        }
    }

    /// Returns the force at `contact` (N), 0 where no friction acts.
    pub fn at(&self, contact: usize) -> f64 {
        self.iter().find(|(number, _)| *number == contact).map_or(0.0, |(_, force)| force)
    }

    /// Returns the contacts at which friction acts, with their forces (N).
    pub fn iter(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        let contacts = self.contacts.iter().map(|contact| usize::from(*contact));
        contacts.zip(self.forces).take(self.len)
    }
}
