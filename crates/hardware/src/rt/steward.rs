//! What goes on with every board beside the cyclic frames: it is brought up, kept armed,
//! asked for its time and its counts, and its simulated fingers are moved.
//!
//! ```text
//! Greeting ─ hello ─▶ Streaming ─ done ─▶ Disarming ─ nonce ─▶ Arming ─ done ─▶ Confirming ─▶ Armed
//!    ▲                                                                              │           │
//!    └── it fell silent, started anew, or renders no force and did not say why ◀────┴───────────┘
//! ```
//!
//! A board that tripped over silence is armed again. One that was stopped, or whose key
//! failed, stays as it is until somebody has seen to it.
//!
//! A board that says that it is armed is believed when samples come that can be read and say so
//! too. One that does not get there in five attempts is left alone for ten seconds, or until it
//! says hello anew. One whose clock runs too fast or too slow is disarmed until it starts anew.

use firmware_protocol::acyclic::arm::{Arm, Disarmed};
use firmware_protocol::acyclic::counters::Counters;
use firmware_protocol::acyclic::finger::{self, Finger};
use firmware_protocol::acyclic::light::Light;
use firmware_protocol::acyclic::ping::Pong;
use firmware_protocol::acyclic::stream::Stream;
use firmware_protocol::acyclic::{Operation, Status};
use firmware_protocol::frame::FrameKind;
use firmware_protocol::frame::hello::{Hello, Introduction, safe_reason};
use firmware_protocol::{Nothing, Record as _, schema};
use haptics::plant::{Gesture, Touch};

use super::board::BoardStatistics;
use super::bus::{Acyclic, KeybedBus};
use super::glance::BoardStatus;
use super::trips::Trips;
use crate::clock::{ClockModel, ClockUpdate};
use crate::courier::{ReceivedReply, RequestChannel};
use crate::keybed::Terms;
use crate::topology::BoardPlace;

/// Round trips at the start, to learn a board's clock from.
const QUICK_PINGS: u32 = 8;
/// Round trips after which they are no quicker for a clock that is not known yet: on a machine
/// that is slow because it is busy, more of them would keep it so, and those that are farther
/// apart tell a rate better.
const MOST_QUICK_PINGS: u32 = 32;

/// Time between two of them, and between more until the clock's rate is known (us).
const QUICK_PING_US: u64 = 10_000;
/// Time between two round trips afterwards (us).
const PING_US: u64 = 50_000;
/// Time between two looks at a board's counts (us).
const COUNTERS_US: u64 = 1_000_000;
/// How long before its time a gesture is handed over (us).
const AHEAD_US: u64 = 1_000_000;
/// Time after which an attempt to bring a board up is made again (us).
const AGAIN_US: u64 = 100_000;
/// A board that renders no force for so long though it was armed has tripped (us).
const FLAGGED_US: u64 = 5_000;
/// How long a light shows which board it is on (s).
pub const LIGHT_S: u8 = 10;
/// A board that sent nothing for so long is gone (us).
const SILENT_US: u64 = 100_000;
/// A board that was armed for a shorter time than this is not armed again at once (us).
const SHORT_US: u64 = 1_000_000;
/// Attempts to arm a board until it is left alone.
const MOST_ATTEMPTS: u8 = 5;
/// For so long (us).
const LEFT_ALONE_US: u64 = 10_000_000;

/// What is agreed with one board.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Agreed {
    pub place: BoardPlace,
    pub uid: [u8; 6],
    /// When in the period it begins to send (us).
    pub phase_us: u16,
    pub terms: Terms,
}

/// How far a board has been brought up.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ArmState {
    /// It is asked who it is.
    Greeting,
    /// It is asked for samples.
    Streaming,
    /// It is asked for a nonce.
    Disarming,
    /// It is told to render forces.
    Arming {
        nonce: u32,
    },
    /// It says that it renders forces; samples that say so too are waited for.
    Confirming,
    Armed,
    /// It may not be armed: somebody has to see to it.
    Barred(ArmLockout),
}

/// Why a board may not be armed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ArmLockout {
    /// It renders no force, for this reason.
    Latched(u8),
    /// It answered this to that.
    Declined(Operation, Status),
    /// Another board has taken its place, or its firmware was changed.
    Exchanged,
    /// Its clock runs too fast by so much (1e-6), more than is accepted.
    Clock(i32),
    /// It said that it was armed, and sent no samples.
    NoSamples,
    /// It said that it was armed, and sent samples that cannot be read.
    Unreadable,
    /// It said that it was armed, and its samples that it renders no force.
    StaysSafe,
}

impl ArmLockout {
    /// Whether it is tried again after a while.
    const fn ends(self) -> bool {
        match self {
            Self::Declined(..) | Self::NoSamples | Self::Unreadable | Self::StaysSafe => true,
            Self::Latched(_) | Self::Exchanged | Self::Clock(_) => false,
        }
    }
}

/// The care of one board.
#[derive(Clone, Debug)]
struct BoardSession {
    agreed: Agreed,
    courier: RequestChannel,
    stage: ArmState,
    clock: ClockModel,
    trips: Trips,
    counters: Option<Counters>,
    /// Times that it was armed.
    armings: u64,
    /// Times that its clock jumped.
    jumps: u64,
    /// Not before then is it asked again (us).
    rest_until: u64,
    n_pings: u32,
    next_ping: u64,
    next_counters: u64,
    /// Requests beside that it declined.
    declined: u64,
    /// It has started anew, and its numbers with it.
    is_anew: bool,
    /// When its samples were last seen without the flag, and seen at all (us).
    clear: u64,
    heard: u64,
    frames: u64,
    /// Since when it is armed, or said so (us), and how many frames had been refused by then.
    since: u64,
    refused: u64,
    /// Attempts to arm it since it was armed last.
    attempts: u8,
    /// Until when it is left alone after too many (us).
    barred_until: u64,
    /// It shall be told to let go of all forces.
    lets_go: bool,
    fingers: GestureQueue,
    /// It shall show its light.
    is_sought: bool,
}

/// Gestures that wait to be handed over, in the order of their starts.
#[derive(Clone, Debug, Default)]
struct GestureQueue {
    gestures: Vec<(u8, Gesture)>,
    next: usize,
}

/// What a board is like, for reports.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Condition {
    /// How far it has been brought up.
    pub stage: ArmState,
    /// Times that it was armed.
    pub armings: u64,
    /// Times that its clock jumped.
    pub jumps: u64,
    /// Its drift (1e-6).
    pub drift_ppm: f64,
    /// Median, 99th hundredth and longest of the last round trips (us).
    pub round_trips_us: Option<[u32; 3]>,
    /// What it has counted itself, a second ago at most.
    pub counters: Option<Counters>,
    /// Requests that it declined while it was armed.
    pub declined: u64,
}

/// The care of all boards.
#[derive(Clone, Debug)]
pub struct BoardSupervisor {
    charges: Vec<BoardSession>,
    now: u64,
    /// Host time of the performance's beginning (us).
    origin: Option<u64>,
}

impl BoardSupervisor {
    /// Cares for boards in the order in which the bus has them; `now` (us).
    pub fn new(agreed: Vec<Agreed>, now: u64) -> Self {
        let charges = agreed.into_iter().map(|agreed| BoardSession::new(agreed, now)).collect();
        Self { charges, now, origin: None }
    }

    /// Hands these gestures over to the key in `slot` of a board in time, from `origin` (us) on.
    ///
    /// Not for the tick.
    pub fn play(&mut self, board: usize, slot: u8, gestures: &[Gesture]) {
        let Some(charge) = self.charges.get_mut(board) else { return };
        let fingers = &mut charge.fingers;
        fingers.gestures.extend(gestures.iter().map(|gesture| (slot, *gesture)));
        fingers.gestures.sort_by(|one, other| one.1.start.total_cmp(&other.1.start));
    }

    /// From when on gestures count (us).
    pub const fn begin_at(&mut self, origin: u64) {
        self.origin = Some(origin);
    }

    /// What time it was when it was last looked at (us).
    pub const fn now(&self) -> u64 {
        self.now
    }

    /// Takes what time it is (us).
    pub const fn set_now(&mut self, now: u64) {
        self.now = now;
    }

    /// Looks after the boards on `line`, and sends what is to be sent.
    ///
    /// # Real-time
    /// At most one frame for each board; no heap.
    pub fn attend(
        &mut self,
        line: usize,
        bus: &mut KeybedBus,
        link: &mut (impl links::Link + ?Sized),
    ) {
        let (now, origin) = (self.now, self.origin);
        let charges = self.charges.iter_mut().enumerate();
        for (board, charge) in charges.filter(|(_, it)| it.agreed.place.line == line) {
            charge.watch(now, board, bus);
            let is_lost = charge.courier.gave_up(now);
            // One that is barred goes on waiting for somebody, who will want to see its light.
            if is_lost && !matches!(charge.stage, ArmState::Barred(_)) {
                charge.greet(now + AGAIN_US);
            }
            if charge.courier.is_free() && charge.rest_until <= now {
                charge.go_on(now, origin);
            }
            let Some(frame) = charge.courier.due(now) else { continue };
            // What the link does not take is asked again.
            if link.try_send(frame).is_ok() {
                bus.saw_sent(line, frame.len());
            }
        }
    }

    /// Whether every board renders forces and its clock is known.
    pub fn is_ready(&self) -> bool {
        self.charges.iter().all(BoardSession::is_ready)
    }

    /// Whether this one does.
    pub fn is_board_ready(&self, board: usize) -> bool {
        self.charges.get(board).is_some_and(BoardSession::is_ready)
    }

    /// Whether a board renders forces now.
    pub fn renders(&self, board: usize) -> bool {
        self.charges.get(board).is_some_and(|it| it.stage == ArmState::Armed)
    }

    /// Whether there is nothing to wait for: every board is ready, or may not be armed.
    pub fn is_settled(&self) -> bool {
        self.charges.iter().all(|it| it.is_ready() || matches!(it.stage, ArmState::Barred(_)))
    }

    /// Whether a board was stopped or has failed, and somebody has to see to it.
    pub fn is_latched(&self, board: usize) -> bool {
        let stage = self.charges.get(board).map(|it| it.stage);
        matches!(stage, Some(ArmState::Barred(ArmLockout::Latched(_))))
    }

    /// How long before the host's `at_us` the samples with this stamp were taken by a board (us).
    pub fn age_us(&self, board: usize, at_us: u64, stamp_us: u16) -> Option<i32> {
        self.charges.get(board)?.clock.age_us(at_us, stamp_us)
    }

    /// Lets a board show its light, as soon as it listens.
    pub fn light(&mut self, board: usize) {
        if let Some(charge) = self.charges.get_mut(board) {
            charge.is_sought = true;
        }
    }

    /// How a board is looked after.
    ///
    /// # Real-time
    /// Sorts 15 numbers; no heap.
    pub fn care(&self, board: usize) -> Option<BoardStatus> {
        let it = self.charges.get(board)?;
        let round_trip_us = it.trips.recent();
        Some(BoardStatus { stage: it.stage, armings: it.armings, round_trip_us })
    }

    /// What a board is like.
    ///
    /// Not for the tick.
    pub fn condition(&self, board: usize) -> Option<Condition> {
        let it = self.charges.get(board)?;
        Some(Condition {
            stage: it.stage,
            armings: it.armings,
            jumps: it.jumps,
            drift_ppm: it.clock.drift_ppm(),
            round_trips_us: it.trips.quantiles(),
            counters: it.counters,
            declined: it.declined,
        })
    }

    /// Times that a board was armed, if it is now.
    pub fn armings(&self, board: usize) -> Option<u64> {
        let charge = self.charges.get(board)?;
        (charge.stage == ArmState::Armed).then_some(charge.armings)
    }

    /// Which operation a board has been asked for as long as it is brought up.
    pub fn asked(&self, board: usize) -> Option<Operation> {
        Some(match self.charges.get(board)?.stage {
            ArmState::Greeting => Operation::Hello,
            ArmState::Streaming => Operation::Stream,
            ArmState::Disarming => Operation::Disarm,
            ArmState::Arming { .. } => Operation::Arm,
            ArmState::Confirming | ArmState::Armed => Operation::Ping,
            ArmState::Barred(_) => return None,
        })
    }
}

impl Acyclic for BoardSupervisor {
    fn hear(&mut self, line: usize, frame: &[u8]) {
        let board = firmware_protocol::frame::board_of(frame);
        let is_it = |it: &&mut BoardSession| {
            it.agreed.place.line == line && Some(it.agreed.place.board) == board
        };
        let Some(charge) = self.charges.iter_mut().find(is_it) else { return };
        if FrameKind::of(frame) == Some(FrameKind::Hello) {
            charge.was_introduced(frame, self.now);
        } else if let Some(heard) = charge.courier.hear(frame) {
            charge.was_answered(&heard, self.now);
        }
    }
}

impl BoardSession {
    fn new(agreed: Agreed, now: u64) -> Self {
        // Another host's last request may have had any number.
        let [first, ..] = now.to_le_bytes();
        Self {
            courier: RequestChannel::new(agreed.place.board, first),
            agreed,
            stage: ArmState::Greeting,
            clock: ClockModel::default(),
            trips: Trips::default(),
            counters: None,
            armings: 0,
            jumps: 0,
            rest_until: 0,
            n_pings: 0,
            next_ping: 0,
            next_counters: 0,
            declined: 0,
            is_anew: false,
            clear: now,
            heard: now,
            frames: 0,
            since: now,
            refused: 0,
            attempts: 0,
            barred_until: 0,
            lets_go: false,
            fingers: GestureQueue::default(),
            is_sought: false,
        }
    }

    /// Whether it renders forces and its clock is known.
    fn is_ready(&self) -> bool {
        self.stage == ArmState::Armed && QUICK_PINGS <= self.n_pings && self.clock.is_known()
    }

    /// Begins to bring the board up, not before `rest_until` (us).
    const fn greet(&mut self, rest_until: u64) {
        self.stage = ArmState::Greeting;
        self.rest_until = rest_until;
    }

    /// Looks whether an armed board is still there and renders forces.
    fn watch(&mut self, now: u64, board: usize, bus: &mut KeybedBus) {
        if std::mem::take(&mut self.is_anew) {
            bus.forget(board);
            bus.unmute(board);
        }
        let statistics = bus.statistics(board);
        let frames = statistics.samples.frames;
        if frames != self.frames {
            (self.frames, self.heard) = (frames, now);
            if !statistics.is_safe {
                self.clear = now;
            }
        }
        if matches!(self.stage, ArmState::Confirming | ArmState::Armed)
            && self.clock.is_beyond_tolerance()
        {
            self.bar(ArmLockout::Clock(millionths(self.clock.drift_ppm())), now);
            self.lets_go = true;
        } else if self.stage == ArmState::Confirming {
            self.confirm(now, &statistics);
        } else if matches!(self.stage, ArmState::Arming { .. }) {
            self.refused = statistics.refused;
        } else if self.stage == ArmState::Armed {
            let is_silent = self.heard + SILENT_US < now;
            let is_flagged = self.clear + FLAGGED_US < self.heard;
            if is_silent {
                // Its numbers may begin anew.
                bus.forget(board);
            }
            if is_silent || is_flagged {
                self.greet(self.next_attempt(now));
            }
        } else if matches!(self.stage, ArmState::Barred(bar) if bar.ends())
            && self.barred_until <= now
        {
            self.attempts = MOST_ATTEMPTS - 1;
            self.greet(now);
        }
    }

    /// When a board that renders no force any more may be armed again: at once if it did for long.
    const fn next_attempt(&self, now: u64) -> u64 {
        if self.since + SHORT_US <= now { now } else { now + AGAIN_US }
    }

    /// Looks whether a board that says that it is armed sends samples that say so too.
    fn confirm(&mut self, now: u64, statistics: &BoardStatistics) {
        if self.heard == now && !statistics.is_safe {
            self.stage = ArmState::Armed;
            self.armings += 1;
            (self.since, self.attempts) = (now, 0);
        } else if self.since + SILENT_US < now {
            let why = if self.since < self.heard {
                ArmLockout::StaysSafe
            } else if self.refused < statistics.refused {
                ArmLockout::Unreadable
            } else {
                ArmLockout::NoSamples
            };
            self.has_failed(why, now);
        }
    }

    /// Ends an attempt to arm the board: there is another one, unless there were too many.
    const fn has_failed(&mut self, why: ArmLockout, now: u64) {
        if self.attempts < MOST_ATTEMPTS {
            self.greet(now + AGAIN_US);
        } else {
            self.bar(why, now);
        }
    }

    /// Arms the board no more, for some time or for good.
    const fn bar(&mut self, why: ArmLockout, now: u64) {
        self.stage = ArmState::Barred(why);
        self.barred_until = now + LEFT_ALONE_US;
    }

    /// Asks what comes next.
    fn go_on(&mut self, now: u64, origin: Option<u64>) {
        if std::mem::take(&mut self.lets_go) {
            self.courier.ask(Operation::Disarm, &Nothing);
            return;
        }
        let terms = self.agreed.terms;
        match self.stage {
            ArmState::Greeting => self.courier.ask(Operation::Hello, &Nothing),
            ArmState::Streaming => {
                let (period_us, phase_us) = (terms.period_us, self.agreed.phase_us);
                let packing = terms.samples as u8;
                self.courier.ask(Operation::Stream, &Stream { period_us, packing, phase_us });
            }
            ArmState::Disarming => self.courier.ask(Operation::Disarm, &Nothing),
            ArmState::Arming { nonce } => {
                let (packing, valid_ms) = (terms.forces as u8, terms.valid_ms);
                self.courier.ask(Operation::Arm, &Arm { nonce, packing, valid_ms });
            }
            ArmState::Armed | ArmState::Barred(_) if self.is_sought => {
                self.is_sought = false;
                self.courier.ask(Operation::Light, &Light { seconds: LIGHT_S });
            }
            ArmState::Armed => self.run_errands(now, origin),
            ArmState::Confirming | ArmState::Barred(_) => {}
        }
    }

    /// What an armed board is asked beside.
    fn run_errands(&mut self, now: u64, origin: Option<u64>) {
        if self.next_ping <= now {
            let quick = self.n_pings < QUICK_PINGS
                || (self.n_pings < MOST_QUICK_PINGS && !self.clock.is_known());
            self.next_ping = now + if quick { QUICK_PING_US } else { PING_US };
            self.courier.ask(Operation::Ping, &Nothing);
        } else if let Some(finger) = self.next_finger(now, origin) {
            self.courier.ask(Operation::Finger, &finger);
        } else if self.next_counters <= now {
            self.next_counters = now + COUNTERS_US;
            self.courier.ask(Operation::Counters, &Nothing);
        }
    }

    /// The next gesture, if its time is near and the board's time is known.
    fn next_finger(&self, now: u64, origin: Option<u64>) -> Option<Finger> {
        let origin = origin?;
        let &(slot, gesture) = self.fingers.gestures.get(self.fingers.next)?;
        let at = |seconds: f64| origin + microseconds(seconds);
        if now + AHEAD_US < at(gesture.start) {
            return None;
        }
        // A hand that never lifts would outlast the board's clock.
        let release = gesture.release.min(gesture.start + 1_800.0);
        Some(Finger {
            slot,
            touch: match gesture.touch {
                Touch::Pressed => finger::PRESSED,
                Touch::Struck => finger::STRUCK,
            },
            start_us: self.clock.board_us(at(gesture.start))?,
            release_us: self.clock.board_us(at(release))?,
            speed: short(gesture.speed * 1e6),
            hold: short(gesture.hold * 1e6),
        })
    }

    /// Hears a hello that nobody asked for here: the board may have started anew.
    fn was_introduced(&mut self, frame: &[u8], now: u64) {
        let Ok(it) = Introduction::decode(frame) else { return };
        if it.hello.uid == self.agreed.uid && it.hello.safe_reason == safe_reason::NEVER_ARMED {
            let is_clock_to_blame = matches!(self.stage, ArmState::Barred(ArmLockout::Clock(_)));
            self.clock =
                if is_clock_to_blame { ClockModel::default() } else { self.clock.set_anew() };
            (self.n_pings, self.is_anew, self.attempts) = (0, true, 0);
            self.greet(now);
        }
    }

    /// Hears an answer, and goes on.
    fn was_answered(&mut self, heard: &ReceivedReply<'_>, now: u64) {
        let ReceivedReply { reply, operation, sent_us } = *heard;
        if reply.status != Status::Done {
            self.was_declined(operation, reply.status, now);
            return;
        }
        match (operation, self.stage) {
            (Operation::Hello, ArmState::Greeting) => {
                self.stage = Hello::take(reply.record)
                    .map_or(ArmState::Greeting, |hello| next_stage(&hello, &self.agreed));
            }
            (Operation::Stream, ArmState::Streaming) => self.attempt(),
            (Operation::Disarm, ArmState::Disarming) => {
                if let Some(Disarmed { nonce }) = Disarmed::take(reply.record) {
                    self.stage = ArmState::Arming { nonce };
                }
            }
            (Operation::Arm, ArmState::Arming { .. }) => {
                (self.stage, self.since) = (ArmState::Confirming, now);
            }
            (Operation::Ping, _) => {
                if let Some(Pong { board_us }) = Pong::take(reply.record) {
                    self.was_timed(sent_us, board_us, now);
                }
            }
            // One that was never answered is handed over again.
            (Operation::Finger, _) => self.fingers.next += 1,
            (Operation::Counters, _) => self.counters = Counters::take(reply.record),
            _ => {}
        }
    }

    /// Begins to arm the board.
    const fn attempt(&mut self) {
        self.stage = ArmState::Disarming;
        self.attempts = self.attempts.saturating_add(1);
    }

    /// Hears that the board does not do what it was asked.
    fn was_declined(&mut self, operation: Operation, status: Status, now: u64) {
        if matches!(self.stage, ArmState::Barred(_)) {
            self.declined += 1;
            return;
        }
        let declined = ArmLockout::Declined(operation, status);
        let nonce_is_old = status == Status::WrongNonce
            || operation == Operation::Arm && status == Status::WrongState;
        let brings_up = matches!(
            operation,
            Operation::Hello | Operation::Stream | Operation::Disarm | Operation::Arm
        );
        if operation == Operation::Disarm && status == Status::WrongState {
            // It was stopped, or has failed, since it said hello: the next one says which.
            self.has_failed(declined, now);
        } else if brings_up && nonce_is_old && self.attempts < MOST_ATTEMPTS {
            self.attempt();
        } else if brings_up {
            self.bar(declined, now);
        } else if operation == Operation::Finger && status == Status::WrongState {
            // As many gestures wait there as it can hold: again, a little later.
            self.rest_until = now + AGAIN_US;
        } else {
            self.declined += 1;
            self.fingers.next += usize::from(operation == Operation::Finger);
        }
    }

    /// Learns from a round trip, if its request was sent once only.
    fn was_timed(&mut self, sent_us: Option<u64>, board_us: u32, now: u64) {
        let Some(sent_us) = sent_us else { return };
        self.trips.push(now.saturating_sub(sent_us));
        match self.clock.learn(sent_us, board_us, now) {
            ClockUpdate::News => self.n_pings = self.n_pings.saturating_add(1),
            ClockUpdate::Jumped => {
                self.jumps += 1;
                self.n_pings = 0;
            }
        }
    }
}

/// What follows a hello: whether the board may be armed.
fn next_stage(hello: &Hello, agreed: &Agreed) -> ArmState {
    let is_same = hello.uid == agreed.uid && hello.schema == schema::HASH;
    if !is_same {
        return ArmState::Barred(ArmLockout::Exchanged);
    }
    match hello.safe_reason {
        latched @ (safe_reason::EMERGENCY_STOP | safe_reason::KEY_FAULT) => {
            ArmState::Barred(ArmLockout::Latched(latched))
        }
        _ => ArmState::Streaming,
    }
}

/// Whole microseconds in a time that is not negative (s).
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
fn microseconds(seconds: f64) -> u64 {
    (seconds * 1e6).round() as u64
}

/// Whole millionths.
#[expect(clippy::cast_possible_truncation, reason = "saturates")]
const fn millionths(ppm: f64) -> i32 {
    ppm.round() as i32
}

/// A value of the wire.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
fn short(value: f64) -> u32 {
    value.round() as u32
}
