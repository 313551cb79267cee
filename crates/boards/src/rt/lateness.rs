//! Lateness of a board's samples against their usual delay.
//!
//! A constant delay only delays the key. A varying one causes false speeds unless it is known.

/// Samples over which the usual delay is averaged.
const MEMORY: f64 = 512.0;

/// Largest earliness (periods): clocks and ticks slide past each other by less than one.
const MOST_EARLY: f64 = 1.5;

/// Usual delay of the samples of one board.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Lateness {
    /// Mean age of samples on arrival (us).
    usual_us: f64,
    /// Number of averaged samples, up to [`MEMORY`].
    n: f64,
}

impl Lateness {
    /// Learns from a new sample that is `age_us` old; samples are `period_us` apart.
    ///
    /// A sample that is much faster than usual shows that the clock was misread; the mean is reset.
    pub fn learn(&mut self, age_us: i32, period_us: u64) {
        if self.of(age_us) < -MOST_EARLY * period_us as f64 {
            *self = Self::default();
        }
        self.n = (self.n + 1.0).min(MEMORY);
        self.usual_us += (f64::from(age_us) - self.usual_us) / self.n;
    }

    /// Returns the usual age of samples on arrival (us), once there were enough.
    pub fn usual_us(&self) -> Option<f64> {
        /// Minimum samples for a valid mean.
        const ENOUGH: f64 = 200.0;
        (ENOUGH <= self.n).then_some(self.usual_us)
    }

    /// Returns the excess of `age_us` over the usual age (us); 0 until that is known.
    pub fn of(&self, age_us: i32) -> f64 {
        if self.n == 0.0 { 0.0 } else { f64::from(age_us) - self.usual_us }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_always_takes_as_long_is_never_late() {
        let mut lateness = Lateness::default();
        for _ in 0..1000 {
            lateness.learn(1500, 1000);
            assert!(lateness.of(1500).abs() < 1e-9);
        }
        assert!((lateness.of(2500) - 1000.0).abs() < 1e-9, "one that is still on its way");
    }

    #[test]
    fn ages_that_were_read_wrong_for_a_while_are_forgotten_at_once() {
        let mut lateness = Lateness::default();
        (0..300).for_each(|_| lateness.learn(59_000, 1000));
        lateness.learn(500, 1000);
        assert!(lateness.of(500).abs() < 1e-9, "{}", lateness.of(500));
    }

    #[test]
    fn a_sample_is_late_by_what_it_took_longer_than_the_mean() {
        let mut lateness = Lateness::default();
        for n in 0..5000 {
            lateness.learn(if n % 2 == 0 { 1000 } else { 3000 }, 2000);
        }
        let late = lateness.of(3000);
        assert!((late - 1000.0).abs() < 2.0, "{late} us");
    }
}
