//! Wire units: integers whose unit stands in their name.
//!
//! What does not fit is moved to the nearest value that does; nothing wraps around.

/// An encoder's reading [counts], 24 bits, down positive.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub struct Counts(i32);

impl Counts {
    /// The largest reading [counts].
    pub const MAX: Self = Self(0x7F_FFFF);
    /// The smallest reading [counts].
    pub const MIN: Self = Self(-0x80_0000);
    /// Bytes on the wire.
    pub const LEN: usize = 3;

    /// The nearest reading to `counts` that 24 bits hold.
    pub const fn saturating(counts: i32) -> Self {
        if counts > Self::MAX.0 {
            Self::MAX
        } else if counts < Self::MIN.0 {
            Self::MIN
        } else {
            Self(counts)
        }
    }

    /// The reading [counts].
    pub const fn get(self) -> i32 {
        self.0
    }

    /// Little-endian two's complement in three bytes.
    pub const fn to_le_bytes(self) -> [u8; Self::LEN] {
        let [low, middle, high, _sign] = self.0.to_le_bytes();
        [low, middle, high]
    }

    /// Reads what [`Self::to_le_bytes`] wrote.
    pub const fn from_le_bytes(bytes: [u8; Self::LEN]) -> Self {
        let [low, middle, high] = bytes;
        // In the upper three bytes the sign is where i32 has it; the shift spreads it.
        Self(i32::from_le_bytes([0, low, middle, high]) >> 8)
    }
}

/// A force [mN], 16 bits, up positive.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub struct Millinewtons(i16);

impl Millinewtons {
    /// The largest force, 32.767 N.
    pub const MAX: Self = Self(i16::MAX);
    /// The smallest force, −32.768 N.
    pub const MIN: Self = Self(i16::MIN);
    /// Bytes on the wire.
    pub const LEN: usize = 2;

    /// The nearest force to `millinewtons` that 16 bits hold.
    pub fn saturating(millinewtons: i32) -> Self {
        let outside = if millinewtons < 0 { i16::MIN } else { i16::MAX };
        Self(i16::try_from(millinewtons).unwrap_or(outside))
    }

    /// The force [mN].
    pub const fn get(self) -> i16 {
        self.0
    }

    /// Little-endian two's complement.
    pub const fn to_le_bytes(self) -> [u8; Self::LEN] {
        self.0.to_le_bytes()
    }

    /// Reads what [`Self::to_le_bytes`] wrote.
    pub const fn from_le_bytes(bytes: [u8; Self::LEN]) -> Self {
        Self(i16::from_le_bytes(bytes))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reading_outside_24_bits_stops_at_the_edge() {
        assert_eq!(Counts::saturating(i32::MAX), Counts::MAX);
        assert_eq!(Counts::saturating(i32::MIN), Counts::MIN);
        assert_eq!(Counts::saturating(-12).get(), -12);
    }

    #[test]
    fn a_negative_reading_keeps_its_sign_in_three_bytes() {
        assert_eq!(Counts::saturating(-2).to_le_bytes(), [0xFE, 0xFF, 0xFF]);
        for counts in [Counts::MIN, Counts::saturating(-1), Counts::default(), Counts::MAX] {
            assert_eq!(Counts::from_le_bytes(counts.to_le_bytes()), counts);
        }
    }

    #[test]
    fn a_force_outside_16_bits_stops_at_the_edge() {
        assert_eq!(Millinewtons::saturating(40_000), Millinewtons::MAX);
        assert_eq!(Millinewtons::saturating(-40_000), Millinewtons::MIN);
        assert_eq!(Millinewtons::saturating(-500).get(), -500);
    }
}
