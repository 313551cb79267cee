//! The stroke before, played again with another release.

use haptics::plant::Gesture;

use super::hand::PlannedKey;
use super::release;
use super::search::Try;
use super::{LATEST, Practice, Rehearsal, RehearsedStroke, SETTLED};
use crate::stroke::PlannedStroke;

/// Parts of its hold that the stroke before may keep, the first that serves is taken.
const KEPT: [f64; 4] = [0.75, 0.5, 0.25, 0.0];

/// A hold shorter than this is not shortened (s).
const WORTHWHILE: f64 = 5e-3;

/// Part of its cost that a stroke may keep where it is not met even so, for a hold to be cut.
const GAIN: f64 = 0.5;

/// The stroke before, as it was before its release was chosen.
#[derive(Clone, Debug)]
pub(super) struct Last<R> {
    pub(super) hand: PlannedKey<R>,
    pub(super) found: Try,
    /// Its number among the strokes.
    pub(super) index: usize,
}

/// What another release of the stroke before gives.
pub(super) struct Room<R> {
    pub(super) hand: PlannedKey<R>,
    /// The stroke before, with that release.
    pub(super) stroke: RehearsedStroke,
    /// What is then found for the next one.
    pub(super) found: Try,
}

/// Whether a key that is let go as `gesture` says is at rest by `onset` (s).
pub(super) fn is_past(gesture: &Gesture, onset: f64) -> bool {
    onset - gesture.release > SETTLED
}

impl<R: Rehearsal> Last<R> {
    /// Looks for an earlier release with which `wanted` can be played, for which `found` is the
    /// best so far; none where that does not help, and the stroke before keeps its length.
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

    /// The key after the stroke before, and that `stroke` with a release not after `latest` (s).
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
