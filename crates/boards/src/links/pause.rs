//! Waiting, for set-up and for threads beside the tick; never in it.

use std::time::Duration;

/// Lets the calling thread sleep for `length`.
#[expect(clippy::disallowed_methods, reason = "the only place that sleeps, and none of the tick")]
pub fn pause(length: Duration) {
    std::thread::sleep(length);
}
