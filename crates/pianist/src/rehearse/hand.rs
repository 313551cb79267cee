//! A key at some time, and the gestures it has been given.

use haptics::plant::Gesture;

use super::{PlayOutcome, Rehearsal};

/// Part of its lift after which a finger pushes its key no more: it is as high as the key's bottom
/// was after a third.
const CLEARED: f64 = 0.35;

/// Time of the quickest lift of a finger (s) (estimate).
pub(super) const QUICK_LIFT: f64 = 20e-3;

/// Time between two looks at a key that rises (s).
pub(super) const LOOK: f64 = 1e-3;

/// Most looks: then the key is held, or hangs.
pub(super) const LONGEST_RISE: u16 = 400;

/// A key is up that is less deep than this (m).
const UP: f64 = 0.3e-3;

/// Deepest start of a stroke (m): a key that was not higher has re-set no action.
pub(super) const DEEPEST: f64 = 6.5e-3;

/// How a key rises after it was let go.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct KeyRise {
    /// When the finger begins to lift (s).
    begin: f64,
    /// How deep the key is then and every millisecond later (m), until it is up.
    depths: Vec<f64>,
}

impl KeyRise {
    /// Depth at which a finger starts that takes over at `at` (s): where the key is, unless that
    /// is too deep to strike from (m).
    pub(super) fn depth(&self, at: f64) -> f64 {
        let looks = ((at - self.begin) / LOOK).max(0.0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "not negative")]
        let depth = self.depths.get(looks.ceil() as usize).copied().unwrap_or(0.0);
        // The look after is higher: a finger is never placed within its key.
        if depth < UP { 0.0 } else { depth.min(DEEPEST) }
    }
}

/// The key as the strokes found so far leave it.
#[derive(Clone, Debug)]
pub(super) struct PlannedKey<R> {
    instrument: R,
    /// Present time of the instrument (s).
    now: f64,
    /// Gestures that still matter.
    script: Vec<Gesture>,
}

impl<R: Rehearsal> PlannedKey<R> {
    pub(super) fn new(instrument: R) -> Self {
        Self { instrument, now: 0.0, script: Vec::new() }
    }

    /// Present time of the key (s): no gesture can begin or end earlier any more.
    pub(super) fn now(&self) -> f64 {
        self.now
    }

    /// When the next finger may take over from the one before (s): that one pushes no more.
    pub(super) fn free_from(&self) -> f64 {
        let cleared = |gesture: &Gesture| gesture.release + CLEARED * gesture.lift;
        self.script.iter().map(cleared).fold(self.now, f64::max)
    }

    /// How the key rises from now on, if the finger that plays it is on its way up.
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

    /// What `gesture` would do until `until` (s); nothing is changed.
    pub(super) fn try_out(&self, gesture: Gesture, until: f64) -> PlayOutcome {
        let mut script = self.script.clone();
        script.push(gesture);
        self.instrument.clone().play(&script, until)
    }

    /// Gives the key `gesture`.
    pub(super) fn keep(&mut self, gesture: Gesture) {
        self.script.push(gesture);
    }

    /// Changes when the gesture that was given last is released, and how long it is lifted (s).
    pub(super) fn let_go(&mut self, release: f64, lift: f64) {
        if let Some(last) = self.script.last_mut() {
            (last.release, last.lift) = (release, lift);
        }
    }

    /// Plays on until `until` (s), unless that is past.
    pub(super) fn advance(&mut self, until: f64) -> PlayOutcome {
        if until <= self.now {
            return PlayOutcome::default();
        }
        let outcome = self.instrument.play(&self.script, until);
        self.now = until;
        self.script.retain(|gesture| gesture.end() >= until);
        outcome
    }

    /// What the gestures that were given do until `until` (s); nothing is changed.
    pub(super) fn look_ahead(&self, until: f64) -> PlayOutcome {
        self.instrument.clone().play(&self.script, until)
    }
}
