//! The time of a board's clock.

record! {
    /// The board's time when it answered.
    Pong {
        /// The board's clock when it answers (us); wraps.
        board_us: u32,
    }
}

/// Largest accepted drift of a board's clock (1e-6), either way: within it are untrimmed RC clocks.
pub const CLOCK_TOLERANCE_PPM: u32 = 30_000;
