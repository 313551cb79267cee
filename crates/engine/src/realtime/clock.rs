//! The only module that reads clocks and sleeps.

use rustix::io::Errno;
use rustix::thread::clock_nanosleep_absolute;
use rustix::time::{ClockId, Timespec, clock_gettime};
use scheduler::time::Nanos;

const SECOND: u64 = 1_000_000_000;

pub fn monotonic() -> Nanos {
    nanos(clock_gettime(ClockId::Monotonic))
}

pub fn thread_cpu() -> Nanos {
    nanos(clock_gettime(ClockId::ThreadCPUTime))
}

/// Sleeps until host time `due`; returns at once if it has passed. The time is absolute: no drift.
pub fn sleep_until(due: Nanos) {
    let request = timespec(due);
    // A signal wakes the thread early; the time is absolute, so the call is repeated unchanged.
    while clock_nanosleep_absolute(ClockId::Monotonic, &request) == Err(Errno::INTR) {}
}

/// Converts a clock reading. Both parts are non-negative: these clocks count from boot or start.
fn nanos(time: Timespec) -> Nanos {
    let seconds = u64::try_from(time.tv_sec).unwrap_or(0);
    let rest = u64::try_from(time.tv_nsec).unwrap_or(0);
    Nanos::new(seconds.saturating_mul(SECOND).saturating_add(rest))
}

fn timespec(time: Nanos) -> Timespec {
    let seconds = i64::try_from(time.as_u64() / SECOND).unwrap_or(i64::MAX);
    // The remainder of a division by 10^9 fits.
    Timespec { tv_sec: seconds, tv_nsec: (time.as_u64() % SECOND).try_into().unwrap_or(0) }
}

/// Returns `seconds` (s), not negative, to the nearest nanosecond.
pub fn from_seconds(seconds: f64) -> Nanos {
    Nanos::new(nearest_integer(seconds * 1e9))
}

/// Returns the integer nearest to `count`; 0 for a negative one.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
pub fn nearest_integer(count: f64) -> u64 {
    count.round() as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sleep_is_not_over_before_it_is_due() {
        let due = monotonic().after(Nanos::from_micros(200));
        sleep_until(due);
        assert!(due <= monotonic());
        sleep_until(Nanos::ZERO);
    }
}
