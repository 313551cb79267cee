//! The previous stroke, played again with another release.

use haptics::plant::Gesture;

use super::hand::PlannedKey;
use super::release;
use super::search::Try;
use super::{LATEST, Practice, Rehearsal, RehearsedStroke, SETTLED};
use crate::stroke::PlannedStroke;

/// Fractions of its hold that the previous stroke may keep; the first that suffices is used.
const KEPT: [f64; 4] = [0.75, 0.5, 0.25, 0.0];

/// Shortest hold that is shortened (s).
const WORTHWHILE: f64 = 5e-3;

/// Fraction of its cost that an unmet stroke may keep to justify a cut hold.
const GAIN: f64 = 0.5;

/// The previous stroke before its release was chosen.
#[derive(Clone, Debug)]
pub(super) struct Last<R> {
    pub(super) hand: PlannedKey<R>,
    pub(super) found: Try,
    pub(super) index: usize,
}

pub(super) struct Room<R> {
    pub(super) hand: PlannedKey<R>,
    /// The previous stroke with that release.
    pub(super) stroke: RehearsedStroke,
    /// Best try for the next stroke.
    pub(super) found: Try,
}

/// Returns `true` if a key that `gesture` releases is at rest by `onset` (s).
pub(super) fn is_past(gesture: &Gesture, onset: f64) -> bool {
    onset - gesture.release > SETTLED
}

impl<R: Rehearsal> Last<R> {
    /// Searches for an earlier release with which `wanted` can be played better than `found`;
    /// `None` if none helps, and the previous stroke keeps its length.
    pub(super) fn make_room(
        &self,
        practice: &Practice<'_>,
        wanted: &PlannedStroke,
        stroke: &RehearsedStroke,
        found: &Try,
    ) -> Option<Room<R>> {
        let earliest = release::earliest(&stroke.wanted, &self.found);
        let gesture = stroke.gesture?;
        let held = gesture.release - earliest;
        let turned = earliest + practice.turn(wanted.speed);
        if held < WORTHWHILE || turned > wanted.onset + LATEST {
            return None;
        }
        let mut best: Option<Room<R>> = None;
        for kept in KEPT {
            let latest = Some(earliest + kept * held);
            let (mut hand, shortened) = self.let_go(practice, stroke, latest);
            let found = practice.find(&mut hand, wanted);
            if best.as_ref().is_none_or(|best| found.cost < best.found.cost) {
                best = Some(Room { hand, stroke: shortened, found });
            }
            if found.is_acceptable() {
                break;
            }
        }
        best.filter(|it| it.found.is_acceptable() || it.found.cost < GAIN * found.cost)
    }

    /// Returns the key after the previous stroke, and `stroke` released by `latest` (s).
    pub(super) fn let_go(
        &self,
        practice: &Practice<'_>,
        stroke: &RehearsedStroke,
        latest: Option<f64>,
    ) -> (PlannedKey<R>, RehearsedStroke) {
        let mut hand = self.hand.clone();
        let again = release::choose(practice, &mut hand, &stroke.wanted, &self.found, latest);
        (hand, RehearsedStroke { shortfall: stroke.shortfall, ..again })
    }
}
