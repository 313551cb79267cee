//! How often a board's samples really come, by its own clock.
//!
//! A loss on the way counts as the host sees it: as a longer interval. What the host itself does
//! late does not, since the stamps are the board's.

/// Intervals that are looked at together.
const N: usize = 32;

/// Samples between two looks.
const LOOK: u32 = 8;

/// Part of the agreed interval by which the median may be longer.
const MOST_MEDIAN: f64 = 1.25;

/// Times the agreed interval that nine of ten intervals must stay below.
const MOST_P90: f64 = 2.5;

/// What the intervals of late were.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct SampleIntervals {
    /// Half of them were longer (us).
    pub median_us: u16,
    /// A tenth of them were longer (us).
    pub p90_us: u16,
}

/// What is wrong with a board's intervals.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum IntervalFault {
    /// Some are long: the board is played more softly.
    Uneven,
    /// Most are longer than agreed: no model is stable so.
    Slow,
}

/// The newest intervals between the samples of one board.
#[derive(Clone, Copy, Debug)]
pub(super) struct IntervalWatch {
    intervals_us: [u16; N],
    n: usize,
    since_look: u32,
    newest: Option<SampleIntervals>,
}

impl Default for IntervalWatch {
    fn default() -> Self {
        Self { intervals_us: [0; N], n: 0, since_look: 0, newest: None }
    }
}

impl IntervalWatch {
    /// Takes the time between two samples by the board's clock (us).
    ///
    /// # Real-time
    /// Sorts 32 numbers for every eighth sample.
    pub(super) fn take(&mut self, interval_us: u16) {
        self.intervals_us.rotate_right(1);
        self.intervals_us[0] = interval_us;
        self.n = (self.n + 1).min(N);
        self.since_look += 1;
        if self.n == N && LOOK <= self.since_look {
            self.since_look = 0;
            let mut sorted = self.intervals_us;
            sorted.sort_unstable();
            let (median_us, p90_us) = (sorted[N / 2], sorted[N * 9 / 10]);
            self.newest = Some(SampleIntervals { median_us, p90_us });
        }
    }

    /// Forgets what came, for a board that starts again.
    pub(super) fn forget(&mut self) {
        *self = Self::default();
    }

    /// Returns what the intervals are, once enough samples have come.
    pub(super) const fn newest(&self) -> Option<SampleIntervals> {
        self.newest
    }
}

impl SampleIntervals {
    /// Returns what is wrong with these intervals where `agreed_us` was agreed.
    pub(super) fn fault(&self, agreed_us: u16) -> Option<IntervalFault> {
        let times = |us: u16| f64::from(us) / f64::from(agreed_us.max(1));
        if MOST_MEDIAN < times(self.median_us) {
            Some(IntervalFault::Slow)
        } else if MOST_P90 < times(self.p90_us) {
            Some(IntervalFault::Uneven)
        } else {
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fault(intervals_us: impl IntoIterator<Item = u16>) -> Option<IntervalFault> {
        let mut watch = IntervalWatch::default();
        intervals_us.into_iter().for_each(|it| watch.take(it));
        watch.newest()?.fault(1_000)
    }

    #[test]
    fn half_the_samples_are_noticed_after_two_dozen_of_them() {
        assert_eq!(fault([1_000; 32]), None);
        assert_eq!(fault([2_000; 32]), Some(IntervalFault::Slow));
        let mended = [1_000; 64].into_iter().chain([2_000; 24]);
        assert_eq!(fault(mended), Some(IntervalFault::Slow));
        assert_eq!(fault((0..64).map(|n| 900 + n % 3 * 100)), None, "phases of a board");
    }

    #[test]
    fn a_fifth_of_long_intervals_is_uneven_and_a_single_one_is_not() {
        let one = (0..32).map(|n| if n == 7 { 40_000 } else { 1_000 });
        assert_eq!(fault(one), None);
        let many = (0..32).map(|n| if n % 5 == 0 { 4_000 } else { 1_000 });
        assert_eq!(fault(many), Some(IntervalFault::Uneven));
    }
}
