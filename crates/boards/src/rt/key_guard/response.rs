//! Whether a key that is held still follows its motor.
//!
//! A hand that holds a key explains any place, so its motor is asked: where a pressed key stands
//! still, the force grows by up to 1.5 N in 20 ms, until the key has moved. A key that moves up, be it
//! by some micrometres into its felt, follows its motor, and is left in peace for five seconds. One
//! that moves down each time has a motor whose wires are exchanged. One that does not move any more
//! has a dead motor, or an amplifier that pushes by itself: that counts only for a key that moved
//! before, since an encoder may be too coarse to see it.

use super::super::key_fault::KeyFault;

/// How still a key stands (m), for how long (s), and how deep it is pressed (m).
const STILLNESS: f64 = 20e-6;
const STILL: f64 = 0.05;
const PRESSED: f64 = 0.4e-3;

/// How fast the question grows (N/s), how far (N), and how long it lasts (s).
const GROWTH: f64 = 75.0;
const MOST: f64 = 1.5;
const LENGTH: f64 = 0.03;

/// How much the wanted force may change meanwhile (N): a hand that moves explains everything.
const STEADY: f64 = 1.0;

/// Motion that an answer shows at least (m), beside two counts and the tremor before.
const LEAST_MOTION: f64 = 3e-6;

/// When a motor that has answered is asked again, and one of which nothing was learned (s).
const AGAIN: f64 = 5.0;
const SOON: f64 = 0.2;

/// Answers that must agree.
const CONFIRMATIONS: u8 = 3;

#[derive(Clone, Copy, PartialEq, Debug)]
enum ResponseStage {
    /// The key has stood at `place` (m), but for a `tremor` (m), for so long (s).
    Watching { place: f64, tremor: f64, still: f64 },
    /// It is asked since so long (s), where the model wanted `wanted` (N) at `place` (m), and shows
    /// an answer by moving `least` (m).
    Asking { place: f64, least: f64, wanted: f64, since: f64 },
}

/// The look at one key's motor.
#[derive(Clone, Copy, Debug)]
pub(super) struct MotorResponse {
    stage: ResponseStage,
    /// Time until it is asked again (s).
    rest: f64,
    /// The key has moved up once when it was asked.
    has_answered: bool,
    /// Times that it moved down, and that it did not move.
    n_wrong: u8,
    n_still: u8,
}

impl Default for MotorResponse {
    fn default() -> Self {
        let stage = ResponseStage::Watching { place: f64::INFINITY, tremor: 0.0, still: 0.0 };
        Self { stage, rest: 0.0, has_answered: false, n_wrong: 0, n_still: 0 }
    }
}

impl MotorResponse {
    /// Continues with the key at `position` (m), whose count is `quantum`, `elapsed` (s) after the
    /// last call; returns what to add to `wanted` (N, up positive), and what is found.
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
            ResponseStage::Watching { place, tremor, still } => {
                self.watch((position, quantum), (place, tremor, still + elapsed), wanted);
                (0.0, None)
            }
            ResponseStage::Asking { wanted: before, .. } if STEADY < (wanted - before).abs() => {
                self.stage = ResponseStage::Watching { place: position, tremor: 0.0, still: 0.0 };
                (0.0, None)
            }
            ResponseStage::Asking { place, least, wanted: before, since } => {
                let (way, since) = (position - place, since + elapsed);
                if least <= way.abs() || LENGTH < since {
                    self.stage =
                        ResponseStage::Watching { place: position, tremor: 0.0, still: 0.0 };
                    return (0.0, self.judge(way, least));
                }
                self.stage = ResponseStage::Asking { place, least, wanted: before, since };
                ((GROWTH * since).min(MOST), None)
            }
        }
    }

    /// Does not ask, since what is wanted is not rendered whole.
    pub(super) fn pause(&mut self) {
        self.stage = ResponseStage::Watching { place: f64::INFINITY, tremor: 0.0, still: 0.0 };
    }

    /// Looks whether the key, which has stood at a place for a while, may be asked.
    fn watch(
        &mut self,
        (position, quantum): (f64, f64),
        (place, tremor, still): (f64, f64, f64),
        wanted: f64,
    ) {
        let tremor = tremor.max((position - place).abs());
        self.stage = if STILLNESS < tremor || position < PRESSED {
            ResponseStage::Watching { place: position, tremor: 0.0, still: 0.0 }
        } else if STILL <= still && self.rest <= 0.0 {
            let least = LEAST_MOTION + 2.0 * quantum + tremor;
            ResponseStage::Asking { place: position, least, wanted, since: 0.0 }
        } else {
            ResponseStage::Watching { place, tremor, still }
        };
    }

    /// Judges a motion of `way` (m, down positive): one of `least` is an answer, less than a third of
    /// that is none, and between the two nothing is known.
    fn judge(&mut self, way: f64, least: f64) -> Option<KeyFault> {
        if way <= -least {
            (self.n_wrong, self.n_still, self.has_answered) = (0, 0, true);
            self.rest = AGAIN;
        } else if least <= way {
            (self.n_wrong, self.n_still) = (self.n_wrong + 1, 0);
        } else if self.has_answered && 3.0 * way.abs() < least {
            (self.n_wrong, self.n_still) = (0, self.n_still + 1);
        } else {
            (self.n_wrong, self.rest) = (0, SOON);
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
