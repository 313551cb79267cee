//! Checks if a held key still follows its motor.
//!
//! A hand that holds a key explains any position, so a test force checks its motor: on a pressed
//! key that stands still, the force grows by up to 1.5 N in 20 ms, until the key has moved. A key
//! that moves up, even by some micrometres into its felt, passes and is not tested for 5 s. One
//! that moves down each time has a motor with swapped wires. One that no longer moves has a dead
//! motor, or an amplifier that pushes by itself: that counts only for a key that moved before,
//! since an encoder may be too coarse to show it.

use super::super::key_fault::KeyFault;

/// Tremor (m) and duration (s) of standing still, and minimum depth of a pressed key (m).
const STILLNESS: f64 = 20e-6;
const STILL: f64 = 0.05;
const PRESSED: f64 = 0.4e-3;

/// Growth (N/s), limit (N) and duration (s) of the test force.
const GROWTH: f64 = 75.0;
const MOST: f64 = 1.5;
const LENGTH: f64 = 0.03;

/// Largest change of the wanted force meanwhile (N), since a moving hand explains any motion.
const STEADY: f64 = 1.0;

/// Minimum motion of a response (m), beside two counts and the earlier tremor.
const LEAST_MOTION: f64 = 3e-6;

/// Pauses after a response and after an unclear test (s).
const AGAIN: f64 = 5.0;
const SOON: f64 = 0.2;

/// Number of agreeing tests.
const CONFIRMATIONS: u8 = 3;

#[derive(Clone, Copy, PartialEq, Debug)]
enum ResponseStage {
    /// The key has been at `place` (m), within `tremor` (m), for so long (s).
    Watching { place: f64, tremor: f64, still: f64 },
    /// It is tested since so long (s) with the model's `wanted` (N) at `place` (m); a motion by
    /// `least` (m) is a response.
    Asking { place: f64, least: f64, wanted: f64, since: f64 },
}

#[derive(Clone, Copy, Debug)]
pub(super) struct MotorResponse {
    stage: ResponseStage,
    /// Time until the next test (s).
    rest: f64,
    /// `true` if the key has moved up once in a test.
    has_answered: bool,
    /// Tests with a downward motion, and without a motion.
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
    /// Continues with the key at `position` (m) with a count of `quantum`, `elapsed` (s) after the
    /// last call; returns the force to add to `wanted` (N, up positive), and the finding.
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

    /// Skips the test, since the model's force is not rendered whole.
    pub(super) fn pause(&mut self) {
        self.stage = ResponseStage::Watching { place: f64::INFINITY, tremor: 0.0, still: 0.0 };
    }

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

    /// Judges a motion of `way` (m, down positive): from `least` a response, below a third none.
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
