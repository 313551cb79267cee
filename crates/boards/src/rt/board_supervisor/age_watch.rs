//! Detects samples that take longer on their path than when their board was armed.
//!
//! Stability was examined with that delay; a longer path is a slower loop, whatever the rate.

/// Minimum samples for a valid usual age.
const ENOUGH: f64 = 200.0;

/// Samples over which lateness is averaged.
const MEMORY: f64 = 8.0;

/// Lateness (periods) at which a board gets half its forces, and none. Samples and ticks slide past
/// each other by up to one period, which is no lateness.
const SOFT: f64 = 1.25;
const MUTE: f64 = 1.75;

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct AgeWatch {
    /// Mean age of the first samples (us), and their number.
    usual_us: f64,
    n: f64,
    /// Recent lateness beyond that age (periods).
    late: f64,
}

impl AgeWatch {
    pub(super) fn take(&mut self, age_us: i32, period_us: u64) {
        let age_us = f64::from(age_us);
        if self.n < ENOUGH {
            self.n += 1.0;
            self.usual_us += (age_us - self.usual_us) / self.n;
        } else {
            let late = (age_us - self.usual_us) / period_us.max(1) as f64;
            self.late += (late - self.late) / MEMORY;
        }
    }

    pub(super) fn forget(&mut self) {
        *self = Self::default();
    }

    pub(super) fn share(&self) -> f64 {
        match self.late {
            late if MUTE <= late => 0.0,
            late if SOFT <= late => 0.5,
            _ => 1.0,
        }
    }

    pub(super) fn late(&self) -> Option<f64> {
        (SOFT <= self.late).then_some(self.late)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part(watch: &AgeWatch) -> &'static str {
        match watch.share() {
            share if share <= 0.0 => "none",
            share if share < 1.0 => "some",
            _ => "whole",
        }
    }

    #[test]
    fn a_way_that_becomes_longer_softens_and_then_mutes_within_a_dozen_samples() {
        let mut watch = AgeWatch::default();
        let parts = [(300, 400), (20, 1_900), (12, 3_400), (30, 400)].map(|(n, age_us)| {
            (0..n).for_each(|_| watch.take(age_us, 1_000));
            (part(&watch), watch.late().is_some())
        });
        assert_eq!(parts, [("whole", false), ("some", true), ("none", true), ("whole", false)]);
    }

    #[test]
    fn a_single_late_sample_changes_nothing() {
        let mut watch = AgeWatch::default();
        (0..300).for_each(|_| watch.take(400, 1_000));
        watch.take(4_000, 1_000);
        assert_eq!(part(&watch), "whole");
    }
}
