//! One simulated key, without a board.
//!
//! [`SimulatedKey`] and that key of the keybed produce equal bits, so one can rehearse the other.

use firmware_protocol::{acyclic::arm::VALID_MS, quantity::Counts};
use haptics::plant::{Gesture, HandCommand, KeyRig, RigParameters};
use scheduler::motion::{KeySample, KeySlope, Moment};

use super::force_interlock::{ForceDecision, ForceInterlock};
use super::force_law::Law;
use crate::Error;
use crate::calibration::{self, KeyCalibration};

/// Ticks made up after a pause of the caller: enough to trip the watchdog and fade at 8 kHz.
const MAX_CATCH_UP: u64 = 256;

/// Longest period of a tick (s).
const MAX_PERIOD: f64 = 1.0;

#[derive(Clone, Debug)]
pub(super) struct Plant {
    rig: KeyRig,
    /// Reading of the encoder at position 0 (counts).
    offset: i32,
    gestures: Vec<Gesture>,
    /// Index of the first gesture that is not over.
    current: usize,
    /// Length of a pass (s), if the gestures repeat.
    repeat: Option<f64>,
    /// Start of the present pass (s).
    pass: f64,
    /// Force of the last tick (N).
    force: f64,
}

impl Plant {
    /// Returns a key at rest with the reading `offset` (counts).
    pub(super) fn new(rig: RigParameters, offset: i32) -> Self {
        Self {
            rig: KeyRig::new(rig),
            offset,
            gestures: Vec::new(),
            current: 0,
            repeat: None,
            pass: 0.0,
            force: 0.0,
        }
    }

    /// Replaces the gestures, sorted by their starts.
    pub(super) fn play(&mut self, mut gestures: Vec<Gesture>) {
        gestures.sort_by(|one, other| one.start.total_cmp(&other.start));
        self.gestures = gestures;
        self.current = 0;
    }

    /// Repeats the gestures with the period `length` (s).
    pub(super) const fn repeat_after(&mut self, length: f64) {
        self.repeat = Some(length);
    }

    pub(super) fn press(&mut self, hand: HandCommand) {
        self.rig.command(hand);
    }

    /// Adds a gesture, and removes those that are over.
    pub(super) fn add(&mut self, gesture: Gesture) {
        self.gestures.drain(..self.current);
        self.current = 0;
        let place = self.gestures.partition_point(|other| other.start <= gesture.start);
        self.gestures.insert(place, gesture);
    }

    /// Returns position (m), as the encoder reads it, and velocity (m/s).
    pub(super) fn measured(&self) -> (f64, f64) {
        (f64::from(self.counts().get()) * self.rig.quantum(), self.rig.velocity())
    }

    /// Advances from `t` to `t + h` (s) with `force` (N) held; a key at rest is skipped.
    pub(super) fn advance(&mut self, t: f64, h: f64, force: f64) {
        let gesture = self.gesture(t, h);
        let same = force.to_bits() == self.force.to_bits();
        if same && gesture.is_none() && self.rig.is_still() {
            return;
        }
        self.force = force;
        self.rig.advance(t, h, force, gesture.as_ref());
    }

    pub(super) fn counts(&self) -> Counts {
        Counts::saturating(self.rig.counts().saturating_add(self.offset))
    }

    pub(super) const fn rig(&self) -> &KeyRig {
        &self.rig
    }

    pub(super) fn calibration(&self) -> KeyCalibration {
        let nominal = KeyCalibration::of_travel(self.rig.quantum(), self.rig.dip());
        let shifted = |it: Counts| Counts::saturating(it.get().saturating_add(self.offset));
        let (rest, bottom) = (shifted(nominal.rest), shifted(nominal.bottom));
        KeyCalibration { rest, bottom, ..nominal }
    }

    /// Returns the gesture of the tick from `t` to `t + h` (s).
    ///
    /// A finger continues until the next gesture, which is returned in the tick before its start.
    fn gesture(&mut self, t: f64, h: f64) -> Option<Gesture> {
        if let Some(length) = self.repeat
            && self.pass + length <= t
        {
            (self.pass, self.current) = ((t / length).floor() * length, 0);
        }
        let in_pass = t - self.pass;
        while self.is_over(in_pass) {
            self.current += 1;
        }
        let gesture = *self.gestures.get(self.current)?;
        let (start, release) = (gesture.start + self.pass, gesture.release + self.pass);
        (gesture.start < in_pass + h).then_some(Gesture { start, release, ..gesture })
    }

    fn is_over(&self, t: f64) -> bool {
        let next = self.gestures.get(self.current + 1);
        self.gestures.get(self.current).is_some_and(|gesture| gesture.end() <= t)
            || next.is_some_and(|next| next.start <= t)
    }
}

/// Progress of a simulation: the tick of its last samples.
#[derive(Clone, Copy, Debug)]
pub(super) struct SampleProgress {
    period: f64,
    tick: Option<u64>,
}

impl SampleProgress {
    pub(super) fn new(period: f64) -> Result<Self, Error> {
        if 0.0 < period && period <= MAX_PERIOD {
            Ok(Self { period, tick: None })
        } else {
            Err(Error::Period { period })
        }
    }

    /// Advances to `tick`; returns the ticks to simulate before its start.
    pub(super) fn go_on(&mut self, tick: u64) -> std::ops::Range<u64> {
        let from = self.tick.unwrap_or(tick);
        self.tick = Some(tick.max(from));
        from..tick.min(from.saturating_add(MAX_CATCH_UP))
    }

    pub(super) const fn is_new(&self) -> bool {
        self.tick.is_none()
    }

    pub(super) fn us(&self, tick: u64) -> u64 {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "time is positive, and 64 bits of microseconds are enough"
        )]
        let us = (self.seconds(tick) * 1e6).round() as u64;
        us
    }

    /// Returns the start of the present tick (us); 0 before the first.
    pub(super) fn now_us(&self) -> u64 {
        self.us(self.tick.unwrap_or_default())
    }

    pub(super) fn seconds(&self, tick: u64) -> f64 {
        Moment { tick, theta: 0.0 }.seconds(self.period)
    }

    pub(super) const fn period(&self) -> f64 {
        self.period
    }
}

/// One simulated key with the wire's quantisation, to rehearse strokes with.
///
/// `receive` and `send` are those of the keybed for this key, on a link without faults.
#[derive(Clone, Debug)]
pub struct SimulatedKey {
    plant: Plant,
    calibration: KeyCalibration,
    interlock: ForceInterlock,
    progress: SampleProgress,
    law: Law,
    /// A law that arrived after the sample that it answers, and the sample's time (us).
    answer: Option<(u64, Law)>,
}

impl SimulatedKey {
    /// Returns a key at rest, in ticks of `period` (s).
    ///
    /// # Errors
    /// If the period is not above 0 and up to 1 s.
    pub fn new(period: f64, rig: RigParameters) -> Result<Self, Error> {
        let plant = Plant::new(rig, 0);
        let mut interlock = ForceInterlock::new(0);
        interlock.force_armed(u64::from(VALID_MS) * 1_000);
        Ok(Self {
            calibration: plant.calibration(),
            plant,
            interlock,
            progress: SampleProgress::new(period)?,
            law: Law::default(),
            answer: None,
        })
    }

    pub fn play(&mut self, gestures: Vec<Gesture>) {
        self.plant.play(gestures);
    }

    pub fn press(&mut self, hand: HandCommand) {
        self.plant.press(hand);
    }

    /// Advances to the start of `tick` with the present force; returns the sample. The first call
    /// starts there, at rest.
    ///
    /// # Real-time
    /// One tick of the plant for each tick since the last call, at most 256; no heap.
    pub fn receive(&mut self, tick: u64) -> KeySample {
        for step in self.progress.go_on(tick) {
            let now_us = self.progress.us(step);
            if let Some((answered_us, law)) = self.answer.take()
                && self.interlock.feed(answered_us, now_us) == ForceDecision::Rendered
            {
                self.law = law;
            }
            let share = self.interlock.share(now_us);
            self.render(self.progress.seconds(step), share);
        }
        KeySample::fresh(self.calibration.position(self.plant.counts()))
    }

    /// Sets the force (N, up positive) that holds until the next one, with `slope`. A safe key
    /// ignores it, see [`Self::is_safe`], like a key that gave no sample yet.
    ///
    /// # Real-time
    /// One conversion.
    pub fn send(&mut self, force: f64, slope: &KeySlope) {
        if !self.is_safe() && !self.progress.is_new() {
            let (position, velocity) = self.plant.measured();
            let velocity = calibration::metres_per_second(calibration::speed(velocity));
            let here = calibration::MeasurementPoint { position, velocity };
            let (force, slopes) = self.calibration.sloped(force, slope, here);
            let law = Law::here(force, slopes, (position, velocity), self.progress.now_us());
            self.answer = Some((self.progress.now_us(), law));
        }
    }

    /// Advances the plant over a tick from `t` (s); a law is evaluated as often as on a board.
    fn render(&mut self, t: f64, share: f64) {
        /// Period of the evaluation of a law (s).
        const LAW_PERIOD: f64 = 100e-6;
        let h = self.progress.period();
        if self.law.is_held() {
            return self.plant.advance(t, h, share * self.law.force(0, (0.0, 0.0)));
        }
        let n = (h / LAW_PERIOD).round().clamp(1.0, 100.0);
        let part = h / n;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to 100")]
        for i in 0..n as u32 {
            let at = t + f64::from(i) * part;
            let force = share * self.law.force((at * 1e6).round() as u64, self.plant.measured());
            self.plant.advance(at, part, force);
        }
    }

    /// Returns `true` if no force arrived for 20 ms; the key then accepts none.
    pub const fn is_safe(&self) -> bool {
        !self.interlock.is_armed()
    }

    pub const fn rig(&self) -> &KeyRig {
        self.plant.rig()
    }
}
