//! The stroke before, played again with an earlier release.

use super::hand::PlannedKey;
use super::release;
use super::search::Try;
use super::{Practice, Rehearsal, RehearsedStroke};
use crate::stroke::PlannedStroke;

/// Parts of its hold that the stroke before may keep, the first that serves is taken.
const KEPT: [f64; 2] = [0.5, 0.0];

/// A hold shorter than this is not shortened (s).
const WORTHWHILE: f64 = 5e-3;

/// The stroke before, as it was before its release was chosen.
#[derive(Clone, Debug)]
pub(super) struct Last<R> {
    pub(super) hand: PlannedKey<R>,
    pub(super) found: Try,
}

impl<R: Rehearsal> Last<R> {
    /// Looks for an earlier release with which `wanted` can be played better.
    ///
    /// If there is one, the key, the stroke before and what was found for `wanted` are replaced.
    pub(super) fn make_room(
        &self,
        practice: &Practice<'_>,
        wanted: &PlannedStroke,
        (hand, stroke, found): (&mut PlannedKey<R>, &mut RehearsedStroke, &mut Try),
    ) {
        let earliest = release::earliest(&stroke.wanted, &self.found);
        let held = stroke.gesture.release - earliest;
        for kept in KEPT {
            if held < WORTHWHILE || found.is_acceptable() {
                return;
            }
            let latest = Some(earliest + kept * held);
            let mut other = self.hand.clone();
            let shortened = release::choose(&mut other, &stroke.wanted, &self.found, latest);
            let tried = practice.find(&mut other, wanted);
            if tried.cost < found.cost {
                (*hand, *stroke, *found) = (other, shortened, tried);
            }
        }
    }
}
