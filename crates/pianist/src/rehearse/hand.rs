//! A key at some time, and the gestures given so far.

use haptics::plant::Gesture;

use super::{PlayOutcome, Rehearsal};

/// Fraction of its lift after which a finger no longer pushes its key. A finger is as high as the
/// key's bottom after a third.
const CLEARED: f64 = 0.35;

/// Time of the quickest lift of a finger (s) (estimate).
pub(super) const QUICK_LIFT: f64 = 20e-3;

/// Time between two samples of a rising key (s).
pub(super) const LOOK: f64 = 1e-3;

/// Most samples: a key that takes longer is held, or hangs.
pub(super) const LONGEST_RISE: u16 = 400;

/// Depth below which a key counts as up (m).
const UP: f64 = 0.3e-3;

/// Deepest start of a stroke (m): a key that stayed deeper has not reset its action.
pub(super) const DEEPEST: f64 = 6.5e-3;

#[derive(Clone, PartialEq, Debug)]
pub(super) struct KeyRise {
    /// Time when the finger begins to lift (s).
    begin: f64,
    /// Depths of the key then and every millisecond later (m), until it is up.
    depths: Vec<f64>,
}

impl KeyRise {
    /// Returns the depth from which a finger starts at `at` (s): that of the key, limited to
    /// [`DEEPEST`] (m).
    pub(super) fn depth(&self, at: f64) -> f64 {
        let looks = ((at - self.begin) / LOOK).max(0.0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "not negative")]
        let depth = self.depths.get(looks.ceil() as usize).copied().unwrap_or(0.0);
        // Round up to the later, higher sample, so that no finger starts within its key.
        if depth < UP { 0.0 } else { depth.min(DEEPEST) }
    }
}

#[derive(Clone, Debug)]
pub(super) struct PlannedKey<R> {
    instrument: R,
    /// Present time of the instrument (s).
    now: f64,
    script: Vec<Gesture>,
}

impl<R: Rehearsal> PlannedKey<R> {
    pub(super) fn new(instrument: R) -> Self {
        Self { instrument, now: 0.0, script: Vec::new() }
    }

    /// Returns the time of the key (s): no gesture can begin or end earlier any more.
    pub(super) fn now(&self) -> f64 {
        self.now
    }

    /// Returns the time from which the previous finger no longer pushes (s).
    pub(super) fn free_from(&self) -> f64 {
        let cleared = |gesture: &Gesture| gesture.release + CLEARED * gesture.lift;
        self.script.iter().map(cleared).fold(self.now, f64::max)
    }

    /// Returns the rise of the key from now on, if its finger is lifting.
    pub(super) fn rise(&self) -> KeyRise {
        let begin = self.script.iter().map(|gesture| gesture.release).fold(self.now, f64::max);
        let mut instrument = self.instrument.clone();
        let mut depths = Vec::new();
        let mut is_up = self.script.is_empty() || !begin.is_finite();
        while !is_up && depths.len() < LONGEST_RISE.into() {
            instrument.play(&self.script, begin + depths.len() as f64 * LOOK);
            depths.push(instrument.depth());
            is_up = instrument.depth() < UP;
        }
        KeyRise { begin, depths }
    }

    /// Plays `gesture` until `until` (s) on a copy of the key.
    pub(super) fn try_out(&self, gesture: Gesture, until: f64) -> PlayOutcome {
        let mut script = self.script.clone();
        script.push(gesture);
        self.instrument.clone().play(&script, until)
    }

    pub(super) fn keep(&mut self, gesture: Gesture) {
        self.script.push(gesture);
    }

    /// Sets release and lift of the latest gesture (s).
    pub(super) fn let_go(&mut self, release: f64, lift: f64) {
        if let Some(last) = self.script.last_mut() {
            (last.release, last.lift) = (release, lift);
        }
    }

    /// Plays until `until` (s), unless that is past.
    pub(super) fn advance(&mut self, until: f64) -> PlayOutcome {
        if until <= self.now {
            return PlayOutcome::default();
        }
        let outcome = self.instrument.play(&self.script, until);
        self.now = until;
        self.script.retain(|gesture| gesture.end() >= until);
        outcome
    }

    /// Plays the given gestures until `until` (s) on a copy of the key.
    pub(super) fn look_ahead(&self, until: f64) -> PlayOutcome {
        self.instrument.clone().play(&self.script, until)
    }
}
