//! A light, so that a builder sees which board is which.

record! {
    /// Blink.
    Light {
        /// For how long (s); 0 stops.
        seconds: u8,
    }
}
