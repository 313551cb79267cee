//! Models made of a table and of functions by number, as what a key can play.
//!
//! One with contacts is a `WithContacts` of the same (`contacts.rs`).

mod contacts;
mod drawing;

use alloc::sync::Arc;

use crate::equations::table::{MidiTable, ModelTable};
use crate::equations::{EquationModel, ModeNumber};
use pode::{GuardId, Motion};

use crate::model::describe::{Damper, Described, Playable, Sounding};
use crate::model::draw::Sketch;
use crate::model::mode_code::ModeCode;
use crate::model::parts::ModelParts;

pub use contacts::MAX_CODED_CONTACTS;

/// The damper of a table, and the speed below which nothing sounds (m/s); the usual ones where it says nothing.
fn damper(table: &ModelTable) -> (Damper, f64) {
    table.damper.map_or((Damper::USUAL, Damper::USUAL_SOFTEST_TONE), |it| {
        (Damper { lift: it.lift, fall: it.fall }, it.softest_tone)
    })
}

impl<const N: usize, const C: usize> Described for EquationModel<Arc<ModelParts>, N, C> {
    fn shared(&self) -> &Arc<ModelParts> {
        self.functions()
    }

    fn with_values(&self, values: &[f64]) -> Self {
        self.with_values(values)
    }

    fn mode_code(&self, mode: ModeNumber) -> ModeCode {
        ModeCode::structural(mode.0)
    }

    fn mode(&self, code: ModeCode) -> Option<ModeNumber> {
        let is_one = usize::from(code.structure()) < self.table().modes.len();
        (is_one && code.contacts() == 0).then_some(ModeNumber(code.structure()))
    }

    fn outputs(&self, mode: ModeNumber, x: &[f64; N], input: &Motion, out: &mut [f64]) {
        self.outputs(mode, x, input, out);
    }

    fn unmet(&self, tell: &mut dyn FnMut(&str)) {
        Self::unmet(self).for_each(|condition| tell(&condition.text));
    }

    fn at_rest(&self, input: &Motion) -> (ModeNumber, [f64; N]) {
        self.at_rest(input)
    }
}

impl<const N: usize, const C: usize> Playable for EquationModel<Arc<ModelParts>, N, C> {
    fn damper(&self) -> Damper {
        damper(self.table()).0
    }

    fn softest_tone(&self) -> f64 {
        damper(self.table()).1
    }

    fn midi(&self) -> MidiTable {
        self.table().midi
    }

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
