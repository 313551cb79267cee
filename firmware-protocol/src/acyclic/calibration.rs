//! The part of a key's calibration that its board needs: travel, to detect faults, and strength.

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
