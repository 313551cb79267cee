//! Guards between one key's model and its motor; each check is independent of the others.
//!
//! | module | check |
//! |---|---|
//! | [`trend`] | readings that no key can have made |
//! | [`proof`] | response of the motor before a model uses it |
//! | [`response`] | response of the motor during play |
//! | [`shake`] | oscillating forces |
//! | [`place`] | position of a key that stands still |
//! | [`force_path`] | rate of change of forces, and their continuation after a gap |
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
    pub(super) const fn demand_proof(&mut self) {
        self.proof = MotorProof::begin();
        self.path.restart();
    }

    /// Forgets all findings, for a board that has restarted.
    pub(super) fn unmute(&mut self) {
        *self = Self { glitches: self.glitches, ..Self::default() };
        self.demand_proof();
    }

    /// Checks a reading at `position` (m), `elapsed` (s) after its predecessor; `true` if usable.
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

    /// Returns the force to send (N, up positive) for the model's `wanted` on a key at `position`
    /// (m), `elapsed` (s) after the last one, with at most the share `most`.
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

    /// Returns the test force to add to `wanted` (N) to check if the motor still moves its key.
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

    /// Returns the force on a key that is not played: that of its proof, or the fading one.
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

    pub(super) fn lead_over(&mut self, wanted: f64) {
        if self.proof.is_proven() {
            self.path.lead_over(wanted);
        }
    }

    /// Mutes the key; the first fault counts.
    pub(super) fn mute(&mut self, fault: KeyFault) {
        self.fault.get_or_insert(fault);
    }

    /// Returns `true` if the force is the model's, so that slopes may accompany it.
    pub(super) fn is_whole(&self) -> bool {
        self.fault.is_none() && self.proof.is_proven() && self.path.is_whole()
    }

    pub(super) const fn fault(&self) -> Option<KeyFault> {
        self.fault
    }

    /// Returns `true` if the proof of its motor is neither passed nor failed.
    pub(super) fn is_unproven(&self) -> bool {
        self.fault.is_none() && !self.proof.is_proven()
    }

    pub(super) fn waits_for_rest(&self) -> bool {
        self.is_unproven() && self.proof.is_waiting()
    }

    pub(super) const fn is_softened(&self) -> bool {
        self.is_softened
    }

    /// Returns `true` if a key with this `travel` (m) stands still away from its ends.
    pub(super) fn is_misplaced(&self, travel: f64) -> bool {
        self.fault.is_none() && self.place.is_misplaced(travel)
    }

    /// Returns discarded readings, ticks with a limited rise, and blended gaps.
    pub(super) const fn counts(&self) -> [u64; 3] {
        [self.glitches, self.path.limited, self.path.blended]
    }
}
