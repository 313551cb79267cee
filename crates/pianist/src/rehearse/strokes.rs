//! Rehearsal of one key, stroke after stroke.

use std::collections::BTreeMap;

use super::release::{HeldStroke, Released};
use super::search::{SearchEffort, Try, find, find_usual};
use super::shortfall::IsFree;
use super::take::Take;
use super::{
    ACCEPTABLE, MISSING, Practice, QUICK_LIFT, Rehearsal, RehearsedStroke, SETTLED, Shortfall,
    price,
};
use crate::stroke::PlannedStroke;

/// Distance of the releases that are tried for a next stroke (s).
const STEP: f64 = 4e-3;

/// Releases that let the key come to rest, in steps before the latest one.
const REST_STRIDES: [u32; 11] = [0, 3, 6, 9, 12, 17, 25, 37, 55, 80, 110];

/// Steps between the releases that turn the key half-way up.
const TURN_STRIDE: usize = 4;
const FINE_TURN_STRIDE: usize = 2;

/// Latest and earliest release that may turn the key half-way up, in steps before the next strike.
const TURNS: (u32, u32) = (12, 40);

/// Time that a key at rest needs before a strike, beyond the stroke (s).
const RISE: f64 = 20e-3;

/// Gain for which a note is cut.
const WORTHWHILE: f64 = 1.0;

/// Cut for which a shorter one is searched (s).
const LONG_CUT: f64 = 0.12;

/// Price above which everything is tried.
const DEAR: f64 = 7.0;

/// Velocities that share what was learnt about cuts.
const ALIKE: u8 = 8;

pub(super) struct KeyStrokes<'a, R> {
    practice: Practice<'a>,
    strokes: &'a [PlannedStroke],
    /// The key with all gestures so far.
    take: Take<R>,
    rehearsed: Vec<RehearsedStroke>,
    last: Option<Last<R>>,
    /// Release that last served a stroke of some velocity, in steps before it.
    turns: BTreeMap<u8, u32>,
}

/// The last stroke that is played.
struct Last<R> {
    held: HeldStroke<R>,
    index: usize,
}

/// A way to play a stroke, with an earlier release of the one before.
struct Room<R> {
    released: Released<R>,
    /// Lost time of the previous note (s).
    cut: f64,
    found: Try<R>,
    /// Price of the cut and of the stroke.
    price: f64,
}

impl<'a, R: Rehearsal> KeyStrokes<'a, R> {
    pub(super) fn new(practice: Practice<'a>, instrument: R, strokes: &'a [PlannedStroke]) -> Self {
        let rehearsed = Vec::with_capacity(strokes.len());
        Self {
            practice,
            strokes,
            take: Take::new(instrument),
            rehearsed,
            last: None,
            turns: BTreeMap::new(),
        }
    }

    pub(super) fn rehearse(mut self, mut progress: impl FnMut()) -> Vec<RehearsedStroke> {
        for (index, wanted) in self.strokes.iter().enumerate() {
            let found = find_usual(&mut self.practice, &mut self.take, wanted);
            let is_free = self.is_free(wanted.onset);
            let found = match is_free {
                IsFree::No if !found.is_acceptable() => self.with_room(wanted, found),
                IsFree::No | IsFree::Yes => found,
            };
            match Shortfall::of(&self.practice, wanted, &found, is_free) {
                Some(shortfall) if shortfall.is_left_out() => {
                    let left_out = RehearsedStroke::left_out(wanted, shortfall, found.n_tries);
                    self.rehearsed.push(left_out);
                }
                shortfall => self.keep(index, found, shortfall),
            }
            progress();
        }
        let take = self.take.clone();
        self.complete(&take, f64::INFINITY, f64::INFINITY);
        self.rehearsed
    }

    /// Returns [`IsFree::Yes`] if the key is certainly at rest before `onset` (s).
    fn is_free(&self, onset: f64) -> IsFree {
        let last = self.last.as_ref().and_then(|last| self.rehearsed[last.index].gesture);
        let is_free = last.is_none_or(|gesture| SETTLED < onset - gesture.release);
        if is_free { IsFree::Yes } else { IsFree::No }
    }

    /// Returns the best try for `wanted`; `found` is the best so far. The previous stroke is
    /// released earlier if that gains more than the note loses.
    fn with_room(&mut self, wanted: &'a PlannedStroke, found: Try<R>) -> Try<R> {
        let Some(mut last) = self.last.take() else { return found };
        let mut rooms = RoomSearch::new(self, &last, wanted, found);
        rooms.search(self, &mut last);
        let RoomSearch { found, best, .. } = rooms;
        let found = match best {
            Some(Room { released, cut, found, .. }) => {
                let before = &mut self.rehearsed[last.index];
                (before.gesture, before.cut) = (Some(released.gesture), cut);
                self.take = released.take;
                found
            }
            None => found,
        };
        self.last = Some(last);
        found
    }

    fn keep(&mut self, index: usize, found: Try<R>, shortfall: Option<Shortfall>) {
        let wanted = &self.strokes[index];
        let strike = found.strike;
        let struck = strike.map_or(wanted.onset, |strike| strike.at);
        self.complete(&found.take, found.gesture.start, struck);
        let mut stroke = RehearsedStroke { shortfall, strike, ..RehearsedStroke::new(wanted) };
        stroke.n_tries = found.n_tries;
        let mut held = HeldStroke::new(found, wanted);
        let next = self.strokes.get(index + 1).map_or(f64::INFINITY, |next| next.onset);
        let released = held.release(&self.practice, wanted, next);
        stroke.gesture = Some(released.gesture);
        stroke.n_tries += released.n_tries;
        self.take = released.take;
        self.rehearsed.push(stroke);
        self.last = Some(Last { held, index });
    }

    /// Adds to the last stroke what `take` has of it, when the next finger begins at `start` (s) and
    /// strikes at `struck` (s).
    fn complete(&mut self, take: &Take<R>, start: f64, struck: f64) {
        let Some(last) = &self.last else { return };
        let stroke = &mut self.rehearsed[last.index];
        let Some(gesture) = stroke.gesture else { return };
        stroke.n_strikes = take.strikes(gesture.start, start).count();
        stroke.damper_fall = take.fall(gesture.release, struck);
        if 0.0 < stroke.cut {
            let end = stroke.damper_fall.map_or(struck, |fall| fall.at);
            stroke.cut = (stroke.wanted.end - end).max(0.0);
        }
    }
}

struct RoomSearch<'a, R> {
    wanted: &'a PlannedStroke,
    /// Best try without an earlier release.
    found: Try<R>,
    best: Option<Room<R>>,
    /// Latest and earliest release, in steps before the stroke.
    steps: (u32, u32),
    /// Steps from which a stroke begins at rest.
    rest: u32,
}

impl<'a, R: Rehearsal> RoomSearch<'a, R> {
    fn new(
        strokes: &KeyStrokes<'a, R>,
        last: &Last<R>,
        wanted: &'a PlannedStroke,
        found: Try<R>,
    ) -> Self {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some steps")]
        let steps = |before: f64| (before / STEP).max(0.0) as u32;
        let practice = &strokes.practice;
        let end = strokes.strokes[last.index].end;
        let latest = wanted.onset - end + practice.tables.lifts.fall(QUICK_LIFT);
        let earliest = (wanted.onset - last.held.earliest).min(SETTLED);
        let rest = steps(practice.guess(wanted.touch, wanted).1 + RISE);
        Self { wanted, found, best: None, steps: (steps(latest), steps(earliest)), rest }
    }

    fn price(&self) -> f64 {
        self.best.as_ref().map_or(self.found.price.min(MISSING) - WORTHWHILE, |it| it.price)
    }

    /// Tries what served an equal stroke, then starts from rest, then a key turned half-way up.
    fn search(&mut self, strokes: &mut KeyStrokes<'a, R>, last: &mut Last<R>) {
        let (latest, earliest) = self.steps;
        let alike = self.wanted.velocity.get() / ALIKE;
        let known = strokes.turns.get(&alike).copied();
        let known = known.filter(|it| (latest + 1..=earliest).contains(it));
        for effort in [SearchEffort::Usual, SearchEffort::Scan] {
            if self.serves(strokes, last, known.into_iter(), effort) {
                return;
            }
        }
        // If no release is earlier, the earliest one shows how late the stroke would be.
        let is_only = earliest <= latest;
        let resting = if is_only { earliest } else { self.rest.max(latest + 1) };
        let resting = REST_STRIDES.iter().map(|later| resting + later);
        let resting = resting.take_while(|it| *it <= earliest);
        if !self.serves(strokes, last, resting, SearchEffort::Usual) || self.is_cut_long() {
            if latest <= TURNS.1 {
                self.again(strokes, SearchEffort::Scan);
            }
            self.serves(strokes, last, self.turns(TURN_STRIDE), SearchEffort::Scan);
        }
        if DEAR < self.price() {
            self.again(strokes, SearchEffort::Everything);
            self.serves(strokes, last, self.turns(FINE_TURN_STRIDE), SearchEffort::Everything);
        }
    }

    /// Returns the releases that turn the key half-way up, in steps before the stroke.
    fn turns(&self, stride: usize) -> impl Iterator<Item = u32> + use<R> {
        let (latest, earliest) = self.steps;
        (TURNS.0.max(latest + 1)..=earliest.min(TURNS.1)).step_by(stride)
    }

    /// Returns `true` if a listener would notice the cut.
    fn is_cut_long(&self) -> bool {
        let is_long = |best: &Room<R>| LONG_CUT < best.cut || DEAR < best.price - best.found.price;
        self.best.as_ref().is_some_and(is_long)
    }

    /// Searches without an earlier release again, with more `effort`.
    fn again(&mut self, strokes: &mut KeyStrokes<'a, R>, effort: SearchEffort) {
        let again = find(&mut strokes.practice, &mut strokes.take, self.wanted, effort);
        if let Some(again) = again
            && again.price < self.found.price
        {
            self.found = again;
            self.best = self.best.take().filter(|best| best.price < self.found.price - WORTHWHILE);
        }
    }

    /// Tries `releases` (steps before the stroke) until one serves; returns `true` if so.
    fn serves(
        &mut self,
        strokes: &mut KeyStrokes<'a, R>,
        last: &mut Last<R>,
        releases: impl Iterator<Item = u32>,
        effort: SearchEffort,
    ) -> bool {
        let enough = if effort == SearchEffort::Everything { price::FAIR } else { ACCEPTABLE };
        for steps in releases {
            if self.found.price <= enough {
                return true;
            }
            let Some(room) = self.room(strokes, last, steps, effort) else { continue };
            let serves = room.found.price <= enough;
            let is_too_dear = self.price() <= room.price - room.found.price;
            if room.price < self.price() {
                let alike = self.wanted.velocity.get() / ALIKE;
                strokes.turns.extend(serves.then_some((alike, steps)));
                self.best = Some(room);
            } else if room.found.price < self.found.price && MISSING <= self.found.price {
                // Neither is played: the report has the nearer one.
                self.found = Try { price: room.found.price.max(MISSING), ..room.found };
            }
            if is_too_dear {
                return false;
            }
            // An earlier release costs more.
            if serves {
                return true;
            }
        }
        false
    }

    /// Tries the stroke after a quick release of the last one, so many steps before.
    fn room(
        &self,
        strokes: &mut KeyStrokes<'a, R>,
        last: &mut Last<R>,
        steps: u32,
        effort: SearchEffort,
    ) -> Option<Room<R>> {
        let before = &strokes.strokes[last.index];
        let mut released =
            last.held.released(self.wanted.onset - f64::from(steps) * STEP, QUICK_LIFT);
        let found = find(&mut strokes.practice, &mut released.take, self.wanted, effort)?;
        let struck = found.strike.map_or(f64::INFINITY, |strike| strike.at);
        let fall = released.gesture.release + strokes.practice.tables.lifts.fall(QUICK_LIFT);
        let cut = (before.end - fall.min(struck)).max(0.0);
        let price = found.price + price::cut(before.end - before.onset, cut);
        Some(Room { released, cut, found, price })
    }
}
