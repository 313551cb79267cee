//! Conversions of numbers to a screen's accuracy.

#[expect(clippy::cast_possible_truncation, reason = "a pixel has no more")]
pub(crate) const fn f32(x: f64) -> f32 {
    x as f32
}

pub(crate) const fn f64(n: usize) -> f64 {
    n as f64
}

/// Returns the whole number below `x`; 0 if there is none.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a cast saturates, and NaN becomes 0"
)]
pub(crate) const fn floor(x: f64) -> u64 {
    x as u64
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a cast saturates, and NaN becomes 0"
)]
pub(crate) const fn index(x: f64) -> usize {
    x as usize
}

pub(crate) fn key(n: u32) -> Option<u8> {
    u8::try_from(n).ok().and_then(telemetry::KeyIndex::new).map(telemetry::KeyIndex::number)
}

/// Returns the largest of 1, 2 and 5 times a power of ten up to `x`; 1 if there is none.
pub(crate) fn round(x: f64) -> f64 {
    if !(x.is_finite() && 0.0 < x) {
        return 1.0;
    }
    let ten = 10_f64.powf(x.log10().floor());
    let lead = x / ten;
    let step = if lead < 2.0 {
        1.0
    } else if lead < 5.0 {
        2.0
    } else {
        5.0
    };
    step * ten
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounds_down_to_one_two_or_five() {
        for (x, rounded) in [(0.9, 0.5), (1.0, 1.0), (3.7, 2.0), (72.0, 50.0), (0.024, 0.02)] {
            assert!((round(x) / rounded - 1.0).abs() < 1e-9, "{x}: {}", round(x));
        }
        for x in [0.0, -3.0, f64::NAN, f64::INFINITY] {
            assert!((round(x) - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn only_88_numbers_are_keys() {
        assert_eq!(key(0), Some(0));
        assert_eq!(key(87), Some(87));
        for other in [88, 255, 256, u32::MAX] {
            assert_eq!(key(other), None);
        }
    }
}
