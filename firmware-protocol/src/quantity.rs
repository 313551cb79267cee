//! Wire units: integers with the unit in their name. Conversions saturate; nothing wraps around.

/// An encoder's reading (counts), 24 bits, down positive.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub struct Counts(i32);

impl Counts {
    pub const MAX: Self = Self(0x7F_FFFF);
    pub const MIN: Self = Self(-0x80_0000);
    pub const LEN: usize = 3;

    pub const fn saturating(counts: i32) -> Self {
        if counts > Self::MAX.0 {
            Self::MAX
        } else if counts < Self::MIN.0 {
            Self::MIN
        } else {
            Self(counts)
        }
    }

    pub const fn get(self) -> i32 {
        self.0
    }

    /// Returns the nearest reading in 16 bits.
    pub fn saturated(self) -> i16 {
        saturated(self.0)
    }

    pub const fn to_le_bytes(self) -> [u8; Self::LEN] {
        let [low, middle, high, _sign] = self.0.to_le_bytes();
        [low, middle, high]
    }

    pub const fn from_le_bytes(bytes: [u8; Self::LEN]) -> Self {
        let [low, middle, high] = bytes;
        // The sign of the upper three bytes is where i32 has it; the shift extends it.
        Self(i32::from_le_bytes([0, low, middle, high]) >> 8)
    }
}

/// A force (mN), 16 bits, up positive.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub struct Millinewtons(i16);

impl Millinewtons {
    /// Largest force, 32.767 N.
    pub const MAX: Self = Self(i16::MAX);
    /// Smallest force, −32.768 N.
    pub const MIN: Self = Self(i16::MIN);
    pub const LEN: usize = 2;

    pub fn saturating(millinewtons: i32) -> Self {
        Self(saturated(millinewtons))
    }

    /// Returns the force (mN).
    pub const fn get(self) -> i16 {
        self.0
    }

    pub const fn to_le_bytes(self) -> [u8; Self::LEN] {
        self.0.to_le_bytes()
    }

    pub const fn from_le_bytes(bytes: [u8; Self::LEN]) -> Self {
        Self(i16::from_le_bytes(bytes))
    }
}

/// A key's speed (0.2 mm/s), 16 bits, down positive: up to 6.5 m/s.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub struct SpeedCode(i16);

impl SpeedCode {
    /// One unit (um/s).
    pub const MICROMETRES_PER_SECOND: i32 = 200;
    pub const LEN: usize = 2;

    /// Returns the nearest speed to `units` (0.2 mm/s) in 16 bits.
    pub fn saturating(units: i32) -> Self {
        Self(saturated(units))
    }

    pub const fn get(self) -> i16 {
        self.0
    }

    pub const fn to_le_bytes(self) -> [u8; Self::LEN] {
        self.0.to_le_bytes()
    }

    pub const fn from_le_bytes(bytes: [u8; Self::LEN]) -> Self {
        Self(i16::from_le_bytes(bytes))
    }
}

/// A slope of the force by position or speed in one byte: a small floating-point number.
///
/// ```text
/// bit 7       sign
/// bits 6..3   exponent e
/// bits 2..0   mantissa m
/// magnitude   m if e = 0, else (8 + m) 2^(e − 1)
/// ```
///
/// Exact up to 15, then to one part in nine towards zero, up to 245 760. Stiffness counts in
/// 0.25 N/m (61 kN/m at most), damping in 0.001 N s/m (245 N s/m at most). That is fine enough:
/// the force is exact where the samples were taken, and the slope only extrapolates it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct SlopeCode(u8);

impl SlopeCode {
    /// One unit of stiffness (mN/m).
    pub const STIFFNESS_UNIT: i32 = 250;
    /// One unit of damping (mN s/m).
    pub const DAMPING_UNIT: i32 = 1;
    pub const MAX: i32 = 15 << 14;

    /// Rounds `units` towards zero.
    pub const fn toward_zero(units: i32) -> Self {
        let magnitude = if units.unsigned_abs() < Self::MAX.unsigned_abs() {
            units.unsigned_abs()
        } else {
            Self::MAX.unsigned_abs()
        };
        // The leading one of a magnitude of at least 8 is at bit 3 + (e − 1).
        let shift = if magnitude < 8 { 0 } else { 28 - magnitude.leading_zeros() };
        let mantissa = magnitude >> shift;
        let code = if magnitude < 8 { mantissa } else { (shift + 1) << 3 | mantissa & 7 };
        let [code, ..] = code.to_le_bytes();
        Self(if units < 0 && code != 0 { code | 0x80 } else { code })
    }

    pub const fn get(self) -> i32 {
        let (exponent, mantissa) = (self.0 >> 3 & 0xF, (self.0 & 7) as i32);
        let magnitude = if exponent == 0 { mantissa } else { (8 + mantissa) << (exponent - 1) };
        if self.0 & 0x80 == 0 { magnitude } else { -magnitude }
    }

    pub const fn code(self) -> u8 {
        self.0
    }

    /// Decodes a byte; every byte is valid.
    pub const fn from_code(code: u8) -> Self {
        Self(code)
    }
}

fn saturated(value: i32) -> i16 {
    let outside = if value < 0 { i16::MIN } else { i16::MAX };
    i16::try_from(value).unwrap_or(outside)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reading_outside_24_bits_and_a_force_outside_16_stop_at_the_edge() {
        assert_eq!(Counts::saturating(i32::MAX), Counts::MAX);
        assert_eq!(Counts::saturating(i32::MIN), Counts::MIN);
        assert_eq!(Millinewtons::saturating(40_000), Millinewtons::MAX);
        assert_eq!(Millinewtons::saturating(-40_000), Millinewtons::MIN);
    }

    #[test]
    fn a_slope_is_exact_up_to_15_and_then_to_a_ninth_towards_zero() {
        for units in 0..=SlopeCode::MAX {
            let (up, down) = (SlopeCode::toward_zero(units), SlopeCode::toward_zero(-units));
            assert_eq!(up.get(), -down.get());
            let lost = units - up.get();
            assert!(
                0 <= lost && 9 * lost <= units && (15 < units || lost == 0),
                "{units} became {}",
                up.get()
            );
        }
        assert_eq!(SlopeCode::toward_zero(i32::MAX).get(), SlopeCode::MAX);
        assert_eq!(SlopeCode::toward_zero(i32::MIN).get(), -SlopeCode::MAX);
    }

    #[test]
    fn every_byte_is_a_slope_that_keeps_its_value() {
        for code in 0..=u8::MAX {
            let slope = SlopeCode::from_code(code);
            assert_eq!(SlopeCode::toward_zero(slope.get()).get(), slope.get());
        }
    }
}
