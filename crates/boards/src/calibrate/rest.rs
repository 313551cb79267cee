//! Position of a key without a force.

use super::{CalibrationFault, Next};

/// Length of the measurement (s).
pub const TIME: f64 = 0.3;
/// Largest spread of the readings of an untouched key (m).
pub const MOST_SPREAD: f64 = 0.1e-3;
const FEWEST: u32 = 20;
/// Time after which the wait for samples ends (s).
const PATIENCE: f64 = 3.0;

/// The rest measurement of one key.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct RestMeasurement {
    began: Option<f64>,
    n: u32,
    sum: f64,
    /// Lowest and highest reading (m).
    range: Option<(f64, f64)>,
}

/// Rest of a key: mean of its positions, and highest less lowest position (m).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Rested {
    pub position: f64,
    pub spread: f64,
}

impl RestMeasurement {
    /// Processes the key's position at `t` (s, m); it must not be pushed.
    ///
    /// # Errors
    /// The readings spread too much, or there are too few.
    pub fn advance(&mut self, t: f64, position: f64) -> Result<Next<Rested>, CalibrationFault> {
        let passed = t - *self.began.get_or_insert(t);
        self.n += 1;
        self.sum += position;
        let (low, high) = self.range.unwrap_or((position, position));
        let (low, high) = (low.min(position), high.max(position));
        self.range = Some((low, high));
        let spread = high - low;
        if MOST_SPREAD < spread {
            return Err(CalibrationFault::Noisy { spread, most: MOST_SPREAD });
        }
        if TIME <= passed && FEWEST <= self.n {
            return Ok(Next::Done(Rested { position: self.sum / f64::from(self.n), spread }));
        }
        if PATIENCE < passed {
            return Err(CalibrationFault::Silent { seconds: PATIENCE });
        }
        Ok(Next::Push(0.0))
    }
}
