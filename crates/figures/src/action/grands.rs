//! Times of travel, key bottom and free flight of three measured grands against hammer speed.
//!
//! W. Goebl, R. Bresin, A. Galembo, "Touch and temporal behavior of grand piano actions", J. Acoust.
//! Soc. Am. 118 (2005): more than 2300 tones on a Steinway C, a Yamaha Disklavier and a Bösendorfer
//! SE290; fits in ms over the hammer's speed at the string (m/s).

use super::drive::StrokeTouch;

/// A fit a·v^b + c in ms, v in m/s.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Fit(f64, f64, f64);

impl Fit {
    fn seconds(self, speed: f64) -> f64 {
        1e-3 * (self.0 * speed.powf(self.1) + self.2)
    }
}

/// Timed part of a stroke.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum StrokeTime {
    Travel,
    /// Time from the string to the key's bottom; negative if the bottom comes first.
    KeyBottom,
    FreeFlight,
}

impl StrokeTime {
    pub const ALL: [Self; 3] = [Self::Travel, Self::KeyBottom, Self::FreeFlight];

    const fn fits(self, touch: StrokeTouch) -> [Fit; 3] {
        match (self, touch) {
            (Self::Travel, StrokeTouch::Pressed) => {
                [Fit(98.57, -0.7147, 0.0), Fit(89.41, -0.5959, 0.0), Fit(89.96, -0.5595, 0.0)]
            }
            (Self::Travel, StrokeTouch::Struck) => {
                [Fit(65.19, -0.7268, 0.0), Fit(57.43, -0.7748, 0.0), Fit(58.39, -0.7377, 0.0)]
            }
            (Self::KeyBottom, StrokeTouch::Pressed) => [
                Fit(19.09, -0.3936, -12.30),
                Fit(14.63, -0.4158, -11.05),
                Fit(11.59, -0.4497, -9.98),
            ],
            (Self::KeyBottom, StrokeTouch::Struck) => [
                Fit(59.57, -0.1131, -51.19),
                Fit(10.15, -0.6825, -3.74),
                Fit(13.96, -0.3559, -10.15),
            ],
            (Self::FreeFlight, StrokeTouch::Pressed) => {
                [Fit(1.63, -1.403, 0.0), Fit(2.78, -1.266, 0.0), Fit(3.21, -1.353, 0.0)]
            }
            (Self::FreeFlight, StrokeTouch::Struck) => {
                [Fit(3.04, -1.581, 0.0), Fit(5.27, -1.384, 0.0), Fit(4.32, -1.404, 0.0)]
            }
        }
    }

    /// Returns the time of each of the three grands at a hammer's `speed` (m/s), in s.
    pub fn measured(self, touch: StrokeTouch, speed: f64) -> [f64; 3] {
        self.fits(touch).map(|fit| fit.seconds(speed))
    }

    /// Returns the distance of `seconds` from the range of the three grands, over the allowed
    /// distance: 15 % of the range's nearer end, or 3 ms if that is more. At most 1 is inside.
    pub fn excess(self, touch: StrokeTouch, speed: f64, seconds: f64) -> f64 {
        let measured = self.measured(touch, speed);
        let low = measured.into_iter().fold(f64::INFINITY, f64::min);
        let high = measured.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let near = if seconds < low { low } else { high };
        let outside = (low - seconds).max(seconds - high).max(0.0);
        outside / (0.15 * near.abs()).max(3e-3)
    }
}

/// Returns the hammer speeds for which the fits of a touch are valid (m/s).
pub const fn speeds(touch: StrokeTouch) -> (f64, f64) {
    match touch {
        StrokeTouch::Pressed => (0.4, 6.0),
        StrokeTouch::Struck => (1.0, 6.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_spans_are_those_of_the_paper() {
        // Read from the paper's curves: pressed, 1 m/s and 3.3 m/s.
        let near = |a: f64, b: f64| assert!((1e3 * a - b).abs() < 0.6, "{a} {b}");
        near(StrokeTime::Travel.measured(StrokeTouch::Pressed, 0.99)[0], 99.0);
        near(StrokeTime::KeyBottom.measured(StrokeTouch::Pressed, 3.33)[2], -3.2);
        near(StrokeTime::FreeFlight.measured(StrokeTouch::Struck, 4.61)[1], 0.6);
    }

    #[test]
    fn inside_the_span_nothing_is_in_excess() {
        let measured = StrokeTime::Travel.measured(StrokeTouch::Pressed, 1.0);
        for seconds in measured {
            assert!(StrokeTime::Travel.excess(StrokeTouch::Pressed, 1.0, seconds) < 1e-9);
        }
        let high = measured[0].max(measured[1]).max(measured[2]);
        assert!(
            (StrokeTime::Travel.excess(StrokeTouch::Pressed, 1.0, 1.15 * high) - 1.0).abs() < 1e-9
        );
        let flight = StrokeTime::FreeFlight.measured(StrokeTouch::Pressed, 5.0);
        let high = flight[0].max(flight[1]).max(flight[2]);
        assert!(
            (StrokeTime::FreeFlight.excess(StrokeTouch::Pressed, 5.0, high + 3e-3) - 1.0).abs()
                < 1e-9
        );
    }
}
