//! Position of a driven key's front over time.

use pode::Motion;

/// Travel that a stroke reaches after its duration, on a key that travels [`USUAL_DIP`] (m).
const STROKE_DEPTH: f64 = 9.3e-3;
/// Travel of a grand's key to its bed (m).
pub(super) const USUAL_DIP: f64 = 10.16e-3;
/// Travel of a pressed key beyond its dip (m): the finger compresses the bed.
pub(super) const BEYOND_DIP: f64 = 1e-3;

/// Start of a finger's stroke.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum StrokeTouch {
    /// On the key, moving with it.
    Pressed,
    /// Above the key, at speed already.
    Struck,
}

impl StrokeTouch {
    pub const ALL: [Self; 2] = [Self::Pressed, Self::Struck];

    pub const fn name(self) -> &'static str {
        match self {
            Self::Pressed => "pressed",
            Self::Struck => "struck",
        }
    }

    /// Returns the exponent of the power law of a stroke in `duration` (s): end over mean speed.
    ///
    /// On a lever of 5.2 : 1 it gives the measured travel times (Goebl, Bresin & Galembo 2005).
    fn exponent(self, duration: f64) -> f64 {
        match self {
            Self::Pressed => 1.9 * (duration / 92.6e-3).powf(-0.6),
            Self::Struck => 1.24 * (duration / 60e-3).powf(-0.36),
        }
        .max(1.0)
    }
}

/// Position of a key's front over time (m, down positive), from 0 at 0 s.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Drive {
    Stroke {
        /// Time to [`STROKE_DEPTH`] (s).
        duration: f64,
        exponent: f64,
        /// That depth on this key (m).
        depth: f64,
        /// Depth of the hold (m).
        held: f64,
    },
    /// Down at a constant speed (m/s), at once back, and then up.
    Slope { speed: f64, turn: f64 },
    /// Down to `held` at `speed`, then between `held` and `up` (m), `rate` times a second.
    Repeated { speed: f64, held: f64, up: f64, rate: f64 },
}

impl Drive {
    /// Returns a stroke on a key that travels `dip` (m).
    pub(super) fn stroke(touch: StrokeTouch, duration: f64, dip: f64) -> Self {
        let depth = STROKE_DEPTH * dip / USUAL_DIP;
        Self::Stroke { duration, exponent: touch.exponent(duration), depth, held: dip + BEYOND_DIP }
    }

    pub(super) fn at(&self, t: f64) -> Motion {
        let t = t.max(0.0);
        match *self {
            Self::Stroke { duration, exponent: n, depth, held } => {
                let x = t / duration;
                let position = depth * x.powf(n);
                if position >= held {
                    return still(held);
                }
                // A power below 2 has no acceleration at 0, and a power of 1 none at all.
                let bend = if n > 1.0 && x > 0.0 { (n - 1.0) * x.powf(n - 2.0) } else { 0.0 };
                let speed = depth * n / duration;
                let rate = speed * x.powf(n - 1.0);
                Motion { position, rate, acceleration: speed / duration * bend, jerk: 0.0 }
            }
            Self::Slope { speed, turn } => {
                let top = turn / speed;
                if t < top {
                    Motion { position: speed * t, rate: speed, ..Motion::default() }
                } else if t < 2.0 * top {
                    Motion { position: turn - speed * (t - top), rate: -speed, ..Motion::default() }
                } else {
                    still(0.0)
                }
            }
            Self::Repeated { speed, held, up, rate } => {
                let down = held / speed;
                if t < down {
                    return Motion { position: speed * t, rate: speed, ..Motion::default() };
                }
                let omega = std::f64::consts::TAU * rate;
                let (sin, cos) = (omega * (t - down)).sin_cos();
                let amplitude = 0.5 * (held - up);
                Motion {
                    position: held - amplitude * (1.0 - cos),
                    rate: -amplitude * omega * sin,
                    acceleration: -amplitude * omega * omega * cos,
                    jerk: 0.0,
                }
            }
        }
    }
}

fn still(position: f64) -> Motion {
    Motion { position, ..Motion::default() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stroke_has_its_depth_after_its_duration_and_then_holds() {
        for touch in StrokeTouch::ALL {
            for duration in [0.01, 0.06, 0.2] {
                let drive = Drive::stroke(touch, duration, USUAL_DIP);
                assert!((drive.at(duration).position - STROKE_DEPTH).abs() < 1e-12);
                assert_eq!(drive.at(2.0), still(USUAL_DIP + BEYOND_DIP));
            }
        }
    }

    #[test]
    fn a_rate_is_the_slope_of_its_position() {
        let drives = [
            Drive::stroke(StrokeTouch::Pressed, 0.05, USUAL_DIP),
            Drive::stroke(StrokeTouch::Struck, 0.02, 5e-3),
            Drive::Slope { speed: 0.1, turn: 0.01 },
            Drive::Repeated { speed: 0.1, held: 0.011, up: 0.007, rate: 12.0 },
        ];
        for drive in drives {
            for t in [0.004, 0.013, 0.12, 0.16] {
                let step = 1e-6;
                let slope =
                    (drive.at(t + step).position - drive.at(t - step).position) / (2.0 * step);
                assert!((drive.at(t).rate - slope).abs() < 1e-6, "{drive:?} at {t}");
            }
        }
    }

    #[test]
    fn a_lever_of_five_gives_the_speeds_of_the_measured_travel_times() {
        // Mean of the three grands' travel times (s) at these hammer speeds (m/s).
        for (speed, travel) in [(0.4, 0.163), (1.0, 0.0926), (2.0, 0.0593), (4.0, 0.0384)] {
            let Drive::Stroke { exponent, depth, .. } =
                Drive::stroke(StrokeTouch::Pressed, travel, USUAL_DIP)
            else {
                unreachable!()
            };
            let hammer = 5.2 * exponent * depth / travel;
            assert!((hammer / speed - 1.0).abs() < 0.06, "{hammer} for {speed} m/s");
        }
    }
}
