//! Which samples a board shall send, and how often; zero stops them.

record! {
    /// The samples that are wanted.
    Stream {
        /// Time between two frames [us]; 0 for none.
        period_us: u16,
        /// [`crate::frame::key_samples::SamplePacking`].
        packing: u8,
        /// When in its period this board shall send [us], so that boards on a bus take turns.
        phase_us: u16,
    }
}
