//! What stands between one key's model and its motor: nothing is believed twice.
//!
//! | file | what it looks at |
//! |---|---|
//! | [`trend`] | readings that no key can have made |
//! | [`proof`] | whether the motor moves its key, before a model uses it |
//! | [`response`] | the same while it is played |
//! | [`shake`] | forces that go to and fro |
//! | [`place`] | where it stands still |
//! | [`force_path`] | how fast forces change, and how they continue after a gap |
//!
//! Only keys on boards have a guard; simulated keys of the same process need none.

mod force_path;
mod place;
mod proof;
mod response;
mod shake;
mod trend;

use super::key_fault::KeyFault;
use crate::calibration::KeyCalibration;
use force_path::ForcePath;
use place::PlaceWatch;
use proof::MotorProof;
use response::MotorResponse;
use shake::ShakeWatch;
use trend::{KeyTrend, TrendVerdict};

/// Share of its force that a key keeps after it has shaken once.
const SOFT: f64 = 0.5;

/// The guard of one key.
#[derive(Clone, Copy, Debug)]
pub(super) struct KeyGuard {
    trend: KeyTrend,
    proof: MotorProof,
    response: MotorResponse,
    shake: ShakeWatch,
    path: ForcePath,
    place: PlaceWatch,
    fault: Option<KeyFault>,
    is_softened: bool,
    glitches: u64,
}

impl Default for KeyGuard {
    fn default() -> Self {
        Self {
            trend: KeyTrend::default(),
            proof: MotorProof::PROVEN,
            response: MotorResponse::default(),
            shake: ShakeWatch::default(),
            path: ForcePath::default(),
            place: PlaceWatch::default(),
            fault: None,
            is_softened: false,
            glitches: 0,
        }
    }
}

impl KeyGuard {
    /// Demands a proof of the motor before the next force of a model.
    pub(super) const fn demand_proof(&mut self) {
        self.proof = MotorProof::begin();
        self.path.restart();
    }

    /// Forgets what was found, for a board that has started again.
    pub(super) fn unmute(&mut self) {
        *self = Self { glitches: self.glitches, ..Self::default() };
        self.demand_proof();
    }

    /// Takes a reading at `position` (m), `elapsed` (s) after the one before if it follows on that;
    /// returns whether it may be used.
    pub(super) fn accept(
        &mut self,
        position: f64,
        elapsed: Option<f64>,
        calibration: &KeyCalibration,
    ) -> bool {
        let key = (calibration.quantum.abs(), calibration.travel());
        match self.trend.accept(position, elapsed, key) {
            TrendVerdict::Follows => true,
            TrendVerdict::Leaves => false,
            TrendVerdict::Returns => {
                self.glitches += 1;
                true
            }
            TrendVerdict::Slipped => {
                self.mute(KeyFault::Slipped);
                false
            }
        }
    }

    /// Returns the force to send (N, up positive) where the model wants `wanted` for a key that was
    /// read at `position` (m), `elapsed` (s) after the last one; at most the share `most` of it.
    ///
    /// # Real-time
    /// Some fifty operations.
    pub(super) fn force(
        &mut self,
        wanted: f64,
        most: f64,
        (position, elapsed): (f64, f64),
        calibration: &KeyCalibration,
    ) -> f64 {
        self.place.take(position, elapsed);
        if self.fault.is_some() || !self.proof.is_proven() {
            return self.unplayed(wanted, most, position, elapsed);
        }
        let question = self.ask((position, elapsed), most, wanted, calibration);
        let soft = if self.is_softened { SOFT } else { 1.0 };
        let force = self.path.next(wanted + question / soft, soft * most, elapsed);
        if self.shake.is_shaking(force, elapsed, soft) {
            if self.is_softened {
                self.mute(KeyFault::Shaking);
            }
            self.is_softened = true;
        }
        force
    }

    /// Returns what to add to `wanted` (N) to learn whether the motor still moves its key.
    fn ask(
        &mut self,
        (position, elapsed): (f64, f64),
        most: f64,
        wanted: f64,
        calibration: &KeyCalibration,
    ) -> f64 {
        if most < 1.0 {
            self.response.pause();
            return 0.0;
        }
        let place = (position, calibration.quantum.abs());
        let (question, found) = self.response.step(place, elapsed, wanted);
        if let Some(fault) = found {
            self.mute(fault);
        }
        question
    }

    /// The force on a key that is not played: that of its proof, or what fades.
    fn unplayed(&mut self, wanted: f64, most: f64, position: f64, elapsed: f64) -> f64 {
        if self.fault.is_some() || most <= 0.0 {
            return self.path.next(wanted, 0.0, elapsed);
        }
        let push = self.proof.step(position, elapsed, wanted);
        if self.proof.is_proven() {
            self.path.restart();
        }
        if let Some(fault) = self.proof.fault() {
            self.mute(fault);
        }
        push
    }

    /// Lets the next force continue from the last one, since there was a gap between them.
    pub(super) fn lead_over(&mut self, wanted: f64) {
        if self.proof.is_proven() {
            self.path.lead_over(wanted);
        }
    }

    /// Plays the key no more, for the first fault that is found.
    pub(super) fn mute(&mut self, fault: KeyFault) {
        self.fault.get_or_insert(fault);
    }

    /// Tells whether the force is what the model wants, so that slopes may go with it.
    pub(super) fn is_whole(&self) -> bool {
        self.fault.is_none() && self.proof.is_proven() && self.path.is_whole()
    }

    /// Returns what the key was muted for.
    pub(super) const fn fault(&self) -> Option<KeyFault> {
        self.fault
    }

    /// Tells whether the proof of its motor is neither passed nor failed.
    pub(super) fn is_unproven(&self) -> bool {
        self.fault.is_none() && !self.proof.is_proven()
    }

    /// Tells whether the proof waits for the key to rest.
    pub(super) fn waits_for_rest(&self) -> bool {
        self.is_unproven() && self.proof.is_waiting()
    }

    /// Tells whether its force is halved since it shook.
    pub(super) const fn is_softened(&self) -> bool {
        self.is_softened
    }

    /// Tells whether a key that goes down by `travel` (m) stands still away from its ends.
    pub(super) fn is_misplaced(&self, travel: f64) -> bool {
        self.fault.is_none() && self.place.is_misplaced(travel)
    }

    /// Returns readings left out, ticks with a limited rise, and gaps that were led over.
    pub(super) const fn counts(&self) -> [u64; 3] {
        [self.glitches, self.path.limited, self.path.blended]
    }
}
