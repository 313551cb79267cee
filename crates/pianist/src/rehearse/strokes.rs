//! Rehearsal of one key, stroke after stroke.

use super::hand::PlannedKey;
use super::last::Last;
use super::search::Try;
use super::shortfall::IsFree;
use super::{Practice, Rehearsal, RehearsedStroke, Shortfall, release};
use crate::stroke::PlannedStroke;

pub(super) struct KeyStrokes<'a, R> {
    practice: &'a Practice<'a>,
    strokes: &'a [PlannedStroke],
    hand: PlannedKey<R>,
    rehearsed: Vec<RehearsedStroke>,
    last: Option<Last<R>>,
}

impl<'a, R: Rehearsal> KeyStrokes<'a, R> {
    pub(super) fn new(
        practice: &'a Practice<'a>,
        instrument: R,
        strokes: &'a [PlannedStroke],
    ) -> Self {
        let rehearsed = Vec::with_capacity(strokes.len());
        Self { practice, strokes, hand: PlannedKey::new(instrument), rehearsed, last: None }
    }

    pub(super) fn rehearse(mut self, mut progress: impl FnMut()) -> Vec<RehearsedStroke> {
        for (index, wanted) in self.strokes.iter().enumerate() {
            let found = self.practice.find(&mut self.hand, wanted);
            let is_free = self.is_free(wanted.onset);
            let found = if found.is_acceptable() || is_free == IsFree::Yes {
                found
            } else {
                self.with_room(index, found)
            };
            match Shortfall::of(self.practice, wanted, &found, is_free) {
                Some(shortfall) if shortfall.is_left_out() => {
                    let left_out = RehearsedStroke::left_out(wanted, shortfall, found.n_tries);
                    self.rehearsed.push(left_out);
                }
                shortfall => self.keep(index, found, shortfall),
            }
            progress();
        }
        self.rehearsed
    }

    /// Returns [`IsFree::Yes`] if the key is certainly at rest before `onset` (s).
    fn is_free(&self, onset: f64) -> IsFree {
        let before = self.last.as_ref().and_then(|last| self.rehearsed.get(last.index));
        let gesture = before.and_then(|stroke| stroke.gesture);
        if gesture.is_none_or(|it| super::last::is_past(&it, onset)) {
            IsFree::Yes
        } else {
            IsFree::No
        }
    }

    /// Returns the best try for the stroke `index`; `found` is the best so far. The previous stroke
    /// is released earlier if that helps, and regains its length if this one is left out.
    fn with_room(&mut self, index: usize, found: Try) -> Try {
        let wanted = &self.strokes[index];
        let is_left_out = |found: &Try| {
            let shortfall = Shortfall::of(self.practice, wanted, found, IsFree::No);
            shortfall.is_some_and(|it| it.is_left_out())
        };
        let latest = self.latest_release(index);
        let Some(last) = &self.last else { return found };
        let stroke = &mut self.rehearsed[last.index];
        let room = last.make_room(self.practice, wanted, stroke, &found);
        if let Some(room) = room.filter(|room| !is_left_out(&room.found)) {
            *stroke = room.stroke;
            self.hand = room.hand;
            return room.found;
        }
        if is_left_out(&found) {
            (self.hand, *stroke) = last.let_go(self.practice, stroke, latest);
        }
        found
    }

    fn keep(&mut self, index: usize, found: Try, shortfall: Option<Shortfall>) {
        let before = self.hand.clone();
        let latest = self.latest_release(index);
        let wanted = &self.strokes[index];
        let stroke = release::choose(self.practice, &mut self.hand, wanted, &found, latest);
        self.rehearsed.push(RehearsedStroke { shortfall, ..stroke });
        self.last = Some(Last { hand: before, found, index });
    }

    /// Returns the latest release (s) for the stroke after `index`, if there is one.
    fn latest_release(&self, index: usize) -> Option<f64> {
        self.strokes.get(index + 1).map(|next| self.practice.latest_release(next))
    }
}
