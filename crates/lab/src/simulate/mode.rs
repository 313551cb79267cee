//! Modes by their place in the model's list.

use models::Described;

/// Returns the name of a mode.
pub(super) fn mode_name<M: Described>(mode: M::Mode) -> &'static str {
    M::MODES.get(mode_index::<M>(mode)).map_or("?", |(_, name)| name)
}

/// Returns which of the model's modes `mode` is.
pub(super) fn mode_index<M: Described>(mode: M::Mode) -> usize {
    M::MODES.iter().position(|(known, _)| *known == mode).unwrap_or(0)
}
