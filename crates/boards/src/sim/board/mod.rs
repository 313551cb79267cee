//! A simulated board: its keys behind one link, complete as a real one.
//!
//! It lives in ticks of its own, at each of which its motors' forces are worked out; every so
//! many it sends samples. It answers requests (`requests`), takes forces only when it
//! is armed (`force_interlock.rs`) and only as answers to what it has just sent (`history.rs`) or with a
//! time of the bus (`multicast.rs`).

mod bus_time;
mod multicast;
mod requests;
mod sample_history;

use crate::links::{Link, RecvError};
use firmware_protocol::MAX_FRAME;
use firmware_protocol::acyclic::arm::VALID_MS;
use firmware_protocol::frame::broadcast::Broadcast;
use firmware_protocol::frame::hello::{Hello, Introduction, MAGIC, feature, safe_reason};
use firmware_protocol::frame::key_forces::{ForceLayout, ForcePacking, KeyForces};
use firmware_protocol::frame::key_samples::{KeySamples, SampleLayout, SamplePacking};
use firmware_protocol::frame::{FrameKind, Header, board_of};
use firmware_protocol::key::{BoardId, KEYS_PER_BOARD, MOST_KEYS, PerKey};
use firmware_protocol::version::PROTOCOL_VERSION;
use firmware_protocol::{key, schema};
use haptics::plant::{Gesture, HandCommand, KeyRig, RigParameters};
use serde::Serialize;

use self::bus_time::BusTime;
use self::multicast::Groups;
use self::requests::BoardRequestHandler;
use self::sample_history::SampleHistory;
use super::force_interlock::{ForceDecision, ForceInterlock};
use super::force_law::Law;
use super::key::{Plant, SampleProgress};
use crate::Error;
use crate::calibration::{self, KeyCalibration};
use crate::clock::low;

/// What a simulated board can.
const FEATURES: u16 = feature::SLOPES
    | feature::MULTICAST
    | feature::VELOCITY
    | feature::FINGERS
    | feature::LOG
    | feature::HEALTH;

/// Frames taken from the link in one call; the rest waits for the next.
const MAX_FRAMES: usize = 64;

/// What a board has counted.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize)]
pub struct BoardCounts {
    /// Frames of samples that the link took.
    pub samples: u64,
    /// Sample frames that the link did not take.
    pub unsent: u64,
    /// Frames of forces that were rendered.
    pub forces: u64,
    /// What came and was no frame.
    pub corrupt: u64,
    /// Whole frames that were not for this board, or not to be understood.
    pub refused: u64,
    /// Forces that answered nothing recent.
    pub stale: u64,
    /// Forces that came while it was not armed.
    pub unarmed: u64,
    /// Samples that were passed over by the forces that came.
    pub unanswered: u64,
    /// Times that forces expired.
    pub trips: u64,
    /// Times that it was armed.
    pub armings: u64,
    /// Oldest samples that forces which were rendered answered (us).
    pub oldest_us: u64,
}

/// What a simulated board is.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BoardMake {
    /// Its number on its link.
    pub id: BoardId,
    pub first_key: u8,
    /// Its keys, `1 ..= 12`.
    pub n_keys: usize,
    /// Its tick (s): how often it works out its motors' forces.
    pub period: f64,
    /// What its keys are made of.
    pub rig: RigParameters,
    /// What its encoders read when keys are at rest (counts).
    pub offset: i32,
    /// Force of its motors for a newton that is asked for (1).
    pub strength: f64,
    /// What it says of itself that is not true.
    pub fake_identity: FakeIdentity,
}

/// What a board says of itself that is not true; by default nothing.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct FakeIdentity {
    /// Another major version of the protocol.
    pub major: Option<u8>,
    /// Another hash of the cyclic layouts.
    pub schema: Option<u64>,
    /// Other keys: the first, and how many.
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

    /// Returns who the board is: the same for the same number and keys.
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
    /// Ticks between two frames of samples, and how many are left; none for no samples.
    every: Option<(u32, u32)>,
    counts: BoardCounts,
    rendered: RenderedForces,
    bus_time: BusTime,
    history: SampleHistory,
    /// How much its clock was set back (us).
    late_us: u64,
    /// The tick at whose start the newest samples were sent.
    reported: Option<u64>,
}

/// Forces that a board renders until newer ones come; none of it outlasts a new arming.
#[derive(Clone, Debug)]
struct RenderedForces {
    laws: PerKey<Law>,
    groups: Groups,
    /// Which frame of samples was answered last.
    answered: Option<u64>,
}

impl RenderedForces {
    fn none(n_keys: usize) -> Self {
        let laws = PerKey::collect(std::iter::repeat_n(Law::default(), n_keys));
        Self { laws, groups: Groups::default(), answered: None }
    }
}

impl SimulatedBoard {
    /// Returns a board that was just switched on: it sends nothing and renders nothing.
    ///
    /// # Errors
    /// Refuses a period that is not above 0 and up to 1 s, and more keys than a board has.
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

    /// Returns the board as it is after its power was gone, with the settings that it keeps.
    ///
    /// # Errors
    /// As [`Self::new`], if its keys would go beyond the 88.
    pub fn restarted(&self) -> Result<Self, Error> {
        let mut anew = Self::new(self.requests.next_make(self.make))?;
        anew.requests.keep_settings(&self.requests);
        Ok(anew)
    }

    /// Returns the same as if a host had asked for samples in every tick and armed it.
    #[must_use]
    pub const fn armed(mut self) -> Self {
        self.every = Some((1, 1));
        self.interlock.force_armed(VALID_MS as u64 * 1_000);
        self
    }

    /// Plays `gestures` on the key in `slot` from now on instead of those before.
    pub fn play(&mut self, slot: usize, gestures: Vec<Gesture>) {
        if let Some(key) = self.keys.get_mut(slot) {
            key.play(gestures);
        }
    }

    /// Plays the gestures of its keys again and again, each pass `length` (s) after the one before.
    pub fn repeat_after(&mut self, length: f64) {
        self.keys.iter_mut().for_each(|key| key.repeat_after(length));
    }

    /// Lets a hand press on the key in `slot` or grip it from now on.
    pub fn press(&mut self, slot: usize, hand: HandCommand) {
        if let Some(key) = self.keys.get_mut(slot) {
            key.press(hand);
        }
    }

    /// Takes what has come, and lives through the ticks up to the start of `tick`; says where
    /// its keys are whenever that is due.
    ///
    /// The first call takes nothing.
    ///
    /// # Real-time
    /// At most 256 ticks and 64 frames; no heap, unless a gesture comes.
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

    /// Tells whether it renders no forces, for whatever reason.
    pub const fn is_safe(&self) -> bool {
        !self.interlock.is_armed()
    }

    /// Returns why it renders no forces, as in [`safe_reason`].
    pub const fn safe_reason(&self) -> u8 {
        self.interlock.reason()
    }

    /// Leaves the safe state without force, whatever brought it there; the next valid forces are
    /// taken again.
    pub fn rearm(&mut self) {
        self.interlock.force_armed(u64::from(VALID_MS) * 1_000);
        self.forget_forces();
    }

    /// Lets go of all forces.
    fn forget_forces(&mut self) {
        self.rendered = RenderedForces::none(self.make.n_keys);
    }

    /// Returns what the board has counted.
    pub fn counts(&self) -> BoardCounts {
        let (trips, armings) = self.interlock.counts();
        BoardCounts { trips: trips.into(), armings: armings.into(), ..self.counts }
    }

    /// Returns what the board is made of.
    pub const fn make(&self) -> &BoardMake {
        &self.make
    }

    /// Returns the plant in `slot`, with what no sensor tells.
    pub fn rig(&self, slot: usize) -> Option<&KeyRig> {
        self.keys.get(slot).map(Plant::rig)
    }

    /// Returns how the encoders of this board read.
    pub fn calibration(&self) -> impl Iterator<Item = KeyCalibration> {
        self.keys.iter().map(Plant::calibration)
    }

    /// Returns the hello that the board says.
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

    /// Sets the clock that it tells others back by so much (us); it goes on living by its own.
    pub const fn set_clock_back(&mut self, by_us: u64) {
        self.late_us = self.late_us.saturating_add(by_us);
    }

    /// Returns the ticks that have passed since it showed others this time, whole; at most 65 ms.
    pub(super) fn ticks_since(&self, stamp_us: u16) -> f64 {
        let [low, high, ..] = self.clock_us().to_le_bytes();
        let us = u16::from_le_bytes([low, high]).wrapping_sub(stamp_us);
        (f64::from(us) * 1e-6 / self.make.period).round()
    }

    /// Lets the board render no force, for this reason; a failed key or a stop it forgets only
    /// without power.
    pub fn fail(&mut self, reason: u8) {
        self.interlock.trip(reason, self.now_us());
    }

    /// Returns its clock now (us), as requests see it.
    fn clock_us(&self) -> u32 {
        low(self.told_us(self.now_us()))
    }

    /// Returns its clock now (us).
    fn now_us(&self) -> u64 {
        self.progress.now_us()
    }

    /// Returns what it tells others when its own clock shows `us`.
    const fn told_us(&self, us: u64) -> u64 {
        us.wrapping_sub(self.late_us)
    }

    /// Takes what has come; it holds from `from_us` on, the start of the ticks that follow,
    /// however late that is by the clock.
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

    /// Takes a frame that came.
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

    /// Does what was said to all boards.
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

    /// Takes forces that answer something recent, and nothing older than those before.
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

    /// Advances the keys over `tick`.
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

    /// Sends samples if their time has come.
    fn report_if_due(&mut self, tick: u64, link: &mut impl Link) {
        let Some((every, left)) = &mut self.every else { return };
        *left = left.saturating_sub(1);
        if *left == 0 {
            *left = *every;
            self.report(tick, link);
        }
    }

    /// Sends where the keys are at the start of `tick`.
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

    /// Sends a frame that is not cyclic.
    fn send(&mut self, frame: &[u8], link: &mut impl Link) {
        self.counts.unsent += u64::from(link.try_send(frame).is_err());
    }
}

/// Returns the rate of a period (s), as a hello says it (1/s).
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
fn rate(period: f64) -> u16 {
    (1.0 / period).round() as u16
}

/// Returns a quantum (m), as a hello says it (nm).
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
fn nanometres(quantum: f64) -> u32 {
    (quantum * 1e9).round() as u32
}
