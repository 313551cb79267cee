//! Down to the bottom and up again.

use super::key_push::KeyPush;
use super::{CalibrationFault, MOST_PUSH, Next, Rested, TRAVELS};

/// How fast the push changes (N/s).
pub(super) const RATE: f64 = 0.3;
/// The same where no key breaks away (N/s).
pub(super) const FAST: f64 = 2.0;
/// A key that has gone so far from an end has broken away, and is off the felt (m).
pub(super) const AWAY: f64 = 1.5e-3;
/// Within so much a key is back (m).
pub(super) const BACK: f64 = 0.4e-3;
/// So much more than what moved it last does not move a key at its end (N).
const REACH: f64 = 0.3;
/// How long the bottom is looked at (s).
const LOOK: f64 = 0.1;

/// What a key does.
#[derive(Clone, Copy, PartialEq, Debug)]
enum TripPhase {
    /// It has not left its rest.
    Leaving,
    /// It goes down; the last push that moved it (N).
    Sinking {
        moved_at: f64,
    },
    /// It lies at the bottom; since when (s), the sum of positions (m) and their number.
    Lying {
        since: f64,
        sum: f64,
        n: u32,
    },
    /// The push goes over to the other side.
    Lifting {
        bottom: f64,
    },
    Rising {
        bottom: f64,
        lifted_by: f64,
    },
}

/// The trip of one key.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct TripMeasurement {
    key: KeyPush,
    phase: TripPhase,
    /// The push under which it left its rest (N).
    left_by: f64,
}

/// What a trip tells.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Travelled {
    /// Where the bottom is (m).
    pub bottom: f64,
    /// Half the difference of the pushes under which it left its ends (N).
    pub friction: f64,
    /// Their mean: under this push it floats (N, down positive).
    pub float: f64,
}

impl TripMeasurement {
    /// Returns the trip of a key that rests there.
    pub const fn new(rested: &Rested) -> Self {
        let key = KeyPush::new(rested.position, rested.spread);
        Self { key, phase: TripPhase::Leaving, left_by: 0.0 }
    }

    /// Takes where the key is at `t` (s, m); says how to push it.
    ///
    /// # Errors
    /// It does not move, does not stop, or does not come back.
    pub fn advance(&mut self, t: f64, position: f64) -> Result<Next<Travelled>, CalibrationFault> {
        self.key.update(t, position)?;
        match self.phase {
            TripPhase::Leaving => self.leave()?,
            TripPhase::Sinking { moved_at } => self.sink(t, moved_at)?,
            TripPhase::Lying { since, sum, n } => self.lie(t, since, sum + position, n + 1),
            TripPhase::Lifting { bottom } => self.lift(bottom)?,
            TripPhase::Rising { bottom, lifted_by } => {
                if let Some(done) = self.rise(bottom, lifted_by)? {
                    return Ok(Next::Done(done));
                }
            }
        }
        Ok(Next::Push(self.key.push()))
    }

    fn leave(&mut self) -> Result<(), CalibrationFault> {
        self.key.press(MOST_PUSH, RATE);
        let push = self.key.push();
        if AWAY < self.key.depth() {
            self.left_by = push;
            self.phase = TripPhase::Sinking { moved_at: push };
        } else if MOST_PUSH <= push && LOOK < self.key.still_for() {
            return Err(CalibrationFault::Stuck { push });
        }
        Ok(())
    }

    fn sink(&mut self, t: f64, moved_at: f64) -> Result<(), CalibrationFault> {
        self.key.press(MOST_PUSH, RATE);
        let push = self.key.push();
        let is_still = LOOK < self.key.still_for();
        let moved_at = if is_still { moved_at } else { push };
        self.phase = TripPhase::Sinking { moved_at };
        if is_still && (moved_at + REACH <= push || MOST_PUSH <= push) {
            let (travel, (least, _)) = (self.key.depth(), TRAVELS);
            if travel < least {
                return Err(CalibrationFault::Short { travel, least });
            }
            self.phase = TripPhase::Lying { since: t, sum: 0.0, n: 0 };
        }
        Ok(())
    }

    fn lie(&mut self, t: f64, since: f64, sum: f64, n: u32) {
        self.phase = if since + LOOK <= t {
            TripPhase::Lifting { bottom: sum / f64::from(n) }
        } else {
            TripPhase::Lying { since, sum, n }
        };
    }

    fn lift(&mut self, bottom: f64) -> Result<(), CalibrationFault> {
        // No key rises by itself under the push under which it sank.
        let is_safe = self.left_by < self.key.push();
        let (limit, rate) = if is_safe { (self.left_by, FAST) } else { (-MOST_PUSH, RATE) };
        self.key.press(limit, rate);
        let push = self.key.push();
        if self.key.position() < bottom - AWAY {
            self.phase = TripPhase::Rising { bottom, lifted_by: push };
        } else if push <= -MOST_PUSH && LOOK < self.key.still_for() {
            return Err(CalibrationFault::Stays { position: self.key.depth(), push: MOST_PUSH });
        }
        Ok(())
    }

    fn rise(&mut self, bottom: f64, lifted_by: f64) -> Result<Option<Travelled>, CalibrationFault> {
        self.key.press(-MOST_PUSH, RATE);
        if self.key.depth() < BACK {
            let friction = 0.5 * (self.left_by - lifted_by);
            let float = 0.5 * (self.left_by + lifted_by);
            return Ok(Some(Travelled { bottom, friction, float }));
        }
        if self.key.push() <= -MOST_PUSH && LOOK < self.key.still_for() {
            return Err(CalibrationFault::Stays { position: self.key.depth(), push: MOST_PUSH });
        }
        Ok(None)
    }
}
