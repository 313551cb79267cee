//! A recorded take in a loop: a source without a host.

use telemetry::recording::{OpenError, Playback, PlaybackClock, Recording};

/// The take; `demonstration/record.sh` records it.
const TAKE: &[u8] = include_bytes!("../demonstration/demonstration.mcap");

/// Returns the demonstration in a loop, in the time of `clock`; fails on an unsupported format.
pub fn demonstration(clock: PlaybackClock) -> Result<Playback, OpenError> {
    Ok(Playback::new(Recording::from_bytes("demonstration.mcap", TAKE)?, clock).repeating())
}
