//! Outputs, requirements, key ratio, sounds and drawing of a model.

use pode::contacts::MAX_CONTACTS;
use pode::{GuardId, Motion};

use crate::equations::mode_number::ModeNumber;
use crate::equations::model::{EquationModel, rates_of};
use crate::equations::table::{Equations, FunctionId, RequirementTable};

impl<F: Equations + Clone, const N: usize, const C: usize> EquationModel<F, N, C> {
    /// Writes the outputs without friction, as [`Self::outputs_with`].
    pub fn outputs(&self, mode: ModeNumber, x: &[f64; N], input: &Motion, out: &mut [f64]) {
        self.outputs_with(mode, (x, input), &[0.0; MAX_CONTACTS], out);
    }

    /// Writes the outputs in the table's order under the friction forces of the contacts, by their
    /// numbers (N); a shorter `out` receives the first ones.
    pub fn outputs_with(
        &self,
        mode: ModeNumber,
        (x, input): (&[f64; N], &Motion),
        frictions: &[f64; MAX_CONTACTS],
        out: &mut [f64],
    ) {
        /// Maximum number of outputs computed for a shorter `out`.
        const MOST: usize = 64;
        let function = self.mode_table(mode).forces.outputs;
        let count = self.table().outputs.len();
        if out.len() >= count {
            self.call_with(function, (x, &rates_of(input)), frictions, out);
        } else if count <= MOST {
            let mut all = [0.0; MOST];
            self.call_with(function, (x, &rates_of(input)), frictions, &mut all);
            for (place, value) in out.iter_mut().zip(all) {
                *place = value;
            }
        }
    }

    pub fn input_per_metre(&self) -> f64 {
        self.of_constants(self.table().input.per_metre)
    }

    /// Returns the strike's speed (m/s) when `guard` fires from `before`; `None` without a sound.
    pub fn sounding(&self, guard: GuardId, before: &[f64; N]) -> Option<f64> {
        let modes = self.table().modes.iter();
        let mut guards = modes.flat_map(|mode| &mode.guards).filter(|it| it.id == guard.0);
        let sounds = guards.find_map(|guard| guard.sounds)?;
        let [speed] = self.values(sounds, before, &Motion::default());
        Some(speed)
    }

    /// Returns the speed of the strike (m/s) when `contact` closes from the state `before`; `None`
    /// if it opens, or makes no sound.
    pub fn contact_sounding(&self, contact: usize, before: &[f64; N]) -> Option<f64> {
        let modes = self.table().modes.iter();
        let mut tables =
            modes.flat_map(|mode| &mode.contacts).filter(|it| usize::from(it.contact) == contact);
        let sounds = tables.find_map(|table| table.sounds)?;
        let [speed] = self.values(sounds, before, &Motion::default());
        (speed > 0.0).then_some(speed)
    }

    pub fn unmet(&self) -> impl Iterator<Item = &RequirementTable> + '_ {
        let is_unmet = |it: &&RequirementTable| {
            let margin = self.of_constants(it.margin);
            margin.is_nan() || margin <= 0.0
        };
        self.table().constants.requirements.iter().filter(is_unmet)
    }

    /// Writes the numbers of the drawing, if `out` has room for its `count`.
    pub fn drawing_numbers(&self, out: &mut [f64]) {
        let drawing = &self.table().drawing;
        if out.len() >= drawing.count {
            self.call(drawing.numbers, &[0.0; N], &Motion::default(), out);
        }
    }

    pub(crate) fn of_constants(&self, function: FunctionId) -> f64 {
        let [value] = self.values(function, &[0.0; N], &Motion::default());
        value
    }
}
