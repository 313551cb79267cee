//! What a board keeps of a key's calibration.
//!
//! The host has more in its file; this is what the board itself needs: where the ends are, for
//! its own fault detection, and how strong the motor really is.

record! {
    /// Asks for the calibration of the key in a slot.
    ReadCalibration {
        slot: u8,
    }
}

record! {
    /// The calibration of the key in a slot.
    KeyCalibration {
        slot: u8,
        /// Reading at rest (counts).
        rest: i32,
        /// Reading at the key bottom (counts).
        bottom: i32,
        /// Force of the motor for a force of 1 N asked for, in thousandths.
        gain_permille: u16,
    }
}
