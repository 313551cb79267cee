//! All tracks as one sequence.

use midly::{Track, TrackEventKind};

/// An event of any track.
#[derive(Clone, Copy, Debug)]
pub(super) struct TrackEvent<'a> {
    /// Ticks since the start.
    pub(super) tick: u64,
    pub(super) kind: TrackEventKind<'a>,
}

/// Returns the events of all tracks in order of time; simultaneous ones in order of tracks.
pub(super) fn merge<'a>(tracks: &[Track<'a>]) -> Vec<TrackEvent<'a>> {
    let mut events: Vec<_> = tracks.iter().flat_map(timed).collect();
    events.sort_by_key(|event| event.tick);
    events
}

fn timed<'a>(track: &Track<'a>) -> Vec<TrackEvent<'a>> {
    let mut tick = 0;
    let timed = track.iter().map(|event| {
        tick += u64::from(event.delta.as_int());
        TrackEvent { tick, kind: event.kind }
    });
    timed.collect()
}
