//! The host's time: the machine's, or a virtual one that passes only while the host waits.

use std::sync::atomic::{AtomicU64, Ordering};
use std::{sync::Arc, time::Duration};

use crate::links::pause;

/// The host's clock (us).
#[derive(Clone, Debug)]
pub enum HostClock {
    Monotonic(fn() -> u64),
    /// A time that passes only while the host waits, shared by all clones.
    Virtual(Arc<AtomicU64>),
}

impl HostClock {
    pub fn virtual_time() -> Self {
        Self::Virtual(Arc::default())
    }

    pub fn now_us(&self) -> u64 {
        match self {
            Self::Monotonic(read) => read(),
            Self::Virtual(now) => now.load(Ordering::Acquire),
        }
    }

    /// Lets `length` pass: sleeps, or advances virtual time. Not for the tick.
    pub fn pause(&self, length: Duration) {
        match self {
            Self::Monotonic(_) => pause(length),
            Self::Virtual(now) => {
                let passed = u64::try_from(length.as_micros()).unwrap_or(u64::MAX);
                now.fetch_add(passed, Ordering::AcqRel);
            }
        }
    }

    /// Advances virtual time to `now_us`, never back. A monotonic clock passes by itself.
    pub fn advance_to(&self, now_us: u64) {
        match self {
            Self::Monotonic(_) => {}
            Self::Virtual(now) => _ = now.fetch_max(now_us, Ordering::AcqRel),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn virtual_time_passes_where_the_host_waits_and_never_goes_back() {
        let clock = HostClock::virtual_time();
        let other = clock.clone();
        clock.pause(Duration::from_micros(500));
        clock.advance_to(2_000);
        clock.advance_to(1_000);
        assert_eq!(other.now_us(), 2_000);
    }
}
