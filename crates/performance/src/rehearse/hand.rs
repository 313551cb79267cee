//! A key at some time, and the gestures it has been given.

use haptics::plant::Gesture;

use super::{PlayOutcome, Rehearsal};

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

    /// When the finger is free for the next gesture (s).
    pub(super) fn free_from(&self) -> f64 {
        self.script.iter().map(Gesture::end).fold(self.now, f64::max)
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

    /// Changes when the gesture that was given last is released (s).
    pub(super) fn release_at(&mut self, release: f64) {
        if let Some(last) = self.script.last_mut() {
            last.release = release;
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
