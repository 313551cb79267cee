//! The host's end of one board: its newest samples, and the forces that answer them.

use firmware_protocol::frame::Header;
use firmware_protocol::frame::key_forces::{self, ForceLayout, ForcePacking, KeyForces};
use firmware_protocol::frame::key_samples::{KeySamples, SampleLayout};
use firmware_protocol::key::{MOST_KEYS, PerKey};
use firmware_protocol::quantity::Millinewtons;
use scheduler::motion::{KEYS, KeySample, KeySlope};

use super::key_fault::{GuardFindings, KeyFault};
use super::key_guard::KeyGuard;
use super::loss::{Loss, LossCounts};
use super::plausible::{FASTEST, KeyCheck};
use super::sample_interval::{IntervalWatch, SampleIntervals};
use crate::calibration::{self, KeyCalibration};
use crate::topology::BoardPlace;

/// What the host must know of a board to exchange with it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BoardTerms {
    /// Where it is, and which keys it carries.
    pub place: BoardPlace,
    /// How its samples are packed.
    pub samples: SampleLayout,
    /// How its forces are packed.
    pub forces: ForceLayout,
    /// How each of its keys reads and pushes.
    pub calibration: PerKey<KeyCalibration>,
    /// Largest force of its motors (mN), which it is never asked to exceed.
    pub max_force_mn: u16,
}

impl BoardTerms {
    /// Returns what to ask of the motor of a key for `force` (N), no more than it has.
    pub(super) fn millinewtons(&self, calibration: &KeyCalibration, force: f64) -> Millinewtons {
        self.limited(calibration.millinewtons(force))
    }

    /// Returns `force`, but no more than the motors have.
    fn limited(&self, force: Millinewtons) -> Millinewtons {
        let most = i32::from(self.max_force_mn);
        Millinewtons::saturating(i32::from(force.get()).clamp(-most, most))
    }

    /// Tells whether somebody has measured how its keys read.
    pub fn is_calibrated(&self) -> bool {
        !self.calibration.as_slice().iter().all(KeyCalibration::is_nominal)
    }
}

/// What one board has sent and was sent.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct BoardStatistics {
    /// Counts over the sequence numbers of its samples.
    pub samples: LossCounts,
    /// Frames from it that were refused: length, padding or content.
    pub refused: u64,
    /// Force frames that the link took.
    pub sent: u64,
    /// Force frames that it did not take, or that had no samples to answer.
    pub unsent: u64,
    /// Its newest frame said that it renders no force.
    pub is_safe: bool,
    /// Readings of keys that were not used, since no key can be there.
    pub implausible: u64,
    /// What was noticed of its keys.
    pub keys: GuardFindings,
    /// Time between its samples of late, by its own clock.
    pub intervals: Option<SampleIntervals>,
}

/// The host's end of one board.
#[derive(Clone, Debug)]
pub struct BoardEnd {
    terms: BoardTerms,
    loss: Loss,
    statistics: BoardStatistics,
    /// The newest samples, which the next forces answer, and the tick in which they came.
    newest: Option<(KeySamples, u64)>,
    /// Which of its readings can be those of keys, and which of the newest were used.
    checks: [KeyCheck; MOST_KEYS],
    used: [bool; MOST_KEYS],
    /// Share of the forces that it is sent, and the largest that it shall be, `0 ..= 1`.
    share: f64,
    most_share: f64,
    intervals: IntervalWatch,
    /// What stands between models and motors, if these are real.
    guards: Option<Box<Guards>>,
}

/// The guards of all keys of a board, and the rhythm of its forces.
#[derive(Clone, Debug)]
struct Guards {
    keys: [KeyGuard; MOST_KEYS],
    /// Time between two exchanges (us).
    period_us: u64,
    /// When the last forces were sent (us).
    sent_us: Option<u64>,
    /// Samples have come after a gap, and no force has answered them.
    is_resuming: bool,
}

impl Guards {
    /// Longest gap between samples that forces are not led over (periods): an estimator bridges one
    /// or two lost samples.
    const SAMPLE_GAP: f64 = 3.5;
    /// The same between forces: none is left out by design.
    const FORCE_GAP: f64 = 1.5;
    /// Longest time between two forces that counts for what they may change (periods).
    const LONGEST: f64 = 4.0;

    /// Returns the time since the last force (s), and whether there was a gap.
    fn since(&mut self, now_us: u64) -> (f64, bool) {
        let period = self.period_us as f64;
        let passed = self.sent_us.replace(now_us).map(|it| now_us.saturating_sub(it) as f64);
        let is_gap = passed.is_some_and(|it| Self::FORCE_GAP * period < it);
        let passed = passed.unwrap_or(period).min(Self::LONGEST * period);
        (1e-6 * passed, std::mem::take(&mut self.is_resuming) || is_gap)
    }
}

impl BoardEnd {
    /// Returns an end that has heard nothing.
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

    /// Guards all keys from now on, in exchanges every `period_us`.
    pub(super) fn guard(&mut self, period_us: u64) {
        let keys = [KeyGuard::default(); MOST_KEYS];
        self.guards = Some(Box::new(Guards { keys, period_us, sent_us: None, is_resuming: false }));
    }

    /// Lets no model have a motor that has not been proven from now on.
    pub(super) fn demand_proof(&mut self) {
        self.guarded_keys().for_each(KeyGuard::demand_proof);
    }

    /// Plays the key in `slot` no more.
    pub(super) fn mute(&mut self, slot: usize, fault: KeyFault) {
        if let Some(guard) = self.guarded_keys().nth(slot) {
            guard.mute(fault);
        }
    }

    /// Returns the guards of its keys, if they are guarded.
    fn guarded_keys(&mut self) -> impl Iterator<Item = &mut KeyGuard> {
        let n_keys = self.terms.place.n_keys;
        self.guards.iter_mut().flat_map(move |it| it.keys[..n_keys].iter_mut())
    }

    /// Returns whether a proof is under way, and not merely waiting for its key to rest.
    pub(super) fn is_proving(&self) -> bool {
        let n_keys = self.terms.place.n_keys;
        let mut keys = self.guards.iter().flat_map(|it| &it.keys[..n_keys]);
        keys.any(|it| it.is_unproven() && !it.waits_for_rest())
    }

    /// Returns what its guards and checks have found.
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

    /// Returns what was agreed with the board.
    pub const fn terms(&self) -> &BoardTerms {
        &self.terms
    }

    /// Tells whether its forces come in frames for all boards.
    pub(super) fn takes_multicast(&self) -> bool {
        self.terms.forces.packing == ForcePacking::Multicast16
    }

    /// Returns what it has sent and was sent.
    pub fn statistics(&self) -> BoardStatistics {
        BoardStatistics {
            samples: self.loss.counts(),
            keys: self.findings(),
            intervals: self.intervals.newest(),
            ..self.statistics
        }
    }

    /// Returns the newest samples as they came.
    pub fn newest(&self) -> Option<&KeySamples> {
        self.newest.as_ref().map(|(newest, _tick)| newest)
    }

    /// Tells whether samples have come in `tick`.
    pub(super) fn has_news(&self, tick: u64) -> bool {
        self.newest.as_ref().is_some_and(|(_, came)| *came == tick)
    }

    /// Forgets what came, for a board that starts anew; the counts stay.
    pub fn forget(&mut self) {
        self.loss.forget();
        self.newest = None;
        self.intervals.forget();
    }

    /// Gives the keys that were muted another chance, for a board that was switched on anew.
    pub fn unmute(&mut self) {
        self.checks = Default::default();
        self.guarded_keys().for_each(KeyGuard::unmute);
    }

    /// Limits the share of the forces that the board is sent to `most`, `0 ..= 1`.
    pub(super) const fn limit_share(&mut self, most: f64) {
        self.most_share = most;
    }

    /// Moves the share of the forces that the board is sent by `step` at most: to none for one
    /// that says that it renders none, to its limit for any other.
    pub(super) fn move_share(&mut self, step: f64) {
        let wanted = if self.statistics.is_safe { 0.0 } else { self.most_share };
        self.share += (wanted - self.share).clamp(-step, step);
    }

    /// Takes a frame of samples; says whether it was newer than all before.
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

    /// Returns how long `samples` were taken after the newest before them by the board's clock (s),
    /// if they are the next.
    fn elapsed(&self, samples: &KeySamples, tick: u64) -> Option<f64> {
        let (newest, _tick) = self.newest.as_ref()?;
        let is_next = self.loss.is_next(samples.header.sequence, tick);
        let us = since_us(newest, samples);
        // A clock that stands still tells nothing.
        (is_next && 0 < us).then(|| f64::from(us) * 1e-6)
    }

    /// Takes the time by which the newest samples are later than those before (us), and how many
    /// frames were lost between them.
    fn take_interval(&mut self, interval_us: u16, missing: u64) {
        self.intervals.take(interval_us, missing);
        if let Some(guards) = &mut self.guards {
            let longest = Guards::SAMPLE_GAP * guards.period_us as f64;
            guards.is_resuming |= longest < f64::from(interval_us);
        }
    }

    /// Looks which of the readings can be those of keys.
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

    /// Writes the newest samples into their keys' places, as if they had just been taken; a place or
    /// a speed that no key can have is not written.
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

    /// Returns what of `forces` (N, up positive) its keys shall get at `now_us`, by slot.
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

    /// Returns the next force frame and its length, for what `rendered` has for its keys (N);
    /// nothing if there are no samples to answer.
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

    /// Returns how the force on a key goes on: as `slope` says if it is sent whole, and answers
    /// where the key really is.
    fn slope(&self, slot: usize, slope: &KeySlope) -> KeySlope {
        let guard = self.guards.as_ref().and_then(|it| it.keys.get(slot));
        let is_whole = 1.0 <= self.share && guard.is_none_or(KeyGuard::is_whole);
        if self.used[slot] && is_whole { *slope } else { KeySlope::HELD }
    }

    /// Counts a force frame that the link took, or did not take.
    #[expect(clippy::fn_params_excessive_bools, reason = "the one fact that there is")]
    pub const fn count_sent(&mut self, taken: bool) {
        if taken {
            self.statistics.sent += 1;
        } else {
            self.statistics.unsent += 1;
        }
    }

    /// Returns where a key was when the newest samples were taken, as the board knows it too.
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

/// Returns the time from one frame of samples to another by their board's clock (us), which wraps.
const fn since_us(earlier: &KeySamples, later: &KeySamples) -> u16 {
    later.header.stamp_us.wrapping_sub(earlier.header.stamp_us)
}

#[cfg(test)]
mod tests {
    use firmware_protocol::frame::key_samples::{self, SamplePacking};
    use firmware_protocol::quantity::Counts;
    use firmware_protocol::sequence::SequenceNumber;

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
