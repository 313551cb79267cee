//! What a board has counted since it started.

record! {
    /// What a board has counted since it started; each stops at its largest value.
    Counters {
        /// Frames of samples that it sent.
        samples: u32,
        /// Frames of forces that it took.
        forces: u32,
        /// Pieces of the stream that were no frames.
        corrupt: u32,
        /// Whole frames that were not to be understood, or not for it.
        refused: u32,
        /// Forces that were stale, and not taken.
        stale: u32,
        /// Samples that were never answered.
        unanswered: u32,
        /// Times that forces expired and it became safe.
        trips: u16,
        /// Times that it was armed.
        armings: u16,
        /// Oldest samples that forces which it rendered answered (us).
        oldest_us: u32,
        /// Samples that it could not send.
        unsent: u32,
    }
}
