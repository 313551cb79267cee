//! Whether a key still follows its motor in the run.
//!
//! A key that stays down although its motor pushes it up hard is either held by a hand, or its
//! motor is reversed or dead. What tells them apart is a short dip of the force: a held key moves a
//! little down when the push becomes weaker, one whose motor is reversed moves up, and one whose
//! motor is dead does not move. A dip takes a quarter of the force away for 12 ms, and is made at
//! most once in ten seconds for a key that passes.

use super::super::key_fault::KeyFault;

/// A hard push (N), and how long a key must have stayed in spite of it (s).
const HARD: f64 = 6.0;
const STAYED: f64 = 0.03;

/// How little a key has moved that stayed (m).
const HARDLY: f64 = 0.3e-3;

/// The dip: part of the force that remains, and its length (s).
const DIP: f64 = 0.75;
const LENGTH: f64 = 0.012;

/// When a motor that has passed is looked at again (s).
const AGAIN: f64 = 10.0;

/// How much the wanted force may change during a dip that counts.
const STEADY: f64 = 0.25;

/// Motion (m) that a dip shows at least.
const LEAST_MOTION: f64 = 3e-6;

/// Dips that must agree.
const CONFIRMATIONS: u8 = 2;

/// What is going on with one key.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Stage {
    /// It has been pushed hard at `place` (m) for so long (s).
    Watching { place: f64, pushed: f64 },
    /// A dip of `wanted` (N) has begun so long ago (s) with the key at `place` (m).
    Dipping { place: f64, wanted: f64, since: f64 },
}

/// The look at one key's motor.
#[derive(Clone, Copy, Debug)]
pub(super) struct MotorResponse {
    stage: Stage,
    /// Time until it is looked at again (s).
    rest: f64,
    /// Dips in which it moved the wrong way, and in which it did not move.
    n_wrong: u8,
    n_still: u8,
}

impl Default for MotorResponse {
    fn default() -> Self {
        let stage = Stage::Watching { place: 0.0, pushed: 0.0 };
        Self { stage, rest: 0.0, n_wrong: 0, n_still: 0 }
    }
}

impl MotorResponse {
    /// Continues with the key at `position` (m), whose count is `quantum`, `elapsed` (s) after the
    /// last call; returns the part of `wanted` (N, up positive) to send, and what is found.
    ///
    /// # Real-time
    /// Some ten operations.
    pub(super) fn step(
        &mut self,
        (position, quantum): (f64, f64),
        elapsed: f64,
        wanted: f64,
    ) -> (f64, Option<KeyFault>) {
        self.rest = (self.rest - elapsed).max(0.0);
        match self.stage {
            Stage::Watching { .. } if wanted < HARD || 0.0 < self.rest => {
                self.stage = Stage::Watching { place: position, pushed: 0.0 };
                (1.0, None)
            }
            Stage::Watching { place, pushed } => {
                let has_yielded = HARDLY < place - position;
                self.stage = match pushed + elapsed {
                    _ if has_yielded => Stage::Watching { place: position, pushed: 0.0 },
                    pushed if pushed < STAYED => Stage::Watching { place, pushed },
                    _ => Stage::Dipping { place: position, wanted, since: 0.0 },
                };
                (1.0, None)
            }
            Stage::Dipping { wanted: before, .. } if STEADY * before < (wanted - before).abs() => {
                // A hand that moves explains everything.
                self.watch(position);
                (1.0, None)
            }
            Stage::Dipping { place, wanted: before, since } if since + elapsed < LENGTH => {
                self.stage = Stage::Dipping { place, wanted: before, since: since + elapsed };
                (DIP, None)
            }
            Stage::Dipping { place, .. } => {
                self.watch(position);
                (1.0, self.judge(position - place, LEAST_MOTION + 2.0 * quantum))
            }
        }
    }

    const fn watch(&mut self, position: f64) {
        self.stage = Stage::Watching { place: position, pushed: STAYED };
    }

    /// Judges a dip in which the key moved by `way` (m, down positive); less than `least` is none.
    fn judge(&mut self, way: f64, least: f64) -> Option<KeyFault> {
        if least <= way {
            (self.n_wrong, self.n_still, self.rest) = (0, 0, AGAIN);
        } else if way <= -least {
            (self.n_wrong, self.n_still) = (self.n_wrong + 1, 0);
        } else {
            (self.n_wrong, self.n_still) = (0, self.n_still + 1);
        }
        if CONFIRMATIONS <= self.n_wrong {
            Some(KeyFault::Reversed)
        } else if CONFIRMATIONS <= self.n_still {
            Some(KeyFault::Unresponsive)
        } else {
            None
        }
    }
}
