//! How much later than usual a board's samples are.
//!
//! A way that always takes as long delays the key and does no harm else; one that takes now
//! longer and now shorter makes speeds that no key had, unless it is known.

/// Samples over which what is usual is averaged.
const MEMORY: f64 = 512.0;

/// By how much a sample may be earlier than usual (periods); the boards' clocks and the host's
/// ticks slide past each other by less than one.
const MOST_EARLY: f64 = 1.5;

/// What the samples of one board usually take.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Lateness {
    /// Mean age of those that had just come (us).
    usual_us: f64,
    /// How many that were; no more than [`MEMORY`].
    n: f64,
}

impl Lateness {
    /// Learns from a sample that has just come and is `age_us` old; samples are `period_us` apart.
    ///
    /// Nothing can be much faster than usual: if a sample is, what seemed usual was a clock that
    /// was read wrong, and is forgotten.
    pub fn learn(&mut self, age_us: i32, period_us: u64) {
        if self.of(age_us) < -MOST_EARLY * period_us as f64 {
            *self = Self::default();
        }
        self.n = (self.n + 1.0).min(MEMORY);
        self.usual_us += (f64::from(age_us) - self.usual_us) / self.n;
    }

    /// Returns how old samples usually are when they come (us), once there were enough of them.
    pub fn usual_us(&self) -> Option<f64> {
        /// Samples from which on a mean is believed.
        const ENOUGH: f64 = 200.0;
        (ENOUGH <= self.n).then_some(self.usual_us)
    }

    /// Returns by how much a sample of `age_us` is older than usual (us); 0 as long as nothing is.
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
