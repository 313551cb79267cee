//! Models made of a table and of functions by number, as models of the catalogue.
//!
//! A built-in model is one, of emitted Rust, and so is a description that is read while the program
//! runs. One with contacts is a `WithContacts` of the same (`contacts.rs`).

mod contacts;
mod drawing;

use core::fmt;

use equations::table::{Arguments, FunctionId, Functions, MidiTable, ModelTable};
use equations::{EquationModel, ModeNumber};
use pode::{GuardId, Motion};

use crate::describe::{Damper, Described, Playable, Sounding};
use crate::draw::Sketch;
use crate::entry::ModelEntry;
use crate::mode_code::ModeCode;

pub use contacts::MAX_CODED_CONTACTS;

/// The functions of a model of the catalogue, and its entry there.
#[derive(Clone, Copy)]
pub struct LoadedFunctions<F = &'static dyn Functions> {
    functions: F,
    entry: &'static ModelEntry,
}

impl LoadedFunctions {
    /// The functions of the model that `entry` is about.
    pub const fn new(functions: &'static dyn Functions, entry: &'static ModelEntry) -> Self {
        Self { functions, entry }
    }

    /// The same as functions of a type of their own.
    pub(crate) const fn of_type<F>(self, functions: F) -> LoadedFunctions<F> {
        LoadedFunctions { functions, entry: self.entry }
    }
}

impl<F> fmt::Debug for LoadedFunctions<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("LoadedFunctions").field(&self.entry.name).finish()
    }
}

impl<F: Functions> Functions for LoadedFunctions<F> {
    #[inline]
    fn call(&self, function: FunctionId, arguments: &Arguments<'_>, out: &mut [f64]) {
        self.functions.call(function, arguments, out);
    }

    #[expect(clippy::inline_always, reason = "what is called is to be part of the step")]
    #[inline(always)]
    fn derivative(&self, function: FunctionId, arguments: &Arguments<'_>, out: &mut [f64]) {
        self.functions.derivative(function, arguments, out);
    }

    #[expect(clippy::inline_always, reason = "what is called is to be part of the step")]
    #[inline(always)]
    fn readout(&self, function: FunctionId, arguments: &Arguments<'_>, out: &mut [f64]) {
        self.functions.readout(function, arguments, out);
    }

    #[expect(clippy::inline_always, reason = "what is called is to be part of the step")]
    #[inline(always)]
    fn guard(&self, function: FunctionId, arguments: &Arguments<'_>, out: &mut [f64]) {
        self.functions.guard(function, arguments, out);
    }

    #[expect(clippy::inline_always, reason = "what is called is to be part of the step")]
    #[inline(always)]
    fn bound(&self, function: FunctionId, arguments: &Arguments<'_>, out: &mut [f64]) {
        self.functions.bound(function, arguments, out);
    }
}

/// The damper of a table, and the speed below which nothing sounds (m/s); the usual ones where it says nothing.
fn damper(table: &ModelTable) -> (Damper, f64) {
    table.damper.map_or((Damper::USUAL, Damper::USUAL_SOFTEST_TONE), |it| {
        (Damper { lift: it.lift, fall: it.fall }, it.softest_tone)
    })
}

impl<F, const N: usize, const C: usize> Described for EquationModel<LoadedFunctions<F>, N, C>
where
    F: Functions + Copy + 'static,
{
    fn entry(&self) -> &'static ModelEntry {
        self.functions().entry
    }

    /// What fitted once fits again.
    fn with_values(&self, values: &[f64]) -> Self {
        Self::new(self.table(), *self.functions(), values).unwrap_or(*self)
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

    fn unmet(&self, tell: &mut dyn FnMut(&'static str)) {
        Self::unmet(self).for_each(|condition| tell(condition.text));
    }

    fn at_rest(&self, input: &Motion) -> (ModeNumber, [f64; N]) {
        self.at_rest(input)
    }
}

impl<F, const N: usize, const C: usize> Playable for EquationModel<LoadedFunctions<F>, N, C>
where
    F: Functions + Copy + 'static,
{
    fn damper(&self) -> Damper {
        damper(self.table()).0
    }

    fn softest_tone(&self) -> f64 {
        damper(self.table()).1
    }

    fn midi(&self) -> &'static MidiTable {
        &self.table().midi
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
