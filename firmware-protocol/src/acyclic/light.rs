//! A light, so that a builder sees which board is which.

record! {
    /// Lets the board blink its light.
    Light {
        /// Time for which the board blinks (s); 0 stops it.
        seconds: u8,
    }
}
