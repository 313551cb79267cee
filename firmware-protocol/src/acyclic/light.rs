//! A light, so that a builder sees which board is which.

record! {
    /// Lets the board blink its light.
    Light {
        /// For how long (s); 0 stops.
        seconds: u8,
    }
}
