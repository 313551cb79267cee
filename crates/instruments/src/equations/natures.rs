//! Natures of the modes with these parameters: kinds, rates, longest steps.

use pode::{EquationKind, Nature, Part};

use crate::equations::mode_number::ModeNumber;
use crate::equations::table::ModeTable;

/// Maximum number of modes of an [`EquationModel`](crate::equations::EquationModel).
pub const MAX_MODES: usize = 32;

/// Maximum number of parts of all modes with several; further ones have the nature of their mode.
pub(crate) const MAX_MODE_PARTS: usize = 24;

/// The natures of all modes, and the parts of modes with several.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct ModeNatures {
    pub(crate) modes: [ModeNature; MAX_MODES],
    pub(crate) parts: [Part; MAX_MODE_PARTS],
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct ModeNature {
    pub(crate) nature: Nature,
    /// Index of the first of its parts; beyond the list the table's parts count.
    pub(crate) first: usize,
}

impl Default for ModeNatures {
    fn default() -> Self {
        let nature = Nature::new(EquationKind::Smooth, 0.0);
        let mode = ModeNature { nature, first: MAX_MODE_PARTS };
        Self { modes: [mode; MAX_MODES], parts: [Part::WHOLE; MAX_MODE_PARTS] }
    }
}

impl ModeNatures {
    fn mode(&self, mode: ModeNumber) -> &ModeNature {
        &self.modes[usize::from(mode.0) % MAX_MODES]
    }

    #[inline]
    pub(crate) fn nature(&self, mode: ModeNumber) -> Nature {
        self.mode(mode).nature
    }

    /// Returns the parts of `mode`; the table's if it has only one.
    #[inline]
    pub(crate) fn parts<'a>(&'a self, mode: ModeNumber, table: &'a ModeTable) -> &'a [Part] {
        let first = self.mode(mode).first;
        self.parts
            .get(first..first + table.parts.len())
            .filter(|_| first < MAX_MODE_PARTS)
            .unwrap_or(&table.part_list)
    }
}
