//! The counter in every frame's header, and what a frame's number says about those before it.

/// A frame's number; the next one is greater by one, and 0 follows 255.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct SequenceNumber(pub u8);

impl SequenceNumber {
    /// Returns the number of the frame after this one.
    #[must_use]
    pub const fn next(self) -> Self {
        Self(self.0.wrapping_add(1))
    }

    /// Returns how a frame with this number stands to the newest one before it, `newest`.
    ///
    /// The number wraps around, so half of the circle counts as newer: a receiver that heard
    /// nothing for 127 frames must forget `newest` rather than ask.
    pub const fn after(self, newest: Self) -> FrameOrder {
        match self.0.wrapping_sub(newest.0) {
            0 => FrameOrder::Repeated,
            ahead @ 1..=127 => FrameOrder::Newer { missing: ahead - 1 },
            128..=255 => FrameOrder::Older,
        }
    }
}

/// How a frame stands to the newest one before it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[must_use]
pub enum FrameOrder {
    Newer {
        /// How many between the two never came, or have not come yet.
        missing: u8,
    },
    /// It is the same one again.
    Repeated,
    /// It was overtaken on its way.
    Older,
}
