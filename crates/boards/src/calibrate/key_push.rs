//! A push that changes slowly, and only while the key is at rest.

use super::{CalibrationFault, TRAVELS};

/// Range of positions of a key at rest with a quiet sensor (m).
const STILL: f64 = 30e-6;
/// Time at rest after which a key is pushed further (s).
const PATIENCE: f64 = 20e-3;
/// Longest time step of a change of the push: a pause of the host is no step (s).
const LONGEST_STEP: f64 = 5e-3;
/// Largest height of a key above its rest (m).
const ABOVE: f64 = 2e-3;
/// Largest jump of a reading (m).
const JUMP: f64 = 5e-3;
/// Time without a position in which a key can move by a jump (s): at 1.7 m/s.
const PAUSE: f64 = 3e-3;
/// Longest measurement of one key (s).
const LONGEST: f64 = 60.0;

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct KeyPush {
    /// Push on the key, down positive (N).
    push: f64,
    /// Position of the key without a push (m).
    rest: f64,
    /// Range of positions at rest (m).
    still: f64,
    /// Time of the first position (s).
    began: Option<f64>,
    /// Times of the last two positions (s).
    times: (f64, f64),
    /// Last position (m).
    position: f64,
    /// Position at rest and start of the rest (m, s).
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

    /// Changes the push towards `limit` by `rate` (N/s), if the key is at rest.
    pub(super) fn press(&mut self, limit: f64, rate: f64) {
        if PATIENCE <= self.still_for() {
            let step = rate * (self.times.0 - self.times.1).clamp(0.0, LONGEST_STEP);
            self.push += (limit - self.push).clamp(-step, step);
        }
    }

    /// Returns the time for which the key has been at rest (s).
    pub(super) fn still_for(&self) -> f64 {
        self.times.0 - self.stand.1
    }

    pub(super) fn depth(&self) -> f64 {
        self.position - self.rest
    }

    pub(super) const fn position(&self) -> f64 {
        self.position
    }

    pub(super) const fn push(&self) -> f64 {
        self.push
    }
}
