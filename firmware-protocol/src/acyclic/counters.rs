//! Counters of a board.

record! {
    /// Counts since the board started; each stops at its largest value.
    Counters {
        /// Frames of samples that were sent.
        samples: u32,
        /// Frames of forces that were taken.
        forces: u32,
        /// Pieces of the byte stream that were no frames.
        corrupt: u32,
        /// Frames that were not understood, and forces while it was not armed.
        refused: u32,
        /// Frames of forces that were stale.
        stale: u32,
        /// Samples that were never answered.
        unanswered: u32,
        /// Times that forces expired.
        trips: u16,
        /// Times that it was armed.
        armings: u16,
        /// Oldest samples that a taken force answered (us).
        oldest_us: u32,
        /// Samples that the link did not take.
        unsent: u32,
    }
}
