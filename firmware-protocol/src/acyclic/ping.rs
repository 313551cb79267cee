//! The time of a board's clock.

record! {
    /// The board's time when it answered.
    Pong {
        /// The board's clock when it answers (us); wraps.
        board_us: u32,
    }
}

/// Largest accepted drift of a board's clock in either direction (1e-6): untrimmed RC oscillators
/// keep within it.
pub const CLOCK_TOLERANCE_PPM: u32 = 30_000;
