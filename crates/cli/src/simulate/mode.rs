use instruments::{Described, ModeName};

/// Returns the name of a mode: the structural one's, with the contacts that are not open.
pub(super) fn mode_name<M: Described>(model: &M, mode: M::Mode) -> String {
    ModeName { model: model.shared(), mode: model.mode_code(mode) }.to_string()
}

pub(super) fn mode_index<M: Described>(model: &M, mode: M::Mode) -> usize {
    model.mode_code(mode).structure().into()
}
