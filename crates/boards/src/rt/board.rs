use firmware_protocol::frame::key_forces::{self, ForceLayout, ForcePacking, KeyForces};
use firmware_protocol::frame::key_samples::{KeySamples, SampleLayout};
use firmware_protocol::key::{MOST_KEYS, PerKey};
use firmware_protocol::{frame::Header, quantity::Millinewtons};
use scheduler::motion::{KEYS, KeySample, KeySlope};

use super::key_fault::{GuardFindings, KeyFault};
use super::key_guard::KeyGuard;
use super::loss::{Loss, LossCounts};
use super::plausible::{FASTEST, KeyCheck};
use super::sample_interval::{IntervalWatch, SampleIntervals};
use crate::calibration::{self, KeyCalibration};
use crate::topology::BoardPlace;

/// Facts about a board that an exchange needs.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BoardTerms {
    pub place: BoardPlace,
    pub samples: SampleLayout,
    pub forces: ForceLayout,
    pub calibration: PerKey<KeyCalibration>,
    /// Largest force of its motors (mN), which it is never asked to exceed.
    pub max_force_mn: u16,
}

impl BoardTerms {
    /// Returns the command for the motor of a key for `force` (N), within its limit.
    pub(super) fn millinewtons(&self, calibration: &KeyCalibration, force: f64) -> Millinewtons {
        self.limited(calibration.millinewtons(force))
    }

    fn limited(&self, force: Millinewtons) -> Millinewtons {
        let most = i32::from(self.max_force_mn);
        Millinewtons::saturating(i32::from(force.get()).clamp(-most, most))
    }

    pub fn is_calibrated(&self) -> bool {
        !self.calibration.as_slice().iter().all(KeyCalibration::is_nominal)
    }
}

/// Statistics of the exchange with one board.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct BoardStatistics {
    pub samples: LossCounts,
    /// Rejected frames: length, padding or content.
    pub refused: u64,
    pub sent: u64,
    /// Force frames that the link rejected, or without samples to answer.
    pub unsent: u64,
    /// `true` if its newest frame reports that it renders no force.
    pub is_safe: bool,
    /// Discarded readings at positions that no key can reach.
    pub implausible: u64,
    pub keys: GuardFindings,
    /// Recent intervals of its samples, by its own clock.
    pub intervals: Option<SampleIntervals>,
}

/// The host's end of one board.
#[derive(Clone, Debug)]
pub struct BoardEnd {
    terms: BoardTerms,
    loss: Loss,
    statistics: BoardStatistics,
    /// Newest samples, which the next forces answer, and the tick of their arrival.
    newest: Option<(KeySamples, u64)>,
    /// Plausibility checks of its keys, and the slots with usable newest readings.
    checks: [KeyCheck; MOST_KEYS],
    used: [bool; MOST_KEYS],
    /// Share of the forces to send, and its limit, `0 ..= 1`.
    share: f64,
    most_share: f64,
    intervals: IntervalWatch,
    /// Guards between models and motors, if the motors are real.
    guards: Option<Box<Guards>>,
}

#[derive(Clone, Debug)]
struct Guards {
    keys: [KeyGuard; MOST_KEYS],
    period_us: u64,
    sent_us: Option<u64>,
    /// `true` if samples arrived after a gap and no force has answered them.
    is_resuming: bool,
}

impl Guards {
    /// Longest gap between samples without blending (periods): estimators bridge two lost samples.
    const SAMPLE_GAP: f64 = 3.5;
    /// Longest gap between forces without blending (periods): none is left out by design.
    const FORCE_GAP: f64 = 1.5;
    /// Longest time between two forces that counts for their change (periods).
    const LONGEST: f64 = 4.0;

    /// Returns the time since the last force (s), and `true` after a gap.
    fn since(&mut self, now_us: u64) -> (f64, bool) {
        let period = self.period_us as f64;
        let passed = self.sent_us.replace(now_us).map(|it| now_us.saturating_sub(it) as f64);
        let is_gap = passed.is_some_and(|it| Self::FORCE_GAP * period < it);
        let passed = passed.unwrap_or(period).min(Self::LONGEST * period);
        (1e-6 * passed, std::mem::take(&mut self.is_resuming) || is_gap)
    }
}

impl BoardEnd {
    pub fn new(terms: BoardTerms) -> Self {
        Self {
            terms,
            loss: Loss::default(),
            statistics: BoardStatistics::default(),
            newest: None,
            checks: Default::default(),
            used: [false; MOST_KEYS],
            share: 1.0,
            most_share: 1.0,
            intervals: IntervalWatch::default(),
            guards: None,
        }
    }

    pub(super) fn guard(&mut self, period_us: u64) {
        let keys = [KeyGuard::default(); MOST_KEYS];
        self.guards = Some(Box::new(Guards { keys, period_us, sent_us: None, is_resuming: false }));
    }

    /// Denies models all unproven motors from now on.
    pub(super) fn demand_proof(&mut self) {
        self.guarded_keys().for_each(KeyGuard::demand_proof);
    }

    pub(super) fn mute(&mut self, slot: usize, fault: KeyFault) {
        if let Some(guard) = self.guarded_keys().nth(slot) {
            guard.mute(fault);
        }
    }

    fn guarded_keys(&mut self) -> impl Iterator<Item = &mut KeyGuard> {
        let n_keys = self.terms.place.n_keys;
        self.guards.iter_mut().flat_map(move |it| it.keys[..n_keys].iter_mut())
    }

    /// Returns `true` while a motor is being proven, other than waiting for its key to rest.
    pub(super) fn is_proving(&self) -> bool {
        let n_keys = self.terms.place.n_keys;
        let mut keys = self.guards.iter().flat_map(|it| &it.keys[..n_keys]);
        keys.any(|it| it.is_unproven() && !it.waits_for_rest())
    }

    fn findings(&self) -> GuardFindings {
        let muted = self.checks.each_ref().map(KeyCheck::muted);
        let mut keys = GuardFindings { muted, ..GuardFindings::default() };
        let Some(guards) = &self.guards else { return keys };
        let guarded = guards.keys.iter().zip(self.terms.calibration.as_slice());
        for (slot, (guard, calibration)) in guarded.enumerate() {
            let bit = |is_so| u16::from(is_so) << slot;
            keys.softened |= bit(guard.is_softened());
            keys.unproven |= bit(guard.is_unproven());
            keys.misplaced |= bit(guard.is_misplaced(calibration.travel()));
            keys.muted[slot] = keys.muted[slot].or(guard.fault());
            let [glitches, limited, blended] = guard.counts();
            keys.glitches += glitches;
            keys.limited += limited;
            keys.blended += blended;
        }
        keys
    }

    pub const fn terms(&self) -> &BoardTerms {
        &self.terms
    }

    pub(super) fn takes_multicast(&self) -> bool {
        self.terms.forces.packing == ForcePacking::Multicast16
    }

    pub fn statistics(&self) -> BoardStatistics {
        BoardStatistics {
            samples: self.loss.counts(),
            keys: self.findings(),
            intervals: self.intervals.newest(),
            ..self.statistics
        }
    }

    pub fn newest(&self) -> Option<&KeySamples> {
        self.newest.as_ref().map(|(newest, _tick)| newest)
    }

    pub(super) fn has_news(&self, tick: u64) -> bool {
        self.newest.as_ref().is_some_and(|(_, came)| *came == tick)
    }

    /// Forgets the exchange, for a board that restarts; the counts stay.
    pub fn forget(&mut self) {
        self.loss.forget();
        self.newest = None;
        self.intervals.forget();
    }

    pub fn unmute(&mut self) {
        self.checks = Default::default();
        self.guarded_keys().for_each(KeyGuard::unmute);
    }

    pub(super) const fn limit_share(&mut self, most: f64) {
        self.most_share = most;
    }

    /// Moves the share of the forces by at most `step`: to its limit, or to zero for a safe board.
    pub(super) fn move_share(&mut self, step: f64) {
        let wanted = if self.statistics.is_safe { 0.0 } else { self.most_share };
        self.share += (wanted - self.share).clamp(-step, step);
    }

    /// Decodes a sample frame. Returns `true` if the frame is newer than all earlier ones.
    pub fn hear(&mut self, frame: &[u8], tick: u64) -> bool {
        let Ok(samples) = KeySamples::decode(frame, self.terms.samples) else {
            self.statistics.refused += 1;
            return false;
        };
        let elapsed = self.elapsed(&samples, tick);
        let interval_us = self.newest().map(|it| since_us(it, &samples));
        let missing = self.loss.counts().missing;
        let news = self.loss.accept(samples.header.sequence, tick);
        if news {
            let missing = self.loss.counts().missing - missing;
            if let Some(interval_us) = interval_us {
                self.take_interval(interval_us, missing);
            }
            self.statistics.is_safe = samples.header.flag;
            self.newest = Some((samples, tick));
            self.check(&samples, elapsed);
        }
        news
    }

    /// Returns the interval from the previous samples by the board's clock (s), if none were lost.
    fn elapsed(&self, samples: &KeySamples, tick: u64) -> Option<f64> {
        let (newest, _tick) = self.newest.as_ref()?;
        let is_next = self.loss.is_next(samples.header.sequence, tick);
        let us = since_us(newest, samples);
        // A clock that stands still is ignored.
        (is_next && 0 < us).then(|| f64::from(us) * 1e-6)
    }

    /// Records the interval of the newest samples (us), and the number of frames lost in it.
    fn take_interval(&mut self, interval_us: u16, missing: u64) {
        self.intervals.take(interval_us, missing);
        if let Some(guards) = &mut self.guards {
            let longest = Guards::SAMPLE_GAP * guards.period_us as f64;
            guards.is_resuming |= longest < f64::from(interval_us);
        }
    }

    fn check(&mut self, samples: &KeySamples, elapsed: Option<f64>) {
        let readings =
            samples.positions.as_slice().iter().zip(self.terms.calibration.as_slice()).enumerate();
        for (slot, (counts, calibration)) in readings {
            let (check, position) = (&mut self.checks[slot], calibration.position(*counts));
            if let Some(speed) = samples.velocities.as_slice().get(slot) {
                check.add_speed(calibration::metres_per_second(*speed), position, elapsed);
            }
            let is_possible = check.accept(position, elapsed, calibration);
            let guard = self.guards.as_mut().and_then(|it| it.keys.get_mut(slot));
            let is_on_trend = guard.is_none_or(|it| it.accept(position, elapsed, calibration));
            self.used[slot] = is_possible && is_on_trend;
            self.statistics.implausible += u64::from(!is_possible);
        }
    }

    /// Writes the newest plausible samples to their keys, as if they had just been taken.
    pub fn publish(&self, samples: &mut [KeySample; KEYS]) {
        let Some((newest, _tick)) = &self.newest else { return };
        let places = samples[self.terms.place.keys()].iter_mut();
        let has_velocity = self.terms.samples.packing.has_velocity();
        for (slot, (sample, calibration)) in
            places.zip(self.terms.calibration.as_slice()).enumerate()
        {
            if self.used[slot] {
                let here = Self::measured(slot, newest, calibration);
                let velocity =
                    has_velocity.then_some(here.velocity).filter(|it| it.abs() <= FASTEST);
                *sample = KeySample { velocity, ..KeySample::fresh(here.position) };
            }
        }
    }

    /// Returns the forces (N) for its keys at `now_us` by slot, out of `forces` (N, up positive).
    pub(super) fn rendered(&mut self, now_us: u64, forces: &[f64; KEYS]) -> [f64; MOST_KEYS] {
        let mut rendered = [0.0; MOST_KEYS];
        let share = self.share;
        let wanted = &forces[self.terms.place.keys()];
        let Some(guards) = &mut self.guards else {
            rendered.iter_mut().zip(wanted).for_each(|(it, wanted)| *it = share * wanted);
            return rendered;
        };
        let Some((newest, _tick)) = &self.newest else { return rendered };
        let (elapsed, is_gap) = guards.since(now_us);
        let keys = guards.keys.iter_mut().zip(self.terms.calibration.as_slice());
        let keys = keys.zip(newest.positions.as_slice()).zip(&self.checks);
        for ((((guard, calibration), counts), check), (force, wanted)) in
            keys.zip(rendered.iter_mut().zip(wanted))
        {
            if let Some(fault) = check.muted() {
                guard.mute(fault);
            }
            if is_gap {
                guard.lead_over(*wanted);
            }
            let place = (calibration.position(*counts), elapsed);
            *force = guard.force(*wanted, share, place, calibration);
        }
        rendered
    }

    /// Returns the next force frame and its length for forces (N) of `rendered`, if samples came.
    pub fn answer(
        &mut self,
        rendered: &[f64; MOST_KEYS],
        slopes: &[KeySlope; KEYS],
    ) -> Option<([u8; key_forces::MAX_LEN], usize)> {
        let (newest, _tick) = self.newest.as_ref()?;
        let keys = self.terms.place.keys();
        let mut frame = KeyForces {
            header: Header { flag: false, ..newest.header },
            forces: PerKey::default(),
            slopes: PerKey::default(),
        };
        let pairs = rendered.iter().zip(self.terms.calibration.as_slice());
        if self.terms.forces.packing == ForcePacking::Force16Slope {
            let answered =
                keys.zip(pairs).enumerate().map(|(slot, (key, (force, calibration)))| {
                    let here = Self::measured(slot, newest, calibration);
                    calibration.sloped(*force, &self.slope(slot, &slopes[key]), here)
                });
            let answered: PerKey<_> = PerKey::collect(answered);
            let forces = answered.as_slice().iter().map(|(force, _)| self.terms.limited(*force));
            frame.forces = PerKey::collect(forces);
            frame.slopes = PerKey::collect(answered.as_slice().iter().map(|(_, slopes)| *slopes));
        } else {
            frame.forces =
                PerKey::collect(pairs.map(|(force, it)| self.terms.millinewtons(it, *force)));
        }
        let mut bytes = [0; key_forces::MAX_LEN];
        let len = frame.encode(&mut bytes);
        Some((bytes, len))
    }

    /// Returns the slope of a key's force: `slope` at the measured position for a whole force.
    fn slope(&self, slot: usize, slope: &KeySlope) -> KeySlope {
        let guard = self.guards.as_ref().and_then(|it| it.keys.get(slot));
        let is_whole = 1.0 <= self.share && guard.is_none_or(KeyGuard::is_whole);
        if self.used[slot] && is_whole { *slope } else { KeySlope::HELD }
    }

    #[expect(clippy::fn_params_excessive_bools, reason = "the one fact that there is")]
    pub const fn count_sent(&mut self, taken: bool) {
        if taken {
            self.statistics.sent += 1;
        } else {
            self.statistics.unsent += 1;
        }
    }

    /// Returns the quantized state of a key in the newest samples, as known to the board.
    fn measured(
        slot: usize,
        newest: &KeySamples,
        calibration: &KeyCalibration,
    ) -> calibration::MeasurementPoint {
        let counts = newest.positions.as_slice().get(slot).copied().unwrap_or_default();
        let speed = newest.velocities.as_slice().get(slot).copied().unwrap_or_default();
        calibration::MeasurementPoint {
            position: calibration.position(counts),
            velocity: calibration::metres_per_second(speed),
        }
    }
}

/// Returns the time between two frames by their board's clock (us), which wraps.
const fn since_us(earlier: &KeySamples, later: &KeySamples) -> u16 {
    later.header.stamp_us.wrapping_sub(earlier.header.stamp_us)
}

#[cfg(test)]
mod tests {
    use firmware_protocol::frame::key_samples::{self, SamplePacking};
    use firmware_protocol::{quantity::Counts, sequence::SequenceNumber};

    use super::*;
    use crate::topology;

    /// Sample of a key that its board reports at 5 mm with this speed (m/s).
    fn heard(packing: SamplePacking, speed: f64) -> KeySample {
        let place = topology::standard()[0];
        let n_keys = place.n_keys;
        let calibration = KeyCalibration::nominal(1e-6);
        let mut end = BoardEnd::new(BoardTerms {
            place,
            samples: SampleLayout { packing, n_keys },
            forces: ForceLayout { packing: ForcePacking::Force16, n_keys },
            calibration: PerKey::collect(std::iter::repeat_n(calibration, n_keys)),
            max_force_mn: u16::MAX,
        });
        let header =
            Header { board: place.board, sequence: SequenceNumber(0), stamp_us: 0, flag: false };
        let each = |counts: Counts| PerKey::collect(std::iter::repeat_n(counts, n_keys));
        let velocities = PerKey::collect(std::iter::repeat_n(calibration::speed(speed), n_keys));
        let samples = KeySamples { header, positions: each(calibration.counts(5e-3)), velocities };
        let mut frame = [0; key_samples::MAX_LEN];
        let len = samples.encode(packing, &mut frame);
        assert!(end.hear(&frame[..len], 0));
        let mut known = [KeySample::default(); KEYS];
        end.publish(&mut known);
        known[place.keys().start]
    }

    #[test]
    fn speeds_that_a_board_measures_are_known_and_those_that_no_key_has_are_not() {
        let sample = heard(SamplePacking::Position24Velocity, 0.8);
        assert_eq!(sample.velocity.map(|it| (it * 1e4).round()), Some(8000.0), "{sample:?}");
        assert!((sample.position - 5e-3).abs() < 1e-9, "{sample:?}");
        assert_eq!(heard(SamplePacking::Position24Velocity, -6.0).velocity, None);
        assert_eq!(heard(SamplePacking::Position24, 0.8).velocity, None);
    }
}
