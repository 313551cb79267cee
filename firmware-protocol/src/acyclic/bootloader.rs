//! Entry into a board's bootloader: new firmware without opening the case.

record! {
    /// Ends the firmware, and starts the bootloader, whose protocol is the board's own.
    Bootloader {
        /// `42 4F 4F 54`, the letters BOOT; another value is answered with `BadValue`.
        magic: [u8; 4],
    }
}

pub const MAGIC: [u8; 4] = *b"BOOT";
