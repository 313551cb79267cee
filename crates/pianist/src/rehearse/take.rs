//! A key in motion, with snapshots to which a search returns.

use haptics::plant::Gesture;

use super::{DamperFall, Rehearsal, Strike};

/// Time between two samples of the key's depth (s).
const LOOK: f64 = 1e-3;

/// Samples between two snapshots. A copy of a grand's key costs less than a moving tick.
const PER_MARK: usize = 8;

/// Depth below which a key counts as up (m).
const UP: f64 = 0.3e-3;

/// Deepest start of a stroke (m): a key that stayed deeper has not reset its action.
const DEEPEST: f64 = 6.5e-3;

/// Time after a finger has left its key from which a stroke counts as one from rest (s).
const STILL: f64 = 0.2;

/// Fraction of its lift after which a finger no longer pushes its key. A finger is as high as the
/// key's bottom after a third.
const CLEARED: f64 = 0.35;

#[derive(Clone, Debug)]
struct TakeMark<R> {
    instrument: R,
    /// Samples, strikes and falls before.
    n: [usize; 3],
}

/// One way to play a key: the gestures, the events so far, and snapshots of the way.
#[derive(Clone, Debug)]
pub(super) struct Take<R> {
    script: Vec<Gesture>,
    instrument: R,
    /// Time of the first snapshot (s): no gesture can begin or end earlier.
    begin: f64,
    marks: Vec<TakeMark<R>>,
    /// Depths of the key after each [`LOOK`] since then (m).
    depths: Vec<f64>,
    strikes: Vec<Strike>,
    falls: Vec<DamperFall>,
}

impl<R: Rehearsal> Take<R> {
    pub(super) const fn new(instrument: R) -> Self {
        Self {
            script: Vec::new(),
            instrument,
            begin: 0.0,
            marks: Vec::new(),
            depths: Vec::new(),
            strikes: Vec::new(),
            falls: Vec::new(),
        }
    }

    /// Returns the time of the instrument (s).
    fn now(&self) -> f64 {
        self.begin + self.depths.len() as f64 * LOOK
    }

    /// Returns the earliest time at which a gesture can begin or end (s).
    pub(super) fn earliest(&self) -> f64 {
        self.begin + 2.0 * self.instrument.period()
    }

    /// Returns the time from which the previous finger no longer pushes (s), if there was one.
    fn left_at(&self) -> f64 {
        let cleared = |gesture: &Gesture| gesture.release + CLEARED * gesture.lift;
        self.script.iter().map(cleared).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Returns the time from which a finger can begin (s).
    pub(super) fn free_from(&self) -> f64 {
        self.left_at().max(self.earliest())
    }

    /// Returns `true` if the key is at rest at `at` (s): it is up, and no finger left it lately.
    pub(super) fn is_still(&self, at: f64) -> bool {
        self.left_at() + STILL < at && self.depth(at) == 0.0
    }

    /// Returns the depth from which a finger starts at `at` (s): that of the key (m), limited to
    /// [`DEEPEST`]; the last one if `at` is later than the take.
    pub(super) fn depth(&self, at: f64) -> f64 {
        let looks = ((at - self.begin) / LOOK).max(0.0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "not negative")]
        let before = looks as usize;
        let sample = |index| self.depths.get(index).or(self.depths.last()).copied();
        let end = sample(before).unwrap_or_else(|| self.instrument.depth());
        let start = before.checked_sub(1).and_then(sample).unwrap_or(end);
        let depth = start + (end - start) * looks.fract();
        if depth < UP { 0.0 } else { depth.min(DEEPEST) }
    }

    /// Plays until `until` (s), without snapshots on the way.
    pub(super) fn skip(&mut self, until: f64) {
        if until <= self.now() {
            return;
        }
        self.play(until);
        let known = self.script.last().map_or(0.0, |gesture| gesture.start);
        self.strikes.retain(|it| known <= it.at);
        self.falls.retain(|it| known <= it.at);
        self.begin = until;
        self.marks.clear();
        self.depths.clear();
    }

    /// Plays until `until` (s), or until `is_over`.
    pub(super) fn record(&mut self, until: f64, is_over: impl Fn(&Self) -> bool) {
        while self.now() < until && !is_over(self) {
            if self.depths.len().is_multiple_of(PER_MARK) {
                let n = [self.depths.len(), self.strikes.len(), self.falls.len()];
                self.marks.push(TakeMark { instrument: self.instrument.clone(), n });
            }
            self.play(self.now() + LOOK);
            self.depths.push(self.instrument.depth());
        }
    }

    fn play(&mut self, until: f64) {
        let outcome = self.instrument.play(&self.script, until);
        self.strikes.extend(outcome.strikes);
        self.falls.extend(outcome.damper_fall);
    }

    /// Returns a copy until `at` (s), with `gesture` added, or replacing the one of equal start.
    pub(super) fn branch(&self, at: f64, gesture: Gesture) -> Self {
        let due = at - 2.0 * self.instrument.period();
        let time = |mark: &TakeMark<R>| self.begin + mark.n[0] as f64 * LOOK;
        let early = self.marks.partition_point(|mark| time(mark) <= due);
        let (begin, instrument, [_, strikes, falls]) = match self.marks.get(early.max(1) - 1) {
            Some(mark) => (time(mark), &mark.instrument, mark.n),
            None => (self.begin, &self.instrument, [0, self.strikes.len(), self.falls.len()]),
        };
        let others = self.script.iter().filter(|it| it.start < gesture.start && begin <= it.end());
        Self {
            script: others.copied().chain([gesture]).collect(),
            instrument: instrument.clone(),
            begin,
            marks: Vec::new(),
            depths: Vec::new(),
            strikes: self.strikes[..strikes].to_vec(),
            falls: self.falls[..falls].to_vec(),
        }
    }

    /// Returns the strikes in `from .. until` (s).
    pub(super) fn strikes(&self, from: f64, until: f64) -> impl Iterator<Item = &Strike> {
        self.strikes.iter().filter(move |it| (from..until).contains(&it.at))
    }

    /// Returns the last fall of the damper in `from .. until` (s).
    pub(super) fn fall(&self, from: f64, until: f64) -> Option<DamperFall> {
        self.falls.iter().rfind(|it| (from..until).contains(&it.at)).copied()
    }
}
