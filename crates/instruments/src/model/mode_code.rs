//! Modes as numbers and as text, for what does not know the type of a model's modes.

/// A mode of a model as a number: the structural mode in its low 8 bits, and above them what the
/// contacts of the model do, 0 where all are open or there are none.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct ModeCode(pub u64);

impl ModeCode {
    /// Bits of the structural mode.
    pub const STRUCTURE_BITS: u32 = 8;
    /// A number that no mode has.
    pub const NONE: Self = Self(u64::MAX);

    /// The mode of the structure with this index in the model's list, with all contacts open.
    pub const fn structural(index: u8) -> Self {
        Self(index as u64)
    }

    /// The structural mode with this index, with the contacts in the states that `code` says.
    #[must_use]
    pub const fn with_contacts(index: u8, code: u64) -> Self {
        Self(code << Self::STRUCTURE_BITS | index as u64)
    }

    /// Index of the structural mode in the model's list.
    pub const fn structure(self) -> u8 {
        self.0.to_le_bytes()[0]
    }

    /// What the contacts do, as the model codes it.
    pub const fn contacts(self) -> u64 {
        self.0 >> Self::STRUCTURE_BITS
    }

    /// The mode with this number among those of a model without contacts.
    pub fn of<T: Copy>(self, modes: &[T]) -> Option<T> {
        if self.contacts() == 0 { modes.get(usize::from(self.structure())).copied() } else { None }
    }
}
