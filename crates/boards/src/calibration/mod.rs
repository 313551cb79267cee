//! Counts ↔ metres, millinewtons ↔ newtons: the only place of these conversions.

mod fault;
pub mod file;

use firmware_protocol::frame::key_forces::KeySlopes;
use firmware_protocol::quantity::{Counts, Millinewtons, SlopeCode, SpeedCode};
use scheduler::motion::KeySlope;

pub use fault::CalibrationFault;

/// Encoder and motor calibration of one key.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct KeyCalibration {
    /// Reading at rest (counts).
    pub rest: Counts,
    /// Displacement per count, down positive (m).
    pub quantum: f64,
    /// Command to the motor per newton (1).
    pub gain: f64,
    /// Reading on the bottom felt (counts).
    pub bottom: Counts,
    /// Friction that holds the key in place (N).
    pub friction: f64,
}

/// Travel of a key that was never measured (m).
const USUAL_TRAVEL: f64 = 10.16e-3;

impl Default for KeyCalibration {
    fn default() -> Self {
        Self::nominal(1e-6)
    }
}

/// State of a key at a measurement, down positive (m, m/s).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct MeasurementPoint {
    pub position: f64,
    pub velocity: f64,
}

impl KeyCalibration {
    /// Returns a key that was never measured, with a displacement of `quantum` (m) per count.
    pub fn nominal(quantum: f64) -> Self {
        Self::of_travel(quantum, USUAL_TRAVEL)
    }

    /// Like [`Self::nominal`], for a key with a travel of `travel` (m).
    pub fn of_travel(quantum: f64, travel: f64) -> Self {
        let rest = Counts::default();
        let bottom = Counts::saturating(nearest(travel / quantum));
        Self { rest, quantum, gain: 1.0, bottom, friction: 0.0 }
    }

    pub fn is_nominal(&self) -> bool {
        let nominal = Self::nominal(self.quantum);
        *self == nominal || *self == nominal.unmeasured()
    }

    /// Returns the calibration with unknown travel: the key may be anywhere.
    #[must_use]
    pub const fn unmeasured(self) -> Self {
        Self { bottom: self.rest, ..self }
    }

    /// Returns the key's travel (m); 0 if unknown.
    pub fn travel(&self) -> f64 {
        self.position(self.bottom)
    }

    /// Returns the key-front displacement at a reading, down positive (m).
    pub fn position(&self, counts: Counts) -> f64 {
        // Both have 24 bits, so the difference is exact.
        f64::from(counts.get() - self.rest.get()) * self.quantum
    }

    /// Returns the reading nearest to `position` (m), clamped to 24 bits.
    pub fn counts(&self, position: f64) -> Counts {
        Counts::saturating(nearest(position / self.quantum).saturating_add(self.rest.get()))
    }

    /// Returns the motor's command for `force` (N); 0 if it is not finite.
    pub fn millinewtons(&self, force: f64) -> Millinewtons {
        millinewtons(force * self.gain)
    }

    /// Returns the motor's command, at the measured point `here`, for a force of `force` (N) that
    /// extrapolates with `slope` from another position.
    ///
    /// The slopes on the wire are coarse, the force is not: it is moved to `here` along the sent
    /// slopes, so that the board renders `force` exactly. Slopes beyond a frame's range become a
    /// held force.
    pub fn sloped(
        &self,
        force: f64,
        slope: &KeySlope,
        here: MeasurementPoint,
    ) -> (Millinewtons, KeySlopes) {
        let stiffness =
            SlopeCode::toward_zero(nearest(slope.stiffness * self.gain / STIFFNESS_UNIT));
        let damping = SlopeCode::toward_zero(nearest(slope.damping * self.gain / DAMPING_UNIT));
        let expected = here.position + here.velocity * slope.ahead;
        let moved = f64::from(stiffness.get()) * STIFFNESS_UNIT * (slope.position - expected)
            + f64::from(damping.get()) * DAMPING_UNIT * (slope.velocity - here.velocity);
        let there = force * self.gain + moved;
        if there.abs() < LARGEST {
            (millinewtons(there), KeySlopes { stiffness, damping })
        } else {
            (self.millinewtons(force), KeySlopes::default())
        }
    }
}

/// Stiffness per unit on the wire (N/m).
const STIFFNESS_UNIT: f64 = SlopeCode::STIFFNESS_UNIT as f64 * 1e-3;
/// Damping per unit on the wire (N s/m).
const DAMPING_UNIT: f64 = SlopeCode::DAMPING_UNIT as f64 * 1e-3;
/// Largest force in a frame (N).
const LARGEST: f64 = 32.767;

/// Returns the wire's value nearest to `force` (N); 0 if it is not finite.
pub fn millinewtons(force: f64) -> Millinewtons {
    let force = if force.is_finite() { force } else { 0.0 };
    Millinewtons::saturating(nearest(force * 1e3))
}

/// Returns the force (N) of a wire's value.
pub fn newtons(force: Millinewtons) -> f64 {
    f64::from(force.get()) / 1e3
}

/// Returns the speed (m/s) of a wire's value.
pub fn metres_per_second(speed: SpeedCode) -> f64 {
    f64::from(speed.get()) * (f64::from(SpeedCode::MICROMETRES_PER_SECOND) * 1e-6)
}

/// Returns the wire's value nearest to `speed` (m/s).
pub fn speed(speed: f64) -> SpeedCode {
    SpeedCode::saturating(nearest(speed * (1e6 / f64::from(SpeedCode::MICROMETRES_PER_SECOND))))
}

/// Returns the stiffness (N/m) and damping (N s/m) of the wire's values.
pub fn slopes(slopes: KeySlopes) -> (f64, f64) {
    let KeySlopes { stiffness, damping } = slopes;
    (f64::from(stiffness.get()) * STIFFNESS_UNIT, f64::from(damping.get()) * DAMPING_UNIT)
}

/// Returns the integer nearest to `value`, clamped to `i32`; 0 for NaN.
fn nearest(value: f64) -> i32 {
    #[expect(clippy::cast_possible_truncation, reason = "saturation is the contract")]
    let whole = value.round() as i32;
    whole
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const MICROMETRES: KeyCalibration = KeyCalibration {
        rest: Counts::saturating(-400),
        quantum: 1e-6,
        gain: 1.0,
        bottom: Counts::saturating(9_760),
        friction: 0.1,
    };

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
            let rest = Counts::saturating(123);
            let calibration = KeyCalibration { rest, ..KeyCalibration::nominal(quantum) };
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

    proptest! {
        #[test]
        fn a_sloped_force_is_right_where_it_was_meant(
            force in -20.0..20.0_f64,
            stiffness in -5e3..5e3_f64, damping in -20.0..20.0_f64,
            position in 0.0..0.01_f64, velocity in -0.5..0.5_f64,
            moved in -1e-3..1e-3_f64, faster in -0.2..0.2_f64,
        ) {
            let ahead = 0.5e-3;
            let slope = KeySlope { stiffness, damping, position, velocity, ahead };
            let here = MeasurementPoint { position: position + moved, velocity: velocity + faster };
            let (there, sent) = KeyCalibration::default().sloped(force, &slope, here);
            let (k, b) = slopes(sent);
            let expected = here.position + here.velocity * ahead;
            let rendered = newtons(there) + k * (expected - position) + b * faster;
            // Half a millinewton, and roundings of some 30 N.
            prop_assert!((rendered - force).abs() < 0.51e-3, "{rendered} for {force}");
        }
    }
}
