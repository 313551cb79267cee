//! Which gesture gives this hammer speed at this time: found by simulation.
//!
//! One key, stroke after stroke, each from the state that the strokes before it leave behind:
//!
//! 1. advance a little before the stroke must begin;
//! 2. guess speed and start from the [`StrokeTable`] of the key at rest;
//! 3. try on a copy of the key, and correct both, until strike and onset are as wanted;
//! 4. if the touch does not serve, try the other one;
//! 5. if the key is not up yet, strike from where it is, let the stroke before go earlier and more
//!    quickly, and try again;
//! 6. if it cannot be in time even so, leave it out, and give the stroke before its length back;
//! 7. choose the release so that the damper falls where it should and the next stroke has room;
//! 8. keep it and go on.
//!
//! Nothing depends on anything but the arguments: the same strokes give the same bits.

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

/// How much longer than at best it may take to strike again, for choosing a release.
const SLACK: f64 = 1.15;

/// After a release, a key is at rest by this time (s): no earlier release would help.
const SETTLED: f64 = 0.6;

/// Guess for a key that was not seen to rise: from a quick release until it can be struck again (s).
const USUAL_RISE: f64 = 35e-3;

/// A key with its action that can be tried out; a copy of it is a snapshot.
///
/// A new one is at rest, and its time is 0.
pub trait Rehearsal: Clone {
    /// Plays on from the key's present time until `until` (s).
    ///
    /// `gestures`, in order of start, are all that matter from the present time on: the one
    /// that may still be under way, and those that begin later.
    /// What a gesture does before its release does not depend on when that is.
    fn play(&mut self, gestures: &[Gesture], until: f64) -> PlayOutcome;

    /// Returns how deep the key's front is now (m), down positive.
    fn depth(&self) -> f64;
}

/// What happened while a key was played.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct PlayOutcome {
    /// Every strike, in order of time.
    pub strikes: Vec<Strike>,
    /// When the damper fell the last time (s), if it did.
    pub damper_fall: Option<f64>,
}

/// The hammer meets the string.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Strike {
    /// Time of the strike (s).
    pub at: f64,
    /// Speed of the hammer at the string (m/s).
    pub speed: f64,
}

/// A stroke with the gesture that plays it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RehearsedStroke {
    pub wanted: PlannedStroke,
    /// What the finger does; none where the stroke is left out.
    pub gesture: Option<Gesture>,
    /// Why it is not played as it is written; none where it is.
    pub shortfall: Option<Shortfall>,
    /// The strike that it gives, unless it gives none.
    pub strike: Option<Strike>,
    /// How many strikes it gives; more than one is a bouncing hammer.
    pub n_strikes: usize,
    /// When its damper falls (s), if that was seen.
    pub damper_fall: Option<f64>,
    /// Simulations that it took.
    pub n_tries: u32,
}

impl RehearsedStroke {
    /// A stroke that is not played, for want of what `shortfall` says.
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

/// What a rehearsal goes by.
#[derive(Clone, Copy, Debug)]
pub struct Practice<'a> {
    /// First guesses for this key.
    pub tables: &'a StrokeTables,
    /// What a hammer speed is worth.
    pub curve: VelocityCurve,
    /// How the pianist plays.
    pub technique: &'a Technique,
}

impl Practice<'_> {
    /// Finds gestures for `strokes`, all of one key and in order of onset, on `instrument`.
    ///
    /// `progress` is called after every stroke.
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

    /// Time from a quick release to the next strike at `speed` (m/s) from as deep as can be (s).
    fn turn(&self, speed: f64) -> f64 {
        let (_, delay) = self.guess(Touch::Pressed, speed);
        self.tables.rise.unwrap_or(USUAL_RISE) + search::SHORTEST_WAY * delay
    }

    /// When the key must be released (s) so that `next` finds it high enough, if all goes well.
    fn latest_release(&self, next: &PlannedStroke) -> f64 {
        next.onset - SLACK * self.turn(next.speed)
    }

    /// Finger speed (m/s) that gives hammer `speed` (m/s) from rest, and the delay of its strike (s).
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
