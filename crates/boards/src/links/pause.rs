use std::time::Duration;

/// Sleeps for `length`: for set-up and threads beside the tick, never in it.
#[expect(clippy::disallowed_methods, reason = "the only place that sleeps, and none of the tick")]
pub fn pause(length: Duration) {
    std::thread::sleep(length);
}
