//! What the demonstration plays: a few notes, again and again.

use super::Pushes;

/// Length of the piece (ticks).
const LENGTH: u64 = 4000;

/// First tick, last tick, key and force (N) of each stroke.
const STROKES: [(u64, u64, u8, f64); 12] = [
    (250, 550, 39, 2.2),
    (700, 1200, 39, 5.5),
    (1250, 1650, 43, 4.0),
    (1500, 1900, 46, 4.5),
    (1750, 2350, 51, 6.0),
    (2400, 2950, 39, 6.5),
    (2400, 2950, 43, 5.0),
    (2400, 2950, 46, 5.2),
    (2400, 3200, 15, 7.0),
    (3000, 3250, 63, 3.5),
    (3250, 3500, 60, 4.0),
    (3500, 3750, 58, 5.0),
];

/// Returns the forces of the fingers in a tick (N).
pub(super) fn pushes(tick: u64) -> Pushes {
    let at = tick % LENGTH;
    let strokes = STROKES.iter().filter(|(from, to, _, _)| (*from..*to).contains(&at));
    strokes.map(|(from, _, key, newtons)| (*key, newtons * ramp(at - from))).collect()
}

/// Returns the share of a finger's force so many ticks after it began.
fn ramp(ticks: u64) -> f64 {
    (ticks as f64 / 30.0).min(1.0)
}

/// Returns the keys whose note ends in a tick.
pub(super) fn released(tick: u64) -> Vec<u8> {
    let at = tick % LENGTH;
    STROKES.iter().filter(|(_, to, _, _)| *to == at).map(|(_, _, key, _)| *key).collect()
}
