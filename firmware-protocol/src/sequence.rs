//! The counter in the header of every cyclic frame, and the order of frames.

/// Number of a frame; the next one is greater by one, and 0 follows 255.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct SequenceNumber(pub u8);

impl SequenceNumber {
    #[must_use]
    pub const fn next(self) -> Self {
        Self(self.0.wrapping_add(1))
    }

    /// Compares a frame with this number with the newest one before it, `newest`.
    ///
    /// The number wraps around, so half of the circle counts as newer: a receiver without frames
    /// for 127 numbers must forget `newest`.
    pub const fn after(self, newest: Self) -> FrameOrder {
        match self.0.wrapping_sub(newest.0) {
            0 => FrameOrder::Repeated,
            ahead @ 1..=127 => FrameOrder::Newer { missing: ahead - 1 },
            128..=255 => FrameOrder::Older,
        }
    }
}

/// Order of a frame relative to the newest one before it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[must_use]
pub enum FrameOrder {
    Newer {
        /// Number of frames between the two that are lost or late.
        missing: u8,
    },
    Repeated,
    Older,
}
