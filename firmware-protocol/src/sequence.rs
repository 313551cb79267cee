//! The counter in every frame's header, and what a frame's number says about those before it.

/// A frame's number; the next one is greater by one, and 0 follows 255.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Sequence(pub u8);

impl Sequence {
    /// The number of the frame after this one.
    #[must_use]
    pub const fn next(self) -> Self {
        Self(self.0.wrapping_add(1))
    }

    /// How a frame with this number stands to the newest one before it, `newest`.
    ///
    /// The number wraps around, so half of the circle counts as newer: whoever heard
    /// nothing for 127 frames must forget `newest` rather than ask.
    pub const fn after(self, newest: Self) -> Arrival {
        match self.0.wrapping_sub(newest.0) {
            0 => Arrival::Repeated,
            ahead @ 1..=127 => Arrival::Newer { missing: ahead - 1 },
            128..=255 => Arrival::Older,
        }
    }
}

/// How a frame stands to the newest one before it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[must_use]
pub enum Arrival {
    /// It is newer.
    Newer {
        /// How many between the two never came, or have not come yet.
        missing: u8,
    },
    /// It is the same one again.
    Repeated,
    /// It was overtaken on its way.
    Older,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_go_on_across_the_wrap() {
        assert_eq!(Sequence(255).next(), Sequence(0));
        assert_eq!(Sequence(0).after(Sequence(255)), Arrival::Newer { missing: 0 });
        assert_eq!(Sequence(3).after(Sequence(254)), Arrival::Newer { missing: 4 });
    }

    #[test]
    fn a_repeated_and_an_overtaken_frame_are_told_apart() {
        assert_eq!(Sequence(7).after(Sequence(7)), Arrival::Repeated);
        assert_eq!(Sequence(6).after(Sequence(7)), Arrival::Older);
        assert_eq!(Sequence(254).after(Sequence(3)), Arrival::Older);
    }
}
