//! The energy of a model with contacts.

use contacts::{ContactIndices, EnergeticContacts, FrictionForces};
use pode::Motion;

use crate::mode_number::ModeNumber;
use crate::model::EquationModel;
use crate::table::Functions;

impl<F: Functions + Copy, const N: usize, const C: usize> EnergeticContacts
    for EquationModel<F, N, C>
{
    fn energy(
        &self,
        mode: ModeNumber,
        closed: ContactIndices,
        x: &[f64; N],
        input: &Motion,
    ) -> f64 {
        pode::Energetic::energy(self, mode, x, input)
            + self.contact_sum((mode, closed), 1, x, input)
    }

    fn supplied(
        &self,
        mode: ModeNumber,
        closed: ContactIndices,
        forces: &FrictionForces,
        x: &[f64; N],
        input: &Motion,
    ) -> f64 {
        pode::Energetic::supplied(self, mode, x, input)
            + self.contact_sum((mode, closed), 2, x, input)
            + self.friction_readout(mode, forces, x, input) * input.rate
    }

    fn dissipated(
        &self,
        mode: ModeNumber,
        closed: ContactIndices,
        x: &[f64; N],
        input: &Motion,
    ) -> f64 {
        pode::Energetic::dissipated(self, mode, x, input)
            + self.contact_sum((mode, closed), 3, x, input)
    }
}
