//! Hammer speed to MIDI velocity, and back.

use std::fmt;
use std::str::FromStr;

use crate::note::Velocity;

/// Softest tone of a grand (m/s) (Goebl, Bresin & Galembo 2005).
const SOFTEST: f64 = 0.18;

/// Loudest tone of a grand, struck touch (m/s) (Goebl, Bresin & Galembo 2005).
const LOUDEST: f64 = 6.8;

/// Velocity at a hammer speed of 1 m/s on the Disklavier (Goebl & Bresin 2001).
const DISKLAVIER_LEVEL: f64 = 57.96;

/// Velocity gained per tenfold hammer speed on the Disklavier (Goebl & Bresin 2001).
const DISKLAVIER_SLOPE: f64 = 71.3;

/// Shift of the light and the heavy curve from the Disklavier's.
const TOUCH_SHIFT: f64 = 12.0;

/// Key speed at which a release counts as the fastest (m/s); an estimate: a released key returns
/// 10 mm in 35 ms, a little faster than that at half way.
const FASTEST_RELEASE: f64 = 0.4;

/// Conversion of a hammer speed (m/s) to a MIDI velocity.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
#[must_use]
pub enum VelocityCurve {
    /// `57.96 + 71.3 log10(speed)`, measured on a Yamaha Disklavier.
    #[default]
    Disklavier,
    /// The Disklavier's, 12 louder: less effort for the same tone.
    Light,
    /// The Disklavier's, 12 softer: more effort for the same tone.
    Heavy,
    /// Straight line from 1 at 0.18 m/s (softest tone) to 127 at 6.8 m/s (loudest).
    Linear,
    /// Always 64, as on an organ or a harpsichord.
    Fixed,
}

impl VelocityCurve {
    /// Every curve, in the order of lists for people.
    pub const ALL: [Self; 5] =
        [Self::Disklavier, Self::Light, Self::Heavy, Self::Linear, Self::Fixed];

    /// Returns the name of this curve in a scene.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Disklavier => "disklavier",
            Self::Light => "light",
            Self::Heavy => "heavy",
            Self::Linear => "linear",
            Self::Fixed => "fixed",
        }
    }

    /// Returns the velocity of a strike at hammer `speed` (m/s); the least unless that is positive.
    pub fn velocity(self, speed: f64) -> Velocity {
        Velocity::nearest(self.level(speed))
    }

    /// Returns the velocity before rounding and limiting; it may lie outside 1 ..= 127.
    pub fn level(self, speed: f64) -> f64 {
        match self {
            Self::Disklavier => logarithmic(speed, 0.0),
            Self::Light => logarithmic(speed, TOUCH_SHIFT),
            Self::Heavy => logarithmic(speed, -TOUCH_SHIFT),
            Self::Linear => 1.0 + 126.0 * (speed - SOFTEST) / (LOUDEST - SOFTEST),
            Self::Fixed => f64::from(Velocity::UNKNOWN.get()),
        }
    }

    /// Returns the hammer speed (m/s) for `velocity`, in the middle of its interval.
    ///
    /// The fixed curve returns the Disklavier's speed, to keep a performance's dynamics.
    pub fn speed(self, velocity: Velocity) -> f64 {
        let level = f64::from(velocity.get());
        match self {
            Self::Disklavier | Self::Fixed => exponential(level, 0.0),
            Self::Light => exponential(level, TOUCH_SHIFT),
            Self::Heavy => exponential(level, -TOUCH_SHIFT),
            Self::Linear => SOFTEST + (level - 1.0) / 126.0 * (LOUDEST - SOFTEST),
        }
    }
}

/// Returns the release velocity of a key that rises at `speed` (m/s), linear to 127 at 0.4 m/s.
pub fn release_velocity(speed: f64) -> Velocity {
    Velocity::nearest(release_level(speed))
}

/// Returns the release velocity before rounding and limiting.
pub fn release_level(speed: f64) -> f64 {
    127.0 * speed.abs() / FASTEST_RELEASE
}

/// Returns the key speed (m/s) for release velocity `velocity`; inverts [`release_velocity`].
pub fn release_speed(velocity: Velocity) -> f64 {
    FASTEST_RELEASE * f64::from(velocity.get()) / 127.0
}

/// Returns the Disklavier's level, `shift` louder; negative infinity where there is no logarithm.
fn logarithmic(speed: f64, shift: f64) -> f64 {
    if speed > 0.0 {
        DISKLAVIER_LEVEL + shift + DISKLAVIER_SLOPE * speed.log10()
    } else {
        f64::NEG_INFINITY
    }
}

/// Inverts [`logarithmic`].
fn exponential(level: f64, shift: f64) -> f64 {
    10.0_f64.powf((level - shift - DISKLAVIER_LEVEL) / DISKLAVIER_SLOPE)
}

/// Name of a curve that does not exist.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("there is no velocity curve \"{0}\": choose one of {names}", names = names())]
pub struct UnknownCurve(pub String);

impl FromStr for VelocityCurve {
    type Err = UnknownCurve;

    fn from_str(name: &str) -> Result<Self, UnknownCurve> {
        let found = Self::ALL.into_iter().find(|curve| curve.name().eq_ignore_ascii_case(name));
        found.ok_or_else(|| UnknownCurve(name.to_owned()))
    }
}

impl fmt::Display for VelocityCurve {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

fn names() -> String {
    VelocityCurve::ALL.map(VelocityCurve::name).join(", ")
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[track_caller]
    fn check(curve: VelocityCurve, speed: f64, velocity: u8) {
        assert_eq!(curve.velocity(speed).get(), velocity, "{curve} at {speed} m/s");
    }

    #[test]
    fn the_disklavier_curve_meets_hand_values() {
        check(VelocityCurve::Disklavier, 1.0, 58); // 57.96
        check(VelocityCurve::Disklavier, 2.0, 79); // 57.96 + 71.3 · 0.30103 = 79.42
        check(VelocityCurve::Disklavier, 0.5, 36); // 57.96 − 21.46 = 36.50, just below
        check(VelocityCurve::Disklavier, 5.0, 108); // 57.96 + 49.84 = 107.80
        check(VelocityCurve::Disklavier, 0.1, 1); // −13.34
        check(VelocityCurve::Disklavier, 100.0, 127);
    }

    #[test]
    fn the_other_curves_meet_hand_values() {
        check(VelocityCurve::Light, 1.0, 70);
        check(VelocityCurve::Heavy, 1.0, 46);
        check(VelocityCurve::Linear, 0.18, 1);
        check(VelocityCurve::Linear, 3.49, 64);
        check(VelocityCurve::Linear, 6.8, 127);
        check(VelocityCurve::Fixed, 3.0, 64);
    }

    #[test]
    fn a_speed_that_makes_no_sense_gives_the_least_velocity() {
        for speed in [0.0, -1.0, f64::NAN, f64::NEG_INFINITY] {
            check(VelocityCurve::Disklavier, speed, 1);
            check(VelocityCurve::Linear, speed, 1);
        }
    }

    #[test]
    fn a_key_let_go_releases_fastest() {
        assert_eq!(release_velocity(0.4).get(), 127);
        assert_eq!(release_velocity(-0.2).get(), 64);
        assert_eq!(release_velocity(0.0).get(), 1);
    }

    #[test]
    fn a_wrong_name_is_answered_with_the_right_ones() {
        let error = "exponential".parse::<VelocityCurve>().unwrap_err();
        assert_eq!(
            error.to_string(),
            "there is no velocity curve \"exponential\": choose one of \
             disklavier, light, heavy, linear, fixed"
        );
    }

    proptest! {
        #[test]
        fn velocity_to_speed_to_velocity_is_exact(value in 1_u8..=127) {
            let velocity = Velocity::new(value).unwrap();
            for curve in VelocityCurve::ALL.into_iter().filter(|c| *c != VelocityCurve::Fixed) {
                prop_assert_eq!(curve.velocity(curve.speed(velocity)), velocity);
            }
        }
    }
}
