use std::time::Duration;

use tokio::time::Instant;

/// Token bucket for a rate (1/s); after a pause twice as many are allowed at once.
#[derive(Debug)]
pub(super) struct TokenBucket {
    per_second: f64,
    level: f64,
    since: Instant,
}

impl TokenBucket {
    pub(super) fn new(per_second: u32, now: Instant) -> Self {
        let per_second = f64::from(per_second.max(1));
        Self { per_second, level: 2.0 * per_second, since: now }
    }

    pub(super) fn take(&mut self, now: Instant) -> bool {
        self.fill(now);
        let is_free = self.level >= 1.0;
        self.level -= f64::from(u8::from(is_free));
        is_free
    }

    /// Counts one more; returns the time that it has to wait.
    pub(super) fn book(&mut self, now: Instant) -> Duration {
        self.fill(now);
        self.level -= 1.0;
        Duration::from_secs_f64((-self.level / self.per_second).max(0.0))
    }

    fn fill(&mut self, now: Instant) {
        let passed = now.saturating_duration_since(self.since).as_secs_f64();
        self.level = (passed * self.per_second + self.level).min(2.0 * self.per_second);
        self.since = now;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn after_a_burst_so_many_a_second_are_let_through() {
        let start = Instant::now();
        let mut limit = TokenBucket::new(100, start);
        let through = |limit: &mut TokenBucket, at| (0..5000).filter(|_| limit.take(at)).count();
        assert_eq!(through(&mut limit, start), 200);
        assert_eq!(through(&mut limit, start + Duration::from_millis(500)), 50);
        assert_eq!(through(&mut limit, start + Duration::from_mins(1)), 200);
    }

    #[test]
    fn those_that_are_booked_wait_for_their_turn() {
        let start = Instant::now();
        let mut limit = TokenBucket::new(100, start);
        assert!((0..200).all(|_| limit.book(start) == Duration::ZERO));
        assert_eq!(limit.book(start), Duration::from_millis(10));
        assert_eq!(limit.book(start), Duration::from_millis(20));
    }
}
