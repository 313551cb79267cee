//! A simulated board's finger, played over a real link; real boards answer that it is impossible.

record! {
    /// A gesture on one key; it is appended to the waiting ones.
    Finger {
        /// Place of the key on the board, from 0.
        slot: u8,
        /// 0 pressed, 1 struck, 255 forget all gestures of the key.
        touch: u8,
        /// Time at which the finger meets the key (us).
        start_us: u32,
        /// Time at which it lets go (us).
        release_us: u32,
        /// Speed of the finger (um/s).
        speed: u32,
        /// Depth at which it holds the key (um).
        hold: u32,
        /// Depth at which a pressed finger starts (um).
        from: u32,
        /// Time that lifting takes (us); 0 is 50 ms.
        lift: u32,
    }
}

/// Value of `touch` for a finger that rests on the key and presses it.
pub const PRESSED: u8 = 0;
/// Value of `touch` for a finger that moves when it meets the key.
pub const STRUCK: u8 = 1;
/// Value of `touch` that removes all gestures of a key.
pub const FORGET: u8 = 255;
