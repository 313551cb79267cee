//! The way into a board's bootloader, so that its firmware can be changed without its case open.

record! {
    /// Ends the firmware, and starts the bootloader; how that is spoken to is the board's own.
    Bootloader {
        /// [`MAGIC`], so that nothing else is taken for it.
        magic: [u8; 4],
    }
}

/// What the request must contain.
pub const MAGIC: [u8; 4] = *b"BOOT";
