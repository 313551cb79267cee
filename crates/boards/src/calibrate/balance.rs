//! Motor gain, measured by a weight that the motor balances.

use super::trip::{AWAY, BACK, RATE};
use super::{CalibrationFault, G, Next, Rested, Travelled, key_push::KeyPush};

/// Time at rest after which a key has reached its end (s).
const SETTLED: f64 = 0.2;
/// Possible motor gains (1).
const GAINS: (f64, f64) = (0.1, 10.0);

#[derive(Clone, Copy, PartialEq, Debug)]
enum BalancePhase {
    /// Sinking under the weight.
    Sinking,
    /// Not yet off its bottom (m).
    Lifting { bottom: f64 },
    /// Rising under the push that lifted it (N).
    Rising { lifted_by: f64 },
    /// Not yet off its rest.
    Lowering { lifted_by: f64 },
}

/// The measurement of one key that already carries the weight.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Balance {
    key: KeyPush,
    phase: BalancePhase,
    empty: Travelled,
    /// The weight's force (N).
    weight: f64,
    /// Largest push (N).
    most: f64,
}

impl Balance {
    /// Balances `mass` (kg) on a key with these measurements without it.
    pub fn new(rested: &Rested, empty: &Travelled, mass: f64) -> Self {
        let weight = mass * G;
        let key = KeyPush::new(rested.position, rested.spread);
        // A motor of half its strength, and friction.
        let most = 2.0 * weight + 0.5;
        Self { key, phase: BalancePhase::Sinking, empty: *empty, weight, most }
    }

    /// Processes the key's position at `t` (s, m); returns the next push or the gain (per newton).
    ///
    /// # Errors
    /// The key does not sink, rise, or sink again.
    pub fn advance(&mut self, t: f64, position: f64) -> Result<Next<f64>, CalibrationFault> {
        self.key.update(t, position)?;
        match self.phase {
            BalancePhase::Sinking => self.sink()?,
            BalancePhase::Lifting { bottom } => self.lift(bottom)?,
            BalancePhase::Rising { lifted_by } => self.rise(lifted_by)?,
            BalancePhase::Lowering { lifted_by } => {
                self.key.press(self.most, RATE);
                if AWAY < self.key.depth() {
                    return self.gain(lifted_by).map(Next::Done);
                }
                if self.most <= self.key.push() {
                    return Err(CalibrationFault::Stuck { push: self.most });
                }
            }
        }
        Ok(Next::Push(self.key.push()))
    }

    fn sink(&mut self) -> Result<(), CalibrationFault> {
        if SETTLED < self.key.still_for() {
            let travel = self.empty.bottom - self.key.position() + self.key.depth();
            if self.key.depth() < travel - AWAY {
                return Err(CalibrationFault::Floats { position: self.key.depth() });
            }
            self.phase = BalancePhase::Lifting { bottom: self.key.position() };
        }
        Ok(())
    }

    fn lift(&mut self, bottom: f64) -> Result<(), CalibrationFault> {
        self.key.press(-self.most, RATE);
        if self.key.position() < bottom - AWAY {
            self.phase = BalancePhase::Rising { lifted_by: self.key.push() };
        }
        self.refuse_stuck()
    }

    fn rise(&mut self, lifted_by: f64) -> Result<(), CalibrationFault> {
        self.key.press(-self.most, RATE);
        if self.key.depth() < BACK && SETTLED < self.key.still_for() {
            self.phase = BalancePhase::Lowering { lifted_by };
        }
        self.refuse_stuck()
    }

    fn refuse_stuck(&self) -> Result<(), CalibrationFault> {
        let push = self.key.push();
        if push <= -self.most && SETTLED < self.key.still_for() {
            return Err(CalibrationFault::Stays { position: self.key.depth(), push: self.most });
        }
        Ok(())
    }

    fn gain(&self, lifted_by: f64) -> Result<f64, CalibrationFault> {
        let float = 0.5 * (lifted_by + self.key.push());
        let gain = (self.empty.float - float) / self.weight;
        let (least, most) = GAINS;
        if (least..=most).contains(&gain) {
            Ok(gain)
        } else {
            Err(CalibrationFault::Gain { gain, least, most })
        }
    }
}
