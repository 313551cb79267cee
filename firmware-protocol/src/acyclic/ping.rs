//! What time a board's clock shows.

record! {
    /// The board's time when it answered.
    Pong {
        /// Its clock (us); wraps after 71 minutes.
        board_us: u32,
    }
}
