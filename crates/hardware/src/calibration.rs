//! Counts ↔ metres, millinewtons ↔ newtons: the only place of these conversions.

use firmware_protocol::quantity::{Counts, Millinewtons};

/// How one key's encoder reads.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct KeyCalibration {
    /// Reading of the key at rest [counts].
    pub rest: Counts,
    /// Displacement for each count, down positive [m].
    pub quantum: f64,
}

impl KeyCalibration {
    /// Key-front displacement at a reading, down positive [m].
    pub fn position(&self, counts: Counts) -> f64 {
        // Both have 24 bits, so the difference is exact.
        f64::from(counts.get() - self.rest.get()) * self.quantum
    }

    /// The reading nearest to `position` [m]; the edge of 24 bits for what is beyond.
    pub fn counts(&self, position: f64) -> Counts {
        Counts::saturating(nearest(position / self.quantum).saturating_add(self.rest.get()))
    }
}

/// The wire's value nearest to `force` [N]; no force at all if it is not finite.
pub fn millinewtons(force: f64) -> Millinewtons {
    let force = if force.is_finite() { force } else { 0.0 };
    Millinewtons::saturating(nearest(force * 1e3))
}

/// The force [N] that a wire's value means.
pub fn newtons(force: Millinewtons) -> f64 {
    f64::from(force.get()) / 1e3
}

/// The whole number nearest to `value`; the edge of `i32` beyond it, 0 for NaN.
fn nearest(value: f64) -> i32 {
    #[expect(clippy::cast_possible_truncation, reason = "saturation is the contract")]
    let whole = value.round() as i32;
    whole
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const MICROMETRES: KeyCalibration =
        KeyCalibration { rest: Counts::saturating(-400), quantum: 1e-6 };

    #[test]
    fn the_rest_reading_is_zero_metres() {
        assert_eq!(MICROMETRES.position(Counts::saturating(-400)).to_bits(), 0.0_f64.to_bits());
        assert_eq!(MICROMETRES.counts(0.0), Counts::saturating(-400));
    }

    #[test]
    fn a_force_that_is_no_number_is_no_force() {
        for force in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(millinewtons(force).get(), 0);
        }
    }

    #[test]
    fn a_force_beyond_the_wire_stops_at_its_edge() {
        assert_eq!(millinewtons(50.0), Millinewtons::MAX);
        assert_eq!(millinewtons(-50.0), Millinewtons::MIN);
        assert_eq!(MICROMETRES.counts(1e9), Counts::MAX);
        assert_eq!(MICROMETRES.counts(-1e9), Counts::MIN);
    }

    proptest! {
        #[test]
        fn readings_come_back(counts in -0x80_0000..=0x7F_FFFF_i32, quantum in 1e-9..1e-3_f64) {
            let calibration = KeyCalibration { rest: Counts::saturating(123), quantum };
            let counts = Counts::saturating(counts);
            prop_assert_eq!(calibration.counts(calibration.position(counts)), counts);
        }

        #[test]
        fn wire_forces_come_back(force in i16::MIN..=i16::MAX) {
            let force = Millinewtons::saturating(force.into());
            prop_assert_eq!(millinewtons(newtons(force)), force);
        }

        #[test]
        fn a_force_moves_by_at_most_half_a_millinewton(force in -32.0..32.0_f64) {
            let error = newtons(millinewtons(force)) - force;
            // Half a step, and one rounding of 32 000.
            prop_assert!(error.abs() <= 0.5e-3 + 32.0 * f64::EPSILON);
        }
    }
}
