//! A light that identifies a board to a builder.

record! {
    /// Blinks the light of the board.
    Light {
        /// Time for which the board blinks (s); 0 stops it.
        seconds: u8,
    }
}
