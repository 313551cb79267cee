//! The energy of a model with contacts.

use pode::contacts::{ContactIndices, EnergeticContacts, FrictionForces};
use pode::{Energetic as _, EnergyBalance, Motion};

use crate::equations::mode_number::ModeNumber;
use crate::equations::model::EquationModel;
use crate::equations::table::Equations;

impl<F: Equations + Clone, const N: usize, const C: usize> EnergeticContacts
    for EquationModel<F, N, C>
{
    fn balance(
        &self,
        mode: ModeNumber,
        closed: ContactIndices,
        forces: &FrictionForces,
        x: &[f64; N],
        input: &Motion,
    ) -> EnergyBalance {
        let [_readout, energy, supplied, dissipated] = self.contact_sums((mode, closed), x, input);
        let of_contacts = EnergyBalance { energy, supplied, dissipated };
        let sum = self.balance_of_input(mode, x, input) + of_contacts;
        let [readout, motor] = self.friction_effects(mode, forces, x, input);
        EnergyBalance { supplied: sum.supplied + (readout * input.rate + motor), ..sum }
    }
}
