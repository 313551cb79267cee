//! Search by simulation for the gesture that gives a hammer speed at a time.
//!
//! One key, stroke after stroke, each from the state that the strokes before it leave:
//!
//! 1. advance to a little before the stroke must begin;
//! 2. guess speed and start from the [`StrokeTable`] of the key at rest;
//! 3. try on a copy of the key, and correct both, until speed and onset are as wanted;
//! 4. if the touch does not suffice, try the other one;
//! 5. if the key is not up yet, strike from its depth, release the previous stroke earlier and more
//!    quickly, and try again;
//! 6. if the stroke is still late, leave it out and restore the length of the previous stroke;
//! 7. choose the release so that the damper falls when it should and the next stroke has room;
//! 8. keep the stroke and continue.
//!
//! The result depends on the arguments alone: the same strokes give the same bits.

mod hand;
mod last;
mod release;
mod search;
mod shortfall;
mod strokes;
mod table;

use haptics::plant::{Gesture, Touch};
use midi::VelocityCurve;

use crate::stroke::{PlannedStroke, Technique};
use hand::PlannedKey;
use search::Try;
pub use shortfall::{LATEST, Shortfall};
use strokes::KeyStrokes;
pub use table::{StrokeTable, StrokeTables, tabulate};

/// Allowance over the least time to strike again, for choosing a release.
const SLACK: f64 = 1.15;

/// Time after a release by which a key is at rest (s): no earlier release would help.
const SETTLED: f64 = 0.6;

/// Guess for a key that was not seen to rise: time from a quick release until it can be struck (s).
const USUAL_RISE: f64 = 35e-3;

/// A key with its action for trials, at rest at time 0 when new; a copy is a snapshot.
pub trait Rehearsal: Clone {
    /// Plays until `until` (s). `gestures`, in order of start, are all that matter from now on. The
    /// motion before a release does not depend on the time of the release.
    fn play(&mut self, gestures: &[Gesture], until: f64) -> PlayOutcome;

    /// Returns the depth of the key's front (m), down positive.
    fn depth(&self) -> f64;
}

/// Events while a key was played.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct PlayOutcome {
    pub strikes: Vec<Strike>,
    /// Time of the latest fall of the damper (s), if it fell.
    pub damper_fall: Option<f64>,
}

/// A meeting of hammer and string.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Strike {
    /// Time of the strike (s).
    pub at: f64,
    /// Hammer speed at the string (m/s).
    pub speed: f64,
}

/// A stroke with its gesture.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RehearsedStroke {
    pub wanted: PlannedStroke,
    /// Motion of the finger; `None` if the stroke is left out.
    pub gesture: Option<Gesture>,
    /// Reason why it is not played as written, if it is not.
    pub shortfall: Option<Shortfall>,
    pub strike: Option<Strike>,
    /// Number of strikes; more than one is a bouncing hammer.
    pub n_strikes: usize,
    /// Time of the damper's fall (s), if seen.
    pub damper_fall: Option<f64>,
    pub n_tries: u32,
}

impl RehearsedStroke {
    const fn left_out(wanted: &PlannedStroke, shortfall: Shortfall, n_tries: u32) -> Self {
        Self {
            wanted: *wanted,
            gesture: None,
            shortfall: Some(shortfall),
            strike: None,
            n_strikes: 0,
            damper_fall: None,
            n_tries,
        }
    }
}

/// Inputs of a rehearsal.
#[derive(Clone, Copy, Debug)]
pub struct Practice<'a> {
    /// First guesses for this key.
    pub tables: &'a StrokeTables,
    pub curve: VelocityCurve,
    pub technique: &'a Technique,
}

impl Practice<'_> {
    /// Finds gestures for `strokes`, of one key in order of onset; calls `progress` after each.
    pub fn rehearse<R: Rehearsal>(
        &self,
        instrument: R,
        strokes: &[PlannedStroke],
        progress: impl FnMut(),
    ) -> Vec<RehearsedStroke> {
        KeyStrokes::new(self, instrument, strokes).rehearse(progress)
    }

    /// Finds speed and start, by the wanted touch or else by the other.
    fn find<R: Rehearsal>(&self, hand: &mut PlannedKey<R>, wanted: &PlannedStroke) -> Try {
        let touch = wanted.touch;
        let (_, delay) = self.guess(touch, wanted.speed);
        let (_, other_delay) = self.guess(other(touch), wanted.speed);
        hand.advance(wanted.onset - search::reach(delay.max(other_delay)));
        let rise = hand.rise();
        let first = search::find(self, hand, wanted, touch, &rise);
        if first.is_acceptable() {
            return first;
        }
        let second = search::find(self, hand, wanted, other(touch), &rise);
        let n_tries = first.n_tries + second.n_tries;
        let best = if second.cost < first.cost { second } else { first };
        Try { n_tries, ..best }
    }

    /// Returns the time from a quick release to the next strike at `speed` (m/s) at best (s).
    fn turn(&self, speed: f64) -> f64 {
        let (_, delay) = self.guess(Touch::Pressed, speed);
        self.tables.rise.unwrap_or(USUAL_RISE) + search::SHORTEST_WAY * delay
    }

    /// Returns the latest release (s) after which `next` should find the key high enough.
    fn latest_release(&self, next: &PlannedStroke) -> f64 {
        next.onset - SLACK * self.turn(next.speed)
    }

    /// Returns finger speed (m/s) and delay of the strike (s) for hammer `speed` (m/s) from rest.
    fn guess(&self, touch: Touch, speed: f64) -> (f64, f64) {
        let table = self.tables.of(touch);
        let command = table.command(speed);
        (command, table.delay(command))
    }
}

fn other(touch: Touch) -> Touch {
    match touch {
        Touch::Pressed => Touch::Struck,
        Touch::Struck => Touch::Pressed,
    }
}
