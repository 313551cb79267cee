//! The way into a board's bootloader, so that its firmware can be changed without its case open.

record! {
    /// Ends the firmware, and starts the bootloader; how that is spoken to is the board's own.
    Bootloader {
        /// `42 4F 4F 54`, the letters BOOT; another value is answered with `BadValue`.
        magic: [u8; 4],
    }
}

/// What the request must contain.
pub const MAGIC: [u8; 4] = *b"BOOT";
