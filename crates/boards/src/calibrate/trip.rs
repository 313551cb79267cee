//! The trip of a key down to the bottom and up again.

use super::{CalibrationFault, MOST_PUSH, Next, Rested, TRAVELS, key_push::KeyPush};

/// Rate of the push (N/s).
pub(super) const RATE: f64 = 0.3;
/// Rate where no key breaks away (N/s).
pub(super) const FAST: f64 = 2.0;
/// Distance from an end at which a key has broken away, and is off the felt (m).
pub(super) const AWAY: f64 = 1.5e-3;
/// Distance within which a key is back (m).
pub(super) const BACK: f64 = 0.4e-3;
/// Additional push that does not move a key at its end (N).
const REACH: f64 = 0.3;
/// Length of the observation at the bottom (s).
const LOOK: f64 = 0.1;

#[derive(Clone, Copy, PartialEq, Debug)]
enum TripPhase {
    Leaving,
    /// Sinking under the last push that moved it (N).
    Sinking {
        moved_at: f64,
    },
    /// At the bottom: since when (s), sum of positions (m) and their number.
    Lying {
        since: f64,
        sum: f64,
        n: u32,
    },
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
    /// Push under which it left its rest (N).
    left_by: f64,
}

/// Result of a trip.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Travelled {
    /// Position of the bottom (m).
    pub bottom: f64,
    /// Half the difference of the pushes under which it left its ends (N).
    pub friction: f64,
    /// Mean of the two pushes, under which it floats (N, down positive).
    pub float: f64,
}

impl TripMeasurement {
    pub const fn new(rested: &Rested) -> Self {
        let key = KeyPush::new(rested.position, rested.spread);
        Self { key, phase: TripPhase::Leaving, left_by: 0.0 }
    }

    /// Processes the key's position at `t` (s, m); returns the next push or the result.
    ///
    /// # Errors
    /// The key does not move, does not stop, or does not come back.
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
