//! Which samples a board shall send, and how often; zero stops them.

record! {
    /// The samples that are wanted.
    Stream {
        /// Time between two frames (us); 0 for none.
        period_us: u16,
        /// Number of a [`crate::frame::key_samples::SamplePacking`].
        packing: u8,
        /// When in its period this board shall begin to send (us), so that boards on a bus begin in
        /// turns: by the bus's time where it knows that, else from the request on.
        phase_us: u16,
    }
}
