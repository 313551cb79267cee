//! Detects an unstable loop of host, board and key by force oscillations within 50 ms.
//!
//! A hard stroke rebounds from the bed with up to six half-waves; eleven are too many, and fewer if
//! they are large. Each counts by the smaller of its peak and that of the half-wave before.

/// Least force of a half-wave (N).
const LEAST: f64 = 1.0;

/// Limit of the sum of half-waves (N): the hardest stroke on an upright makes 25 N.
const MOST: f64 = 35.0;

/// Time span of the sum (s).
const WINDOW: f64 = 0.05;

/// Number of half-waves that are stored, and too many.
const N: usize = 11;

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ShakeWatch {
    /// Counted peak of each (N), and time since its end (s), the newest first.
    waves: [(f64, f64); N],
    /// Peaks of the present half-wave and of the one before (N), and the present sign.
    peak: f64,
    before: f64,
    is_up: bool,
}

impl ShakeWatch {
    /// Adds `force` (N), `elapsed` (s) after the one before, rendered with this share. Returns
    /// `true` if it shakes, and restarts then.
    ///
    /// # Real-time
    /// Ten additions.
    pub(super) fn is_shaking(&mut self, force: f64, elapsed: f64, share: f64) -> bool {
        self.waves.iter_mut().for_each(|(_, age)| *age += elapsed);
        let (size, is_up) = (force.abs(), 0.0 < force);
        if size < LEAST {
            return false;
        }
        if is_up == self.is_up {
            self.peak = self.peak.max(size);
            return false;
        }
        self.waves.rotate_right(1);
        self.waves[0] = (self.peak.min(self.before), 0.0);
        (self.before, self.peak, self.is_up) = (self.peak, size, is_up);
        let recent = self.waves.iter().filter(|(size, age)| LEAST <= *size && *age <= WINDOW);
        let (n, sum) = recent.fold((0, 0.0), |(n, sum), (size, _)| (n + 1, sum + size));
        let is_shaking = N <= n || share * MOST <= sum;
        if is_shaking {
            *self = Self { is_up, ..Self::default() };
        }
        is_shaking
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// Counts how often in a second a sine of `hz` (1/s) and `newtons` counts as shaking.
    fn shakes(hz: f64, newtons: f64) -> usize {
        let mut watch = ShakeWatch::default();
        let force = |n: u32| newtons * (TAU * hz * f64::from(n) * 1e-3).sin();
        (0..1000).filter(|n| watch.is_shaking(force(*n), 1e-3, 1.0)).count()
    }

    #[test]
    fn a_loop_that_swings_shakes_and_a_tremolo_does_not() {
        assert!(0 < shakes(180.0, 15.0));
        assert!(0 < shakes(150.0, 1.5));
        assert!(0 < shakes(60.0, 20.0), "slow and hard");
        assert_eq!(shakes(180.0, 0.9), 0, "too soft to count");
        assert_eq!(shakes(80.0, 1.5), 0, "eight half-waves in a twentieth of a second");
    }

    #[test]
    fn a_stroke_that_rebounds_is_no_shake() {
        let mut watch = ShakeWatch::default();
        let rebound = [0.0, 8.0, 14.0, 6.0, -1.5, -1.2, 4.0, 2.0, -1.1, 0.5];
        assert!((0..200).all(|n| !watch.is_shaking(rebound[n % 10], 3e-3, 1.0)));
    }
}
