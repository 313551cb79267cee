//! One direction of a wire: fate and arrival time of each byte.

use std::collections::VecDeque;

use super::{WireCounts, WirePlan};
use crate::links::random::Random;

/// Maximum number of bytes on the wire; senders of more must wait.
const CAPACITY: usize = 4_096;
/// Bits of a byte on the wire: start, eight, stop.
const BITS: u64 = 10;
const NANOS: u64 = 1_000_000_000;

/// One direction. Times are (ns) from any start.
#[derive(Clone, Debug)]
pub(super) struct WireDirection {
    plan: WirePlan,
    random: Random,
    queue: VecDeque<(u64, u8)>,
    /// Time at which the wire is free for the next byte.
    free: u64,
    counts: WireCounts,
}

impl WireDirection {
    pub(super) fn new(plan: WirePlan, salt: u64) -> Self {
        let random = Random(Random(plan.seed).next() ^ salt);
        let queue = VecDeque::with_capacity(CAPACITY);
        Self { plan, random, queue, free: 0, counts: WireCounts::default() }
    }

    pub(super) fn room(&self) -> usize {
        CAPACITY - self.queue.len()
    }

    /// Accepts bytes, at most [`Self::room`].
    pub(super) fn take(&mut self, now: u64, bytes: &[u8]) {
        for byte in bytes {
            self.take_byte(now, *byte);
        }
    }

    fn take_byte(&mut self, now: u64, mut byte: u8) {
        let WirePlan { baud, loss, flip, stall, stall_us, late_us, .. } = self.plan;
        self.free = self.free.max(now);
        if self.random.happens(stall) {
            self.counts.stalls += 1;
            self.free += u64::from(stall_us) * 1_000;
        }
        self.free += baud.map_or(0, |baud| BITS * NANOS / u64::from(baud.max(1)));
        if self.random.happens(loss) {
            self.counts.lost += 1;
            return;
        }
        if self.random.happens(flip) {
            self.counts.flipped += 1;
            byte ^= 1 << (self.random.next() % 8);
        }
        self.queue.push_back((self.free + u64::from(late_us) * 1_000, byte));
    }

    /// Copies the bytes that have arrived into `out`; returns their number.
    pub(super) fn arrived(&self, now: u64, out: &mut [u8]) -> usize {
        let arrived = self.queue.iter().take_while(|(due, _)| *due <= now);
        out.iter_mut().zip(arrived).map(|(place, (_, byte))| *place = *byte).count()
    }

    pub(super) fn hand_on(&mut self, n: usize) {
        self.queue.drain(..n.min(self.queue.len()));
        self.counts.passed += n as u64;
    }

    /// Loses all bytes on the wire, and `n` bytes that were sent to it.
    pub(super) fn lose(&mut self, n: usize) {
        self.counts.lost += (n + self.queue.len()) as u64;
        self.queue.clear();
    }

    pub(super) fn next(&self) -> Option<u64> {
        self.queue.front().map(|(due, _)| *due)
    }

    pub(super) const fn counts(&self) -> WireCounts {
        self.counts
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_byte_takes_ten_bits_of_time() {
        let plan = WirePlan { baud: Some(1_000_000), ..WirePlan::default() };
        let mut direction = WireDirection::new(plan, 0);
        direction.take(5_000, &[1, 2, 3]);
        let mut out = [0; 8];
        let arrived = [14_999, 15_000, 34_999, 35_000].map(|now| direction.arrived(now, &mut out));
        assert_eq!((arrived, &out[..3]), ([0, 1, 2, 3], &[1, 2, 3][..]));
        direction.hand_on(2);
        assert_eq!((direction.next(), direction.room()), (Some(35_000), CAPACITY - 1));
    }

    #[test]
    fn faults_are_about_as_frequent_as_planned_and_the_same_for_a_seed() {
        let n = 1_000_000;
        let counts = |seed| {
            let plan =
                WirePlan { seed, loss: 0.01, flip: 0.01, stall: 0.01, ..WirePlan::default() };
            let mut direction = WireDirection::new(plan, 1);
            for _ in 0..n / 1_000 {
                direction.take(0, &[0; 1_000]);
                direction.hand_on(1_000);
            }
            direction.counts()
        };
        let WireCounts { lost, flipped, stalls, .. } = counts(7);
        // Five standard deviations of a binomial with n p q = 9900.
        for count in [lost, flipped, stalls] {
            assert!(count.abs_diff(10_000) < 500, "{count}");
        }
        assert_eq!(counts(7), counts(7));
        assert_ne!(counts(7), counts(8));
    }

    #[test]
    fn a_stall_holds_up_what_follows() {
        let plan = WirePlan { stall: 1.0, stall_us: 3, ..WirePlan::default() };
        let mut direction = WireDirection::new(plan, 0);
        direction.take(0, &[1, 2]);
        let mut out = [0; 2];
        assert_eq!([2_999, 3_000, 6_000].map(|now| direction.arrived(now, &mut out)), [0, 1, 2]);
    }

    #[test]
    fn bytes_that_are_late_keep_their_pace() {
        let plan = WirePlan { baud: Some(1_000_000), late_us: 4_000, ..WirePlan::default() };
        let mut direction = WireDirection::new(plan, 0);
        direction.take(0, &[1, 2]);
        let mut out = [0; 2];
        let arrived = [4_009_999, 4_010_000, 4_019_999, 4_020_000];
        assert_eq!(arrived.map(|now| direction.arrived(now, &mut out)), [0, 1, 1, 2]);
    }
}
