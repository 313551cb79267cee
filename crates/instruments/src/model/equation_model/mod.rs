//! Playable models from a table and functions by number; `contacts` adds contacts.

mod contacts;
mod drawing;

use alloc::sync::Arc;

use crate::equations::{EquationModel, ModeNumber};
use pode::{GuardId, Motion};

use crate::model::describe::{Described, NamedModes, Playable, Sounding};
use crate::model::draw::Sketch;
use crate::model::mode_code::ModeCode;
use crate::model::parts::ModelParts;

pub(super) use contacts::decoded;

impl<const N: usize, const C: usize> NamedModes for EquationModel<Arc<ModelParts>, N, C> {
    fn shared(&self) -> &Arc<ModelParts> {
        self.functions()
    }

    fn mode_code(&self, mode: ModeNumber) -> ModeCode {
        ModeCode::structural(mode.0)
    }

    fn mode(&self, code: ModeCode) -> Option<ModeNumber> {
        let is_one = usize::from(code.structure()) < self.table().modes.len();
        (is_one && code.contacts() == 0).then_some(ModeNumber(code.structure()))
    }
}

impl<const N: usize, const C: usize> Described for EquationModel<Arc<ModelParts>, N, C> {
    fn with_values(&self, values: &[f64]) -> Self {
        self.with_values(values)
    }

    fn outputs(&self, mode: ModeNumber, x: &[f64; N], input: &Motion, out: &mut [f64]) {
        self.outputs(mode, x, input, out);
    }

    fn unmet(&self, report: &mut dyn FnMut(&str)) {
        Self::unmet(self).for_each(|condition| report(&condition.text));
    }

    fn at_rest(&self, input: &Motion) -> (ModeNumber, [f64; N]) {
        self.at_rest(input)
    }
}

impl<const N: usize, const C: usize> Playable for EquationModel<Arc<ModelParts>, N, C> {
    fn input_per_metre(&self) -> f64 {
        self.input_per_metre()
    }

    fn sounding(&self, guard: GuardId, before: &[f64; N]) -> Option<Sounding> {
        self.sounding(guard, before).map(|speed| Sounding { speed })
    }

    fn draw(&self, sketch: &mut dyn Sketch) {
        drawing::draw(self, sketch);
    }
}
