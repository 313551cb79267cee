//! A simulated board: its keys behind one link, as complete as a real one.
//!
//! It computes its motors' forces in each of its own ticks, and sends samples in every n-th one. It
//! answers requests (`requests`), and accepts forces when armed (`force_interlock`), as answers to
//! recent samples (`sample_history`) or with a bus time (`multicast`).

mod bus_time;
mod multicast;
mod requests;
mod sample_history;

use crate::links::{Link, RecvError};
use firmware_protocol::frame::hello::{Hello, Introduction, MAGIC, feature, safe_reason};
use firmware_protocol::frame::key_forces::{ForceLayout, ForcePacking, KeyForces};
use firmware_protocol::frame::key_samples::{KeySamples, SampleLayout, SamplePacking};
use firmware_protocol::frame::{FrameKind, Header, board_of, broadcast::Broadcast};
use firmware_protocol::key::{BoardId, KEYS_PER_BOARD, MOST_KEYS, PerKey};
use firmware_protocol::{
    MAX_FRAME, acyclic::arm::VALID_MS, key, schema, version::PROTOCOL_VERSION,
};
use haptics::plant::{Gesture, HandCommand, KeyRig, RigParameters};
use serde::Serialize;

use self::bus_time::BusTime;
use self::multicast::Groups;
use self::requests::BoardRequestHandler;
use self::sample_history::SampleHistory;
use super::force_interlock::{ForceDecision, ForceInterlock};
use super::force_law::Law;
use super::key::{Plant, SampleProgress};
use crate::calibration::{self, KeyCalibration};
use crate::{Error, clock::low};

const FEATURES: u16 = feature::SLOPES
    | feature::MULTICAST
    | feature::VELOCITY
    | feature::FINGERS
    | feature::LOG
    | feature::HEALTH;

/// Frames to read from the link in one call; the rest waits for the next.
const MAX_FRAMES: usize = 64;

/// Counts of a board.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize)]
pub struct BoardCounts {
    pub samples: u64,
    pub unsent: u64,
    pub forces: u64,
    /// Receptions that were no frame.
    pub corrupt: u64,
    /// Whole frames that were invalid or meant for others.
    pub refused: u64,
    /// Forces that answered no recent samples.
    pub stale: u64,
    pub unarmed: u64,
    /// Samples that the arriving forces skipped.
    pub unanswered: u64,
    pub trips: u64,
    pub armings: u64,
    /// Age of the oldest samples behind a rendered force (us).
    pub oldest_us: u64,
}

/// Description of a simulated board.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BoardMake {
    pub id: BoardId,
    pub first_key: u8,
    /// Number of its keys, `1 ..= 12`.
    pub n_keys: usize,
    /// Its tick (s), in which it computes its motors' forces.
    pub period: f64,
    pub rig: RigParameters,
    /// Reading of its encoders for keys at rest (counts).
    pub offset: i32,
    /// Force of its motors per requested newton (1).
    pub strength: f64,
    pub fake_identity: FakeIdentity,
}

/// Untrue statements of a board about itself; by default none.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct FakeIdentity {
    pub major: Option<u8>,
    pub schema: Option<u64>,
    /// Other keys: the first, and their number.
    pub keys: Option<(u8, u8)>,
    pub uid: Option<[u8; 6]>,
}

impl BoardMake {
    /// Returns a board of the standard compass, in ticks of `period` (s).
    pub fn standard(id: BoardId, period: f64, rig: RigParameters) -> Self {
        let first_key = u8::try_from(id.keys().start).unwrap_or_default();
        let (n_keys, offset, strength) = (KEYS_PER_BOARD, 0, 1.0);
        let fake_identity = FakeIdentity::default();
        Self { id, first_key, n_keys, period, rig, offset, strength, fake_identity }
    }

    /// Returns the unique id, equal for the same number and keys.
    pub const fn uid(&self) -> [u8; 6] {
        [b'S', b'I', b'M', self.id.number(), self.first_key, 0]
    }
}

/// A board with its keys, motors, encoders and clock.
#[derive(Clone, Debug)]
pub struct SimulatedBoard {
    make: BoardMake,
    progress: SampleProgress,
    keys: Vec<Plant>,
    interlock: ForceInterlock,
    requests: BoardRequestHandler,
    pub(super) samples: SampleLayout,
    pub(super) forces: ForceLayout,
    /// Ticks between two sample frames, and ticks left; `None` for no samples.
    every: Option<(u32, u32)>,
    counts: BoardCounts,
    rendered: RenderedForces,
    bus_time: BusTime,
    history: SampleHistory,
    /// Amount by which its clock was set back (us).
    late_us: u64,
    /// Tick at whose start the newest samples were sent.
    reported: Option<u64>,
}

/// Forces that a board renders until newer ones arrive; a new arming clears them.
#[derive(Clone, Debug)]
struct RenderedForces {
    laws: PerKey<Law>,
    groups: Groups,
    /// Number of the last answered sample frame.
    answered: Option<u64>,
}

impl RenderedForces {
    fn none(n_keys: usize) -> Self {
        let laws = PerKey::collect(std::iter::repeat_n(Law::default(), n_keys));
        Self { laws, groups: Groups::default(), answered: None }
    }
}

impl SimulatedBoard {
    /// Returns a board after power-on: it sends no samples and renders no force.
    ///
    /// # Errors
    /// If the period is not above 0 and up to 1 s, or it has too many keys.
    pub fn new(make: BoardMake) -> Result<Self, Error> {
        let keys = usize::from(make.first_key)..usize::from(make.first_key) + make.n_keys;
        if make.n_keys == 0 || MOST_KEYS < make.n_keys || key::KEYS < keys.end {
            return Err(Error::BoardKeys { first: make.first_key, n_keys: make.n_keys });
        }
        Ok(Self {
            make,
            progress: SampleProgress::new(make.period)?,
            keys: (0..make.n_keys).map(|_| Plant::new(make.rig, make.offset)).collect(),
            interlock: ForceInterlock::new(u32::from(make.id.number()) + 1),
            requests: BoardRequestHandler::new(make),
            samples: SampleLayout { packing: SamplePacking::Position24, n_keys: make.n_keys },
            forces: ForceLayout { packing: ForcePacking::Force16, n_keys: make.n_keys },
            every: None,
            counts: BoardCounts::default(),
            rendered: RenderedForces::none(make.n_keys),
            bus_time: BusTime::default(),
            history: SampleHistory::new(),
            late_us: 0,
            reported: None,
        })
    }

    /// Returns the board after a power cycle, with the settings that it keeps.
    ///
    /// # Errors
    /// As [`Self::new`], if its keys would exceed the 88.
    pub fn restarted(&self) -> Result<Self, Error> {
        let mut anew = Self::new(self.requests.next_make(self.make))?;
        anew.requests.keep_settings(&self.requests);
        Ok(anew)
    }

    /// Returns the board as if a host had armed it, with samples in every tick.
    #[must_use]
    pub const fn armed(mut self) -> Self {
        self.every = Some((1, 1));
        self.interlock.force_armed(VALID_MS as u64 * 1_000);
        self
    }

    pub fn play(&mut self, slot: usize, gestures: Vec<Gesture>) {
        if let Some(key) = self.keys.get_mut(slot) {
            key.play(gestures);
        }
    }

    /// Repeats the gestures of its keys with the period `length` (s).
    pub fn repeat_after(&mut self, length: f64) {
        self.keys.iter_mut().for_each(|key| key.repeat_after(length));
    }

    pub fn press(&mut self, slot: usize, hand: HandCommand) {
        if let Some(key) = self.keys.get_mut(slot) {
            key.press(hand);
        }
    }

    /// Receives frames, simulates the ticks up to the start of `tick`, and sends samples when due.
    /// The first call receives none.
    ///
    /// # Real-time
    /// At most 256 ticks and 64 frames; no heap, except for a gesture.
    pub fn advance(&mut self, tick: u64, link: &mut impl Link) {
        let steps = self.progress.go_on(tick);
        if !steps.is_empty() {
            self.listen(self.progress.us(steps.start), link);
        }
        for step in steps {
            self.step(step);
            self.report_if_due(step + 1, link);
        }
        // At the first call, and after ticks that were not made up.
        if self.reported < Some(tick) && self.every.is_some_and(|(every, _)| every == 1) {
            self.report(tick, link);
        }
    }

    pub const fn is_safe(&self) -> bool {
        !self.interlock.is_armed()
    }

    /// Returns the reason why it renders no forces, as in [`safe_reason`].
    pub const fn safe_reason(&self) -> u8 {
        self.interlock.reason()
    }

    /// Leaves the safe state, whatever its reason; the next valid forces are accepted.
    pub fn rearm(&mut self) {
        self.interlock.force_armed(u64::from(VALID_MS) * 1_000);
        self.forget_forces();
    }

    fn forget_forces(&mut self) {
        self.rendered = RenderedForces::none(self.make.n_keys);
    }

    pub fn counts(&self) -> BoardCounts {
        let (trips, armings) = self.interlock.counts();
        BoardCounts { trips: trips.into(), armings: armings.into(), ..self.counts }
    }

    pub const fn make(&self) -> &BoardMake {
        &self.make
    }

    pub fn rig(&self, slot: usize) -> Option<&KeyRig> {
        self.keys.get(slot).map(Plant::rig)
    }

    pub fn calibration(&self) -> impl Iterator<Item = KeyCalibration> {
        self.keys.iter().map(Plant::calibration)
    }

    pub fn introduction(&self) -> Introduction {
        let FakeIdentity { major, schema, keys, uid } = self.make.fake_identity;
        let n_keys = u8::try_from(self.make.n_keys).unwrap_or(u8::MAX);
        let (first_key, n_keys) = keys.unwrap_or((self.make.first_key, n_keys));
        let hello = Hello {
            magic: MAGIC,
            major: major.unwrap_or(PROTOCOL_VERSION.major),
            minor: PROTOCOL_VERSION.minor,
            schema: schema.unwrap_or(schema::HASH),
            uid: uid.unwrap_or_else(|| self.make.uid()),
            first_key,
            n_keys,
            features: FEATURES,
            max_sample_hz: rate(self.make.period),
            max_force_hz: rate(self.make.period),
            law_hz: rate(self.make.period),
            quantum_nm: nanometres(self.make.rig.quantum),
            max_force_mn: self.requests.max_force_mn(),
            config_crc: self.requests.config_crc(),
            board_us: self.clock_us(),
            firmware_major: 1,
            firmware_minor: 0,
            reset_reason: 1,
            safe_reason: self.interlock.reason(),
        };
        Introduction { board: self.make.id, safe: self.is_safe(), hello }
    }

    /// Sets its public clock back by so much (us); it continues by its own.
    pub const fn set_clock_back(&mut self, by_us: u64) {
        self.late_us = self.late_us.saturating_add(by_us);
    }

    /// Returns the whole ticks since its public clock showed this time; at most 65 ms.
    pub(super) fn ticks_since(&self, stamp_us: u16) -> f64 {
        let [low, high, ..] = self.clock_us().to_le_bytes();
        let us = u16::from_le_bytes([low, high]).wrapping_sub(stamp_us);
        (f64::from(us) * 1e-6 / self.make.period).round()
    }

    /// Stops all forces for this reason; only a power cycle clears a failed key or a stop.
    pub fn fail(&mut self, reason: u8) {
        self.interlock.trip(reason, self.now_us());
    }

    fn clock_us(&self) -> u32 {
        low(self.told_us(self.now_us()))
    }

    fn now_us(&self) -> u64 {
        self.progress.now_us()
    }

    /// Returns its public time when its own clock shows `us`.
    const fn told_us(&self, us: u64) -> u64 {
        us.wrapping_sub(self.late_us)
    }

    /// Receives frames, which hold from `from_us` on, the start of the following ticks.
    fn listen(&mut self, from_us: u64, link: &mut impl Link) {
        for _ in 0..MAX_FRAMES {
            let mut frame = [0; MAX_FRAME];
            match link.try_recv(&mut frame) {
                Ok(Some(len)) => self.hear(from_us, &frame[..len.min(MAX_FRAME)], link),
                Err(RecvError::Corrupt | RecvError::BufferTooShort { .. }) => {
                    self.counts.corrupt += 1;
                }
                Ok(None) | Err(RecvError::Down) => return,
            }
        }
    }

    fn hear(&mut self, from_us: u64, frame: &[u8], link: &mut impl Link) {
        let is_mine = board_of(frame) == Some(self.make.id);
        match FrameKind::of(frame) {
            Some(FrameKind::KeyForces) if is_mine => match KeyForces::decode(frame, self.forces) {
                Ok(forces) => self.take(from_us, &forces),
                Err(_why) => self.counts.refused += 1,
            },
            Some(FrameKind::MulticastForces) => self.take_multicast(from_us, frame),
            Some(FrameKind::Request) if is_mine => self.serve(from_us, frame, link),
            Some(FrameKind::Broadcast) => self.obey(from_us, frame, link),
            Some(FrameKind::KeyForces | FrameKind::Request) => {}
            _ => self.counts.refused += 1,
        }
    }

    fn obey(&mut self, from_us: u64, frame: &[u8], link: &mut impl Link) {
        match Broadcast::decode(frame) {
            Ok(Broadcast::EmergencyStop { .. }) => {
                self.interlock.trip(safe_reason::EMERGENCY_STOP, from_us);
            }
            Ok(Broadcast::WhoIsThere { .. }) => {
                let mut bytes = [0; MAX_FRAME];
                let len = self.introduction().encode(&mut bytes);
                self.send(&bytes[..len], link);
            }
            Ok(Broadcast::BusTime { host_us }) => self.bus_time.hear(self.now_us(), host_us),
            Err(_why) => self.counts.refused += 1,
        }
    }

    /// Accepts forces that answer recent samples and are newer than those before.
    fn take(&mut self, now_us: u64, frame: &KeyForces) {
        let Some(sent) = self.history.find(frame.header) else {
            self.counts.stale += 1;
            return;
        };
        if self.rendered.answered.is_some_and(|answered| sent.number < answered) {
            self.counts.stale += 1;
            return;
        }
        match self.interlock.feed(sent.taken_us, now_us) {
            ForceDecision::Stale => self.counts.stale += 1,
            ForceDecision::Unarmed => self.counts.unarmed += 1,
            ForceDecision::Rendered => {
                let passed =
                    self.rendered.answered.map_or(0, |it| sent.number.saturating_sub(it + 1));
                self.counts.unanswered += passed;
                self.counts.forces += 1;
                self.counts.oldest_us =
                    self.counts.oldest_us.max(now_us.saturating_sub(sent.taken_us));
                self.rendered.answered = Some(sent.number);
                for (slot, law) in self.rendered.laws.as_mut_slice().iter_mut().enumerate() {
                    let rig = &self.make.rig;
                    *law = Law::answering(frame, &sent.samples, slot, rig.quantum, sent.taken_us);
                }
            }
        }
    }

    fn step(&mut self, tick: u64) {
        let now_us = self.progress.us(tick);
        let share = self.interlock.share(now_us) * self.make.strength;
        let (t, h) = (self.progress.seconds(tick), self.progress.period());
        let limit = f64::from(self.requests.max_force_mn()) * 1e-3;
        let muted = self.requests.muted();
        for (slot, (key, law)) in
            self.keys.iter_mut().zip(self.rendered.laws.as_slice()).enumerate()
        {
            let share = if muted >> slot & 1 == 0 { share } else { 0.0 };
            key.advance(t, h, share * law.force(now_us, key.measured()).clamp(-limit, limit));
        }
    }

    fn report_if_due(&mut self, tick: u64, link: &mut impl Link) {
        let Some((every, left)) = &mut self.every else { return };
        *left = left.saturating_sub(1);
        if *left == 0 {
            *left = *every;
            self.report(tick, link);
        }
    }

    fn report(&mut self, tick: u64, link: &mut impl Link) {
        self.reported = Some(tick);
        let taken_us = self.progress.us(tick);
        let [low, high, ..] = self.told_us(taken_us).to_le_bytes();
        let header = Header {
            board: self.make.id,
            sequence: self.history.next_sequence(),
            stamp_us: u16::from_le_bytes([low, high]),
            flag: self.is_safe(),
        };
        let mut samples = KeySamples {
            header,
            positions: PerKey::collect(self.keys.iter().map(Plant::counts)),
            velocities: PerKey::default(),
        };
        if self.samples.packing.has_velocity() {
            let speeds = self.keys.iter().map(|key| calibration::speed(key.rig().velocity()));
            samples.velocities = PerKey::collect(speeds);
        }
        self.history.push(samples, taken_us);
        let mut bytes = [0; MAX_FRAME];
        let len = samples.encode(self.samples.packing, &mut bytes);
        if link.try_send(&bytes[..len]).is_ok() {
            self.counts.samples += 1;
        } else {
            self.counts.unsent += 1;
        }
    }

    fn send(&mut self, frame: &[u8], link: &mut impl Link) {
        self.counts.unsent += u64::from(link.try_send(frame).is_err());
    }
}

/// Returns the rate of a period (s), in units of the hello (1/s).
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
fn rate(period: f64) -> u16 {
    (1.0 / period).round() as u16
}

/// Returns a quantum (m), in units of the hello (nm).
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
fn nanometres(quantum: f64) -> u32 {
    (quantum * 1e9).round() as u32
}
