//! A simulated board's finger: so that a pianist can play over a real link.
//!
//! Real boards have none and answer that the operation is impossible.

record! {
    /// A gesture on one key; a new one is added to those that wait.
    Finger {
        slot: u8,
        /// [`PRESSED`], [`STRUCK`], or [`FORGET`].
        touch: u8,
        /// When the finger meets the key (us), board time.
        start_us: u32,
        /// When it lets go (us), board time.
        release_us: u32,
        /// How fast it moves (um/s).
        speed: u32,
        /// How deep it holds the key (um).
        hold: u32,
        /// Depth at which a pressed finger starts (um): where its key is then.
        from: u32,
        /// Time that lifting takes (us); 0 is the usual one, 50 ms.
        lift: u32,
    }
}

/// The value of `touch` of a finger that lies on the key and presses it.
pub const PRESSED: u8 = 0;
/// The value of `touch` of a finger that is in motion when it meets the key.
pub const STRUCK: u8 = 1;
/// The value of `touch` that forgets all gestures of a key.
pub const FORGET: u8 = 255;
