//! What time a board's clock shows.

record! {
    /// The board's time when it answered.
    Pong {
        /// The board's clock when it answers (us); wraps.
        board_us: u32,
    }
}

/// Largest drift of a board's clock that is accepted, faster or slower (1e-6): RC oscillators
/// without trimming keep to it.
pub const CLOCK_TOLERANCE_PPM: u32 = 30_000;
