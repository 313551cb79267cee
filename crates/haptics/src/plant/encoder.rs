/// An encoder with a fixed displacement per count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Encoder {
    quantum: f64,
}

impl Encoder {
    /// Creates an encoder with `quantum` (m) per count.
    ///
    /// # Panics
    /// Unless `quantum` is finite and positive: a bug in the caller's set-up.
    pub fn new(quantum: f64) -> Self {
        assert!(quantum.is_finite() && 0.0 < quantum, "quantum must be positive, got {quantum}");
        Self { quantum }
    }

    /// Returns the displacement per count (m).
    pub const fn quantum(&self) -> f64 {
        self.quantum
    }

    /// Returns the count nearest to `position` (m), saturated; rounding, not flooring, has no bias.
    pub fn counts(&self, position: f64) -> i32 {
        #[expect(clippy::cast_possible_truncation, reason = "saturation is the contract")]
        let counts = (position / self.quantum).round() as i32;
        counts
    }

    /// Returns the position of `counts` (m), at the middle of the count.
    pub fn position(&self, counts: i32) -> f64 {
        f64::from(counts) * self.quantum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn positions_out_of_range_saturate() {
        let encoder = Encoder::new(1e-6);
        assert_eq!(encoder.counts(1e9), i32::MAX);
        assert_eq!(encoder.counts(f64::NEG_INFINITY), i32::MIN);
    }

    proptest! {
        #[test]
        fn a_position_comes_back_within_half_a_quantum(
            position in -0.1..0.1_f64,
            quantum in 1e-9..1e-2_f64,
        ) {
            let encoder = Encoder::new(quantum);
            let back = encoder.position(encoder.counts(position));
            // Half a quantum, and the rounding of a position below 0.1 m.
            prop_assert!((back - position).abs() <= 0.5 * quantum + 0.1 * f64::EPSILON);
        }
    }
}
