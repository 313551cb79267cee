//! Health of a board and its keys, and keys without motor. Added by 2.2, for boards with
//! [`crate::frame::hello::feature::HEALTH`].

record! {
    /// Health of a board; in 16 bits the key in slot 0 has bit 0.
    BoardHealth {
        /// Times that the board was started in its life; stops at the largest value.
        boots: u32,
        /// Keys whose encoders know where they are since the start, slot 0 in bit 0.
        homed: u16,
        /// Keys that have failed.
        faults: u16,
        /// Keys whose motors are off by MuteKey.
        muted: u16,
    }
}

record! {
    /// Requests the health of the key in a slot.
    ReadKeyHealth {
        /// Place of the key on the board, from 0.
        slot: u8,
    }
}

record! {
    /// Health of a key.
    KeyHealth {
        /// Number of the key fault, 0 for none.
        fault: u8,
        /// Temperature of the motor (0.1 °C); −32768 if it is not measured.
        temperature: i16,
        /// Current of the motor (mA), positive for a force upwards; −32768 if it is not measured.
        current: i16,
    }
}

record! {
    /// Switches the motor of the key in a slot off, or on again, until the board restarts.
    MuteKey {
        /// Place of the key on the board, from 0.
        slot: u8,
        /// 1 takes the motor off, 0 on; other values are answered with `BadValue`.
        muted: u8,
    }
}

pub const NOT_MEASURED: i16 = i16::MIN;

/// Numbers of key faults.
pub mod key_fault {
    pub const NONE: u8 = 0;
    pub const SENSOR: u8 = 1;
    pub const MOTOR: u8 = 2;
    pub const TOO_HOT: u8 = 3;
    pub const OTHER: u8 = 4;
}
