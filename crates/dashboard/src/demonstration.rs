//! A recorded take in a loop: a source without a host.

use telemetry::recording::{OpenError, Playback, PlaybackClock, Recording};

/// The take. `demonstration/record.sh` makes it.
const TAKE: &[u8] = include_bytes!("../demonstration/demonstration.mcap");

/// Plays the demonstration from its beginning, again and again, in the time of `clock`.
///
/// # Errors
/// If the take has a format that this version does not read.
pub fn demonstration(clock: PlaybackClock) -> Result<Playback, OpenError> {
    Ok(Playback::new(Recording::from_bytes("demonstration.mcap", TAKE)?, clock).repeating())
}
