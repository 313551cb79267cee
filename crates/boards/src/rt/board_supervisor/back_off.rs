//! Waiting time before a board that fails repeatedly is armed.

/// Time after which earlier events are forgotten (us).
const MEMORY_US: u64 = 10_000_000;

/// Waits after the first, the second ... of several events (us).
const WAITS_US: [u64; 4] = [0, 1_000_000, 2_000_000, 4_000_000];

#[derive(Clone, Copy, Debug)]
pub(super) struct BackOff {
    newest_us: u64,
    n: u8,
}

impl BackOff {
    pub(super) const NONE: Self = Self { newest_us: 0, n: 0 };

    /// Counts an event at `now` (us); returns the wait (us).
    pub(super) fn next(&mut self, now: u64) -> u64 {
        if self.newest_us + MEMORY_US < now {
            self.n = 0;
        }
        let wait = WAITS_US[usize::from(self.n).min(WAITS_US.len() - 1)];
        (self.newest_us, self.n) = (now, self.n.saturating_add(1));
        wait
    }

    pub(super) const fn n(&self) -> u8 {
        self.n
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn waits_grow_while_events_follow_on_each_other_and_begin_again_afterwards() {
        let mut back_off = BackOff::NONE;
        let waits = [1, 2, 4, 8, 13, 30].map(|s| back_off.next(s * 1_000_000) / 1_000_000);
        assert_eq!(waits, [0, 1, 2, 4, 4, 0]);
    }
}
