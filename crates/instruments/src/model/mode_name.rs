//! The name of a mode, as text.

use core::fmt;

use crate::model::describe::Described;
use crate::model::mode_code::ModeCode;

/// Writes the name of a mode of a model: that of the structural mode, and behind it the contacts
/// that are not open.
#[derive(Clone, Copy, Debug)]
pub struct ModeName<'a, M> {
    model: &'a M,
    mode: ModeCode,
}

impl<'a, M: Described> ModeName<'a, M> {
    /// The name of the mode with this number in `model`.
    pub const fn new(model: &'a M, mode: ModeCode) -> Self {
        Self { model, mode }
    }
}

impl<M: Described> fmt::Display for ModeName<'_, M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.model.write_mode(self.mode, f)
    }
}
