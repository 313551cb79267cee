//! Packing and rate of a board's samples; zero stops them.

record! {
    /// Requested samples.
    Stream {
        /// Time between two frames (us); 0 stops the samples.
        period_us: u16,
        /// Number of the sample packing.
        packing: u8,
        /// Time in its period at which the board begins to send (us), less than the period, so that
        /// boards on a bus take turns: by the bus's time if the board knows it, else from the
        /// request on.
        phase_us: u16,
    }
}
