//! Energy and powers of a model, and the slopes of its readout.

use pode::{Energetic, EnergyBalance, Motion, ReadoutSlopes, Sloped};

use crate::equations::mode_number::ModeNumber;
use crate::equations::model::EquationModel;
use crate::equations::table::Equations;

impl<F: Equations + Clone, const N: usize, const C: usize> Energetic for EquationModel<F, N, C> {
    fn energy(&self, mode: ModeNumber, x: &[f64; N], input: &Motion) -> f64 {
        self.balance_of_input(mode, x, input).energy
    }

    fn supplied(&self, mode: ModeNumber, x: &[f64; N], input: &Motion) -> f64 {
        self.balance_of_input(mode, x, input).supplied
    }

    fn dissipated(&self, mode: ModeNumber, x: &[f64; N], input: &Motion) -> f64 {
        self.balance_of_input(mode, x, input).dissipated
    }

    /// Computes all three at once: they share most of their terms.
    #[inline]
    fn balance_of_input(&self, mode: ModeNumber, x: &[f64; N], input: &Motion) -> EnergyBalance {
        let [energy, supplied, dissipated] =
            self.values(self.mode_table(mode).forces.balance, x, input);
        EnergyBalance { energy, supplied, dissipated }
    }
}

impl<F: Equations + Clone, const N: usize, const C: usize> Sloped for EquationModel<F, N, C> {
    fn slopes(&self, mode: ModeNumber, x: &[f64; N], input: &Motion) -> ReadoutSlopes {
        let [per_position, per_rate] = self.values(self.mode_table(mode).forces.slopes, x, input);
        ReadoutSlopes { per_position, per_rate }
    }
}
