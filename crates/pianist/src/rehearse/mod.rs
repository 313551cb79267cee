//! Search by simulation for the gesture that gives a hammer speed at a time.
//!
//! One key, stroke after stroke, each from the state that the strokes before it leave:
//!
//! 1. guess speed and start from the [`StrokeTable`] of the key at rest;
//! 2. try on a copy of the key, and correct both, until speed and onset are as wanted;
//! 3. if the touch does not suffice, try the other one;
//! 4. if the key is not up yet, strike from its depth;
//! 5. if that is not good enough, release the previous stroke earlier: by as little as serves, and
//!    only if the stroke gains more than the note before it loses, by the price list of `price`;
//! 6. if a missing note is better than the best try, leave the stroke out;
//! 7. choose the release so that the damper falls when it should, and as fast;
//! 8. continue from that try, which needs no repetition.
//!
//! The result depends on the arguments alone: the same strokes give the same bits.

mod price;
mod release;
mod search;
mod shortfall;
mod strokes;
mod table;
mod take;

use haptics::plant::{Gesture, Touch};
use midi::VelocityCurve;

use crate::stroke::{PlannedStroke, Technique};
use price::ACCEPTABLE;
pub use price::MISSING;
use search::Try;
pub use shortfall::Shortfall;
use strokes::KeyStrokes;
use table::TablePoint;
pub(crate) use table::{LIFTS, QUICK_LIFT};
pub use table::{LiftTable, StrokeTable, StrokeTables, tabulate};
use take::Take;

/// Time after a release by which a key is at rest (s): no earlier release would help.
const SETTLED: f64 = 0.6;

/// A key with its action for trials, at rest at time 0 when new; a copy is a snapshot.
pub trait Rehearsal: Clone {
    /// Plays until `until` (s). `gestures`, in order of start, are all that matter from now on. The
    /// motion before a release does not depend on the time of the release.
    fn play(&mut self, gestures: &[Gesture], until: f64) -> PlayOutcome;

    /// Returns the depth of the key's front (m), down positive.
    fn depth(&self) -> f64;

    /// Returns the length of a tick (s): [`Self::play`] may end that much later.
    fn period(&self) -> f64;
}

/// Events while a key was played.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct PlayOutcome {
    pub strikes: Vec<Strike>,
    /// Latest fall of the damper, if it fell.
    pub damper_fall: Option<DamperFall>,
}

/// The end of a tone: the damper meets its string, as the key rises at a speed (m/s).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct DamperFall {
    pub at: f64,
    pub speed: f64,
}

/// A meeting of hammer and string: time (s), and hammer speed (m/s).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Strike {
    pub at: f64,
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
    pub damper_fall: Option<DamperFall>,
    /// Time by which the note is shortened for the next stroke (s), 0 if it is not.
    pub cut: f64,
    pub n_tries: u32,
}

impl RehearsedStroke {
    const fn left_out(wanted: &PlannedStroke, shortfall: Shortfall, n_tries: u32) -> Self {
        Self { shortfall: Some(shortfall), n_tries, ..Self::new(wanted) }
    }

    const fn new(wanted: &PlannedStroke) -> Self {
        Self {
            wanted: *wanted,
            gesture: None,
            shortfall: None,
            strike: None,
            n_strikes: 0,
            damper_fall: None,
            cut: 0.0,
            n_tries: 0,
        }
    }
}

/// Inputs of a rehearsal.
#[derive(Clone, Debug)]
pub struct Practice<'a> {
    /// First guesses for this key, which grow by what is learnt.
    pub tables: StrokeTables,
    pub curve: VelocityCurve,
    pub technique: &'a Technique,
}

impl Practice<'_> {
    /// Finds gestures for `strokes`, of one key in order of onset; calls `progress` after each.
    pub fn rehearse<R: Rehearsal>(
        self,
        instrument: R,
        strokes: &[PlannedStroke],
        progress: impl FnMut(),
    ) -> Vec<RehearsedStroke> {
        KeyStrokes::new(self, instrument, strokes).rehearse(progress)
    }

    /// Returns finger speed (m/s) and delay of the strike (s) for `wanted` from rest.
    fn guess(&self, touch: Touch, wanted: &PlannedStroke) -> (f64, f64) {
        let table = self.tables.of(touch);
        let command = table.command(self.reach(wanted.speed));
        (command, table.delay(command))
    }

    /// Adds `tried` to the tables if `take` was at rest when its finger began.
    fn learn<R: Rehearsal>(&mut self, take: &Take<R>, tried: &Try<R>) {
        let Some(strike) = tried.strike.filter(|_| tried.n_extra == 0) else { return };
        let Gesture { start, speed: command, touch, .. } = tried.gesture;
        if take.is_still(start) {
            let point = TablePoint { command, hammer: strike.speed, delay: strike.at - start };
            self.tables.of_mut(touch).learn(point);
        }
    }
}
