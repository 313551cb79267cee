const WINDOW: usize = 256;

const RECENT: usize = 15;

/// The last 256 round trips (us).
#[derive(Clone, Debug)]
pub(super) struct RoundTripHistory {
    lengths: [u32; WINDOW],
    n: usize,
}

impl Default for RoundTripHistory {
    fn default() -> Self {
        Self { lengths: [0; WINDOW], n: 0 }
    }
}

impl RoundTripHistory {
    pub(super) fn push(&mut self, length: u64) {
        self.lengths[self.n % WINDOW] = u32::try_from(length).unwrap_or(u32::MAX);
        self.n += 1;
    }

    /// Returns the median of the latest (us), cheap enough for a tick; `None` without any.
    pub(super) fn recent(&self) -> Option<u32> {
        let n = self.n.min(RECENT);
        let mut latest = [0; RECENT];
        for (back, length) in latest.iter_mut().take(n).enumerate() {
            *length = self.lengths[(self.n - 1 - back) % WINDOW];
        }
        let latest = &mut latest[..n];
        latest.sort_unstable();
        latest.get(n / 2).copied()
    }

    /// Returns median, 99th percentile and longest (us); `None` without any.
    pub(super) fn quantiles(&self) -> Option<[u32; 3]> {
        let n = self.n.min(WINDOW);
        let mut sorted = self.lengths;
        let sorted = sorted.get_mut(..n)?;
        sorted.sort_unstable();
        let at = |hundredths: usize| sorted.get((n * hundredths / 100).min(n.checked_sub(1)?));
        Some([*at(50)?, *at(99)?, *at(100)?])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_recent_median_forgets_soon_and_is_not_moved_by_one_that_was_late() {
        let mut trips = RoundTripHistory::default();
        assert_eq!(trips.recent(), None);
        (0..WINDOW).for_each(|_| trips.push(900));
        assert_eq!(trips.recent(), Some(900));
        (0..RECENT as u64 - 1).for_each(|n| trips.push(200 + n));
        trips.push(50_000);
        assert_eq!(trips.recent(), Some(207));
    }

    #[test]
    fn quantiles_are_those_of_the_last_256() {
        let mut trips = RoundTripHistory::default();
        assert_eq!(trips.quantiles(), None);
        (0..1_000).for_each(|length| trips.push(length));
        assert_eq!(trips.quantiles(), Some([872, 997, 999]));
    }
}
