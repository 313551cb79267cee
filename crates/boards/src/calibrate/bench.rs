//! Measurements on the keys of armed boards.

use std::time::Duration;

use firmware_protocol::key::KeyIndex;
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::KeyBus as _;

use super::{
    Balance, CalibrationFault, Next, RangeFound, RangeMeasurement, RestMeasurement, Rested,
    Travelled, TripMeasurement,
};
use crate::keybed::{Armed, Keybed};

/// Time without a sample after which a key is given up (us).
const SILENT_US: u64 = 500_000;
/// Age beyond which a sample is not used (us).
const STALE_US: u64 = 20_000;
/// Rate at which a push is reduced when a key is left (N/s).
const RELEASE: f64 = 5.0;

#[derive(Clone, Copy, Debug)]
enum Resting {
    At {
        rest: RestMeasurement,
        /// Arrival of its newest sample (us).
        heard: u64,
    },
    Done(Result<Rested, CalibrationFault>),
}

impl Resting {
    const SILENT: CalibrationFault = CalibrationFault::Silent { seconds: SILENT_US as f64 * 2e-6 };

    /// Processes the key's position at `now` (us, m), if known; gives up a silent key.
    fn advance(&mut self, now: u64, position: Option<f64>) {
        let Self::At { rest, heard } = self else { return };
        let Some(position) = position else {
            if *heard + 2 * SILENT_US < now {
                *self = Self::Done(Err(Self::SILENT));
            }
            return;
        };
        *heard = now;
        match rest.advance(now as f64 * 1e-6, position) {
            Ok(Next::Push(_)) => {}
            Ok(Next::Done(rested)) => *self = Self::Done(Ok(rested)),
            Err(fault) => *self = Self::Done(Err(fault)),
        }
    }

    const fn outcome(self) -> Result<Rested, CalibrationFault> {
        match self {
            Self::At { .. } => Err(CalibrationFault::Stopped),
            Self::Done(outcome) => outcome,
        }
    }
}

/// Manner in which measurements are ended from outside.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Ending {
    Gently,
    AtOnce,
}

type StopCheck = Box<dyn FnMut(&mut Keybed<Armed>) -> Option<Ending>>;

/// Armed boards under measurement; all keys but the measured one feel no force.
pub struct Bench {
    keybed: Keybed<Armed>,
    watch: StopCheck,
    ending: Option<Ending>,
    samples: [KeySample; KEYS],
    /// Forces for the motors (N, up positive).
    forces: [f64; KEYS],
    tick: u64,
    /// Due time of the next exchange (us).
    due: u64,
}

impl std::fmt::Debug for Bench {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { keybed, ending, .. } = self;
        f.debug_struct("Bench")
            .field("keybed", keybed)
            .field("ending", ending)
            .finish_non_exhaustive()
    }
}

impl Bench {
    /// Returns a bench for boards armed as if they were nominal.
    pub fn new(keybed: Keybed<Armed>) -> Self {
        Self::watched(keybed, |_keybed| None)
    }

    /// Like [`Self::new`], but calls `watch` before each exchange. A `watch` that returns
    /// [`Ending::AtOnce`] has already stopped the boards.
    pub fn watched(
        keybed: Keybed<Armed>,
        watch: impl FnMut(&mut Keybed<Armed>) -> Option<Ending> + 'static,
    ) -> Self {
        let due = keybed.now_us();
        let samples = [KeySample::default(); KEYS];
        let (watch, ending) = (Box::new(watch), None);
        Self { keybed, watch, ending, samples, forces: [0.0; KEYS], tick: 0, due }
    }

    /// Returns how measurements were ended, if they were; none is made afterwards.
    pub const fn ending(&self) -> Option<Ending> {
        self.ending
    }

    pub fn release(mut self) -> Keybed<Armed> {
        self.keybed.disarm();
        self.keybed
    }

    pub const fn keybed(&self) -> &Keybed<Armed> {
        &self.keybed
    }

    pub fn rests(&mut self, keys: &[KeyIndex]) -> Vec<Result<Rested, CalibrationFault>> {
        let (rest, heard) = (RestMeasurement::default(), self.keybed.now_us());
        let mut rests = vec![Resting::At { rest, heard }; keys.len()];
        while self.ending.is_none() && rests.iter().any(|it| matches!(it, Resting::At { .. })) {
            self.exchange();
            let now = self.keybed.now_us();
            for (key, resting) in keys.iter().zip(&mut rests) {
                resting.advance(now, self.position(*key));
            }
        }
        rests.into_iter().map(Resting::outcome).collect()
    }

    pub fn trip(&mut self, key: KeyIndex, rested: &Rested) -> Result<Travelled, CalibrationFault> {
        let mut trip = TripMeasurement::new(rested);
        self.work(key, |t, position| trip.advance(t, position))
    }

    /// Balances `mass` (kg), which lies on `key`; returns the command to its motor per newton (1).
    pub fn balance(
        &mut self,
        key: KeyIndex,
        rested: &Rested,
        empty: &Travelled,
        mass: f64,
    ) -> Result<f64, CalibrationFault> {
        let mut balance = Balance::new(rested, empty, mass);
        self.work(key, |t, position| balance.advance(t, position))
    }

    /// Raises an object on `key`; its force is gone at once at every end.
    pub fn range(
        &mut self,
        key: KeyIndex,
        mut measurement: RangeMeasurement,
    ) -> Result<RangeFound, CalibrationFault> {
        let found = self.push(key, 0, |t, position| measurement.advance(t, position));
        self.forces[key.index()] = 0.0;
        self.exchange();
        found
    }

    /// Keeps the boards armed, without forces, until `is_over` or the end of measurements.
    pub fn wait(&mut self, mut is_over: impl FnMut() -> bool) {
        while self.ending.is_none() && !is_over() {
            self.exchange();
        }
    }

    fn work<T>(
        &mut self,
        key: KeyIndex,
        advance: impl FnMut(f64, f64) -> Result<Next<T>, CalibrationFault>,
    ) -> Result<T, CalibrationFault> {
        let outcome = self.push(key, STALE_US, advance);
        self.let_go(key);
        outcome
    }

    /// Like [`Self::work`], with positions up to this age (us), and without letting go.
    fn push<T>(
        &mut self,
        key: KeyIndex,
        oldest_us: u64,
        mut advance: impl FnMut(f64, f64) -> Result<Next<T>, CalibrationFault>,
    ) -> Result<T, CalibrationFault> {
        let armings = self.armings(key);
        let mut heard = self.keybed.now_us();
        loop {
            self.exchange();
            if self.ending.is_some() {
                break Err(CalibrationFault::Stopped);
            }
            let now = self.keybed.now_us();
            if armings.is_none() || self.keybed.armings(key) != armings {
                break Err(CalibrationFault::Interrupted);
            }
            let position = self.position_within(key, oldest_us);
            // A host that was stopped for that long finds the samples of that time.
            if position.is_none() && heard + SILENT_US < now {
                break Err(CalibrationFault::Silent { seconds: SILENT_US as f64 * 1e-6 });
            }
            let Some(position) = position else { continue };
            heard = now;
            match advance(self.seconds(), position) {
                Ok(Next::Push(push)) => self.forces[key.index()] = -push,
                Ok(Next::Done(done)) => break Ok(done),
                Err(fault @ CalibrationFault::Stuck { .. }) => {
                    let forces = self.keybed.untaken_forces(key);
                    break Err(forces.map_or(fault, |forces| CalibrationFault::Untaken { forces }));
                }
                Err(fault) => break Err(fault),
            }
        }
    }

    fn let_go(&mut self, key: KeyIndex) {
        let step = RELEASE * self.keybed.period_us() as f64 * 1e-6;
        while self.forces[key.index()].abs() > step {
            self.forces[key.index()] -= step.copysign(self.forces[key.index()]);
            self.exchange();
        }
        self.forces[key.index()] = 0.0;
        self.exchange();
    }

    fn armings(&mut self, key: KeyIndex) -> Option<u64> {
        let until = self.keybed.now_us() + 2 * SILENT_US;
        let is_over = |it: &Self| it.ending.is_some() || until <= it.keybed.now_us();
        while self.keybed.armings(key).is_none() && !is_over(self) {
            self.exchange();
        }
        self.keybed.armings(key)
    }

    fn exchange(&mut self) {
        let period = self.keybed.period_us();
        let now = self.keybed.now_us();
        if now < self.due {
            self.keybed.clock().pause(Duration::from_micros(self.due - now));
        }
        if self.ending != Some(Ending::AtOnce) {
            self.ending = (self.watch)(&mut self.keybed).or(self.ending);
        }
        if self.ending == Some(Ending::AtOnce) {
            self.forces = [0.0; KEYS];
        }
        // Missed exchanges are not made up.
        self.due = self.due.max(now.saturating_sub(period)) + period;
        self.tick += 1;
        self.keybed.receive(self.tick, &mut self.samples);
        // Arrival times count here, not a board's clock, which is uncertain in the first seconds.
        self.samples = *self.keybed.newest();
        self.keybed.send(self.tick, &self.forces, &[KeySlope::HELD; KEYS]);
    }

    fn position(&self, key: KeyIndex) -> Option<f64> {
        self.position_within(key, STALE_US)
    }

    /// Returns the position (m) of a sample up to this age (us).
    fn position_within(&self, key: KeyIndex, oldest_us: u64) -> Option<f64> {
        let KeySample { position, age, .. } = self.samples[key.index()];
        let age_us = u64::from(age).saturating_mul(self.keybed.period_us());
        (age_us <= oldest_us).then_some(position)
    }

    fn seconds(&self) -> f64 {
        self.keybed.now_us() as f64 * 1e-6
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_is_silent_a_second_after_its_newest_sample() {
        let mut resting = Resting::At { rest: RestMeasurement::default(), heard: 0 };
        resting.advance(900_000, Some(0.0));
        resting.advance(1_900_000, None);
        assert!(matches!(resting, Resting::At { heard: 900_000, .. }), "{resting:?}");
        resting.advance(1_900_001, None);
        assert!(matches!(resting.outcome(), Err(CalibrationFault::Silent { .. })), "{resting:?}");
    }
}
