//! What a board keeps of a key's calibration.
//!
//! The host has more in its file; this is what the board itself needs: where the ends are, for
//! its own fault detection, and how strong the motor really is.

record! {
    /// Asks for the calibration of the key in a slot.
    ReadCalibration {
        /// Place of the key on the board, from 0.
        slot: u8,
    }
}

record! {
    /// The calibration of the key in a slot.
    KeyCalibration {
        /// Place of the key on the board, from 0.
        slot: u8,
        /// Reading at rest (counts).
        rest: i32,
        /// Reading at the key bottom (counts), above `rest`.
        bottom: i32,
        /// Force of the motor for 1 N asked, in thousandths.
        gain_permille: u16,
    }
}
