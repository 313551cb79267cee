//! Modes as numbers, for code without the type of a model's modes.

/// A mode of a model as a number: the structural mode in its low 8 bits, and above them the states
/// of its contacts, 0 where all are open or there are none.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct ModeCode(pub u64);

impl ModeCode {
    /// Width of the structural mode (bits).
    pub const STRUCTURE_BITS: u32 = 8;
    /// A number that no mode has.
    pub const NONE: Self = Self(u64::MAX);

    /// Returns the structural mode with this index in the model's list, with all contacts open.
    pub const fn structural(index: u8) -> Self {
        Self(index as u64)
    }

    /// Returns the structural mode with this index, with the contacts in the states of `code`.
    #[must_use]
    pub const fn with_contacts(index: u8, code: u64) -> Self {
        Self(code << Self::STRUCTURE_BITS | index as u64)
    }

    pub const fn structure(self) -> u8 {
        self.0.to_le_bytes()[0]
    }

    pub const fn contacts(self) -> u64 {
        self.0 >> Self::STRUCTURE_BITS
    }

    /// Returns the mode with this number among those of a model without contacts.
    pub fn of<T: Copy>(self, modes: &[T]) -> Option<T> {
        if self.contacts() == 0 { modes.get(usize::from(self.structure())).copied() } else { None }
    }
}
