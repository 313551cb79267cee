//! Flags of a key's rows.

use crate::KeyBlock;

impl KeyBlock {
    /// Bit of `flags`: the key rests and its voice sleeps.
    pub const ASLEEP: u8 = 1;
    /// Bits of `flags` that describe a row. A row with [`Self::ASLEEP`] alone holds until the next.
    pub const STATE: u8 = 1 | 2 | 4;
    /// Bit of `flags`: rows before are missing.
    pub const MISSING: u8 = 8;

    pub fn mark_missing(&mut self) {
        if let Some(flags) = self.flags.first_mut() {
            *flags |= Self::MISSING;
        }
    }
}
