//! Actual intervals of a board's samples, by its own clock, so lateness of the host has no effect.
//!
//! A lost frame makes a longer interval and a gap in the numbers; a board that sends fewer frames
//! than it confirmed leaves no gap.

const N: usize = 32;

/// Samples between two evaluations.
const LOOK: u32 = 8;

/// Largest ratio of the median to the agreed interval.
const MOST_MEDIAN: f64 = 1.25;

/// Largest ratio of the 90th percentile to the agreed interval.
const MOST_P90: f64 = 2.5;

/// Statistics of recent intervals.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct SampleIntervals {
    pub median_us: u16,
    pub p90_us: u16,
    /// Median between frames without losses (us).
    pub sent_us: u16,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum IntervalFault {
    /// Many are long because frames are lost: the board is played more softly.
    Uneven,
    /// It sends fewer samples than agreed: no model is stable so.
    Slow,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct IntervalWatch {
    intervals_us: [u16; N],
    sent_us: [u16; N],
    n: usize,
    n_sent: usize,
    since_look: u32,
    newest: Option<SampleIntervals>,
}

impl Default for IntervalWatch {
    fn default() -> Self {
        Self { intervals_us: [0; N], sent_us: [0; N], n: 0, n_sent: 0, since_look: 0, newest: None }
    }
}

impl IntervalWatch {
    /// Adds the interval of two samples by the board's clock (us), with `missing` frames between.
    ///
    /// # Real-time
    /// Sorts twice 32 numbers for every eighth sample.
    pub(super) fn take(&mut self, interval_us: u16, missing: u64) {
        push(&mut self.intervals_us, &mut self.n, interval_us);
        if missing == 0 {
            push(&mut self.sent_us, &mut self.n_sent, interval_us);
        }
        self.since_look += 1;
        if self.n == N && self.n_sent == N && LOOK <= self.since_look {
            self.since_look = 0;
            let [all, sent] = [self.intervals_us, self.sent_us].map(|mut it| {
                it.sort_unstable();
                it
            });
            let (median_us, p90_us, sent_us) = (all[N / 2], all[N * 9 / 10], sent[N / 2]);
            self.newest = Some(SampleIntervals { median_us, p90_us, sent_us });
        }
    }

    pub(super) fn forget(&mut self) {
        *self = Self::default();
    }

    pub(super) const fn newest(&self) -> Option<SampleIntervals> {
        self.newest
    }
}

fn push(intervals_us: &mut [u16; N], n: &mut usize, newest_us: u16) {
    intervals_us.rotate_right(1);
    intervals_us[0] = newest_us;
    *n = (*n + 1).min(N);
}

impl SampleIntervals {
    /// Returns the fault of these intervals against the agreed `agreed_us`, if any.
    pub(super) fn fault(self, agreed_us: u16) -> Option<IntervalFault> {
        let times = |us: u16| f64::from(us) / f64::from(agreed_us.max(1));
        if MOST_MEDIAN < times(self.sent_us) {
            Some(IntervalFault::Slow)
        } else if MOST_MEDIAN < times(self.median_us) || MOST_P90 < times(self.p90_us) {
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
        intervals_us.into_iter().for_each(|it| watch.take(it, 0));
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
    fn frames_that_are_lost_make_a_board_uneven_and_not_slow() {
        let mut watch = IntervalWatch::default();
        (0..96).for_each(|n| if n % 3 == 0 { watch.take(1_000, 0) } else { watch.take(2_000, 1) });
        let found = watch.newest().unwrap();
        assert_eq!(found.fault(1_000), Some(IntervalFault::Uneven), "{found:?}");
    }

    #[test]
    fn a_fifth_of_long_intervals_is_uneven_and_a_single_one_is_not() {
        let one = (0..32).map(|n| if n == 7 { 40_000 } else { 1_000 });
        assert_eq!(fault(one), None);
        let many = (0..32).map(|n| if n % 5 == 0 { 4_000 } else { 1_000 });
        assert_eq!(fault(many), Some(IntervalFault::Uneven));
    }
}
