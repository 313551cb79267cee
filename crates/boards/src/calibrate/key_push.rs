//! A push that changes slowly, and only while the key stands still.

use super::{CalibrationFault, TRAVELS};

/// Within so much a key stands still, if its sensor is quiet (m).
const STILL: f64 = 30e-6;
/// A key that stood still so long is pushed on (s).
const PATIENCE: f64 = 20e-3;
/// Longest time for which the push is changed at once: a pause of the host is no step (s).
const LONGEST_STEP: f64 = 5e-3;
/// So far above its rest a key can be (m).
const ABOVE: f64 = 2e-3;
/// So far a reading can go at once (m).
const JUMP: f64 = 5e-3;
/// Time without a position in which a key can go as far as a jump (s): at 1.7 m/s.
const PAUSE: f64 = 3e-3;
/// The longest time that one key may take (s).
const LONGEST: f64 = 60.0;

/// A push, and what the key does under it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct KeyPush {
    /// Push on the key, down positive (N).
    push: f64,
    /// Rest of the key (m).
    rest: f64,
    /// Within so much it stands still (m).
    still: f64,
    /// Time of the first position (s).
    began: Option<f64>,
    /// Time of the last look, and of the one before (s).
    times: (f64, f64),
    /// Where it is (m).
    position: f64,
    /// Where it stands still, and since when (m, s).
    stand: (f64, f64),
}

impl KeyPush {
    /// Starts without a push, on a key with this rest and spread of readings (m).
    pub(super) const fn new(rest: f64, spread: f64) -> Self {
        Self {
            push: 0.0,
            rest,
            still: STILL + 2.0 * spread,
            began: None,
            times: (0.0, 0.0),
            position: rest,
            stand: (rest, 0.0),
        }
    }

    /// Takes where the key is at `t` (s, m).
    pub(super) fn update(&mut self, t: f64, position: f64) -> Result<(), CalibrationFault> {
        let began = *self.began.get_or_insert_with(|| {
            (self.position, self.times, self.stand) = (position, (t, t), (position, t));
            t
        });
        let (depth, (_, most)) = (position - self.rest, TRAVELS);
        if depth.is_nan() || most < depth {
            return Err(CalibrationFault::RunsAway { position: depth, most });
        }
        if depth < -ABOVE {
            return Err(CalibrationFault::Backwards { position: depth });
        }
        let by = (position - self.position).abs();
        if JUMP < by {
            // After a pause of the host or the board, the key may have moved there.
            let is_pause = PAUSE < t - self.times.0;
            return Err(if is_pause {
                CalibrationFault::Interrupted
            } else {
                CalibrationFault::Jumps { by }
            });
        }
        if LONGEST < t - began {
            return Err(CalibrationFault::Restless { seconds: LONGEST });
        }
        self.times = (t, self.times.0);
        self.position = position;
        if self.still < (position - self.stand.0).abs() {
            self.stand = (position, t);
        }
        Ok(())
    }

    /// Changes the push towards `limit` by `rate` (N/s), if the key stands still.
    pub(super) fn press(&mut self, limit: f64, rate: f64) {
        if PATIENCE <= self.still_for() {
            let step = rate * (self.times.0 - self.times.1).clamp(0.0, LONGEST_STEP);
            self.push += (limit - self.push).clamp(-step, step);
        }
    }

    /// Returns for how long the key has stood still (s).
    pub(super) fn still_for(&self) -> f64 {
        self.times.0 - self.stand.1
    }

    /// Returns how far below its rest the key is (m).
    pub(super) fn depth(&self) -> f64 {
        self.position - self.rest
    }

    /// Returns where the key is (m).
    pub(super) const fn position(&self) -> f64 {
        self.position
    }

    /// Returns the push (N, down positive).
    pub(super) const fn push(&self) -> f64 {
        self.push
    }
}
