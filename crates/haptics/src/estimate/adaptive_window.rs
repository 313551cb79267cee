//! Differences over the longest window in which the key moved uniformly.

use super::{Estimator, KeyMotion, assert_positive};

const LONGEST: usize = 16;

/// First-order adaptive window: fast while the key is fast, smooth while it is slow.
///
/// Velocity is the slope from the newest sample to the oldest whose line passes all samples between
/// them within a count of the encoder. Acceleration is the change of that velocity over the window.
/// The end-fit filter of `[JHC00]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AdaptiveWindow {
    /// Displacement of one count (m).
    quantum: f64,
    /// Samples, the newest first.
    past: [TimedPosition; LONGEST],
    len: usize,
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct TimedPosition {
    /// Time before the newest sample (s).
    ago: f64,
    position: f64,
    velocity: f64,
}

impl AdaptiveWindow {
    /// Creates an estimator at rest at zero for positions that are rounded to `quantum` (m).
    ///
    /// # Panics
    /// Unless `quantum` is finite and positive.
    pub fn new(quantum: f64) -> Self {
        assert_positive(quantum, "quantum");
        Self { quantum, past: [TimedPosition::default(); LONGEST], len: 1 }
    }

    /// Returns the oldest sample whose line to the newest passes all between them, and its slope.
    ///
    /// # Real-time
    /// At most 105 comparisons.
    fn longest_line(&self) -> (TimedPosition, f64) {
        let newest = self.past[0].position;
        let mut found = (self.past[0], 0.0);
        for n in 1..self.len {
            let end = self.past[n];
            let slope = (newest - end.position) / end.ago;
            let is_on =
                |it: &TimedPosition| (newest - slope * it.ago - it.position).abs() <= self.quantum;
            if !self.past[1..n].iter().all(is_on) {
                break;
            }
            found = (end, slope);
        }
        found
    }
}

impl Estimator for AdaptiveWindow {
    fn update(&mut self, position: f64, elapsed: f64) -> KeyMotion {
        self.past.rotate_right(1);
        self.len = (self.len + 1).min(LONGEST);
        for old in &mut self.past[1..] {
            old.ago += elapsed;
        }
        self.past[0] = TimedPosition { ago: 0.0, position, velocity: 0.0 };
        let (end, velocity) = self.longest_line();
        self.past[0].velocity = velocity;
        KeyMotion { position, velocity, acceleration: (velocity - end.velocity) / end.ago }
    }

    fn reset(&mut self, position: f64) {
        self.past = [TimedPosition { ago: 0.0, position, velocity: 0.0 }; LONGEST];
        self.len = 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const H: f64 = 1e-3;
    const COUNT: f64 = 10e-6;

    /// Returns the velocities of ticks 40 to 60 of a key at `speed` (m/s), on counts.
    fn velocities(speed: f64) -> Vec<f64> {
        let mut estimator = AdaptiveWindow::new(COUNT);
        let counted = |tick: u32| (speed * f64::from(tick) * H / COUNT).round() * COUNT;
        let all = (0..60).map(|tick| estimator.update(counted(tick), H).velocity);
        all.skip(40).collect()
    }

    #[test]
    fn a_slow_key_is_known_within_two_counts_of_a_whole_window() {
        for speed in [3e-3, 17e-3, 90e-3, 0.7] {
            let worst = velocities(speed).iter().fold(0.0_f64, |worst, it| worst.max(it - speed));
            // Each end errs by half a count; backward differences err by up to 10 mm/s.
            assert!(worst <= COUNT / (15.0 * H) * 1.001, "{speed} m/s: {worst}");
        }
    }

    #[test]
    fn a_stroke_is_followed_as_by_the_backward_difference() {
        let mut estimator = AdaptiveWindow::new(COUNT);
        estimator.reset(0.0);
        for tick in 1..100_u32 {
            let t = f64::from(tick) * H;
            let motion = estimator.update(0.5 * 100.0 * t * t, H);
            // A parabola leaves its chord of n periods by a count where (n h / 2)^2 / 2 is one.
            let window = 2.0 * (2.0 * COUNT / 100.0_f64).sqrt();
            let lag = 100.0 * t - motion.velocity;
            assert!(lag <= 100.0 * (0.5 * window + H), "tick {tick}: {lag}");
        }
    }

    #[test]
    fn rest_is_rest_and_time_is_what_passed() {
        let mut estimator = AdaptiveWindow::new(COUNT);
        estimator.reset(4e-3);
        assert_eq!(estimator.update(4e-3, H), KeyMotion::at_rest(4e-3));
        for elapsed in [0.4 * H, 2.6 * H, H, 1.7 * H] {
            let position = estimator.past[0].position + 0.2 * elapsed;
            let motion = estimator.update(position, elapsed);
            assert!((motion.velocity - 0.2).abs() < 0.05, "{motion:?}");
        }
    }
}
