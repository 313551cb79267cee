//! Modes by name, and by their place in the model's list.

use instruments::{Described, ModeName};

/// Returns the name of a mode: the structural one's, and what the contacts do that are not open.
pub(super) fn mode_name<M: Described>(model: &M, mode: M::Mode) -> String {
    ModeName::new(model, model.mode_code(mode)).to_string()
}

/// Returns which of the model's structural modes `mode` is.
pub(super) fn mode_index<M: Described>(model: &M, mode: M::Mode) -> usize {
    model.mode_code(mode).structure().into()
}
