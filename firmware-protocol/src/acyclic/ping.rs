//! What time a board's clock shows.

record! {
    /// The board's time when it answered.
    Pong {
        /// Its clock (us); wraps after 71 minutes.
        board_us: u32,
    }
}

/// Largest drift of a board's clock that is accepted, faster or slower (1e-6): RC oscillators
/// without trimming keep to it.
pub const CLOCK_TOLERANCE_PPM: u32 = 30_000;
