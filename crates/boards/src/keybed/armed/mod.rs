//! Armed boards as the tick's bus.

mod proof;
mod refusals;

use crate::links::Link as _;
use firmware_protocol::frame::broadcast::{self, Broadcast};
use firmware_protocol::{Nothing, acyclic::Operation, acyclic::stream::Stream, key::KeyIndex};
use haptics::plant::Gesture;
use rtrb::{Consumer, Producer, RingBuffer};
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::KeyBus;

use super::{Keybed, NamedLink};
use crate::plan::{Medium, MeterWindow};
use crate::refusal::BoardName;
use crate::request_channel::RequestChannel;
use crate::rt::board::{BoardEnd, BoardStatistics, BoardTerms};
use crate::rt::board_supervisor::{BoardSupervisor, Condition};
use crate::rt::bus::{KeybedBus, LineStatistics};
use crate::rt::lateness::Lateness;
use crate::rt::link_monitor::{LinkMonitor, LinkSample};
use crate::rt::link_snapshot::{BoardSnapshot, LinkSnapshot};
use crate::topology::BoardPlace;

/// Time in which forces grow once a board renders them, and fade once it does not (us).
const FADE_US: u64 = 20_000;

const MOST_IDENTIFY_REQUESTS: usize = 32;

/// Boards that render forces.
#[derive(Debug)]
pub struct Armed {
    bus: Box<KeybedBus>,
    supervisor: BoardSupervisor,
    names: Vec<BoardName>,
    period_us: u64,
    /// Frames from and to each board before the run.
    before: Vec<(u64, u64)>,
    since_us: u64,
    lateness: Vec<Lateness>,
    /// Due time of tick 0, but for a constant (us).
    first_us: Option<u64>,
    monitor: Option<LinkMonitor>,
    /// `true` if models play, and their keys are guarded.
    is_guarded: bool,
    identify: Option<Consumer<usize>>,
}

/// State of one board.
#[derive(Clone, PartialEq, Debug)]
pub struct BoardReport {
    pub name: BoardName,
    pub place: BoardPlace,
    /// `true` if its keys were measured, so that their calibration is not only its own claim.
    pub is_calibrated: bool,
    pub statistics: BoardStatistics,
    /// Frames of samples and of forces since the start.
    pub exchanged: (u64, u64),
    pub condition: Condition,
}

/// State of one line.
#[derive(Clone, PartialEq, Debug)]
pub struct LineReport {
    pub name: String,
    pub statistics: LineStatistics,
    pub medium: Option<Medium>,
    pub load: Option<MeterWindow>,
    pub fault: Option<String>,
}

impl Armed {
    pub(super) fn new(
        bus: KeybedBus,
        supervisor: BoardSupervisor,
        names: Vec<BoardName>,
        period_us: u64,
    ) -> Self {
        let before = vec![(0, 0); names.len()];
        let since_us = supervisor.now();
        let lateness = vec![Lateness::default(); names.len()];
        let mut bus = Box::new(bus);
        let fade_ticks = FADE_US / period_us.max(1);
        bus.fade_over(u32::try_from(fade_ticks).unwrap_or(u32::MAX));
        Self {
            bus,
            supervisor,
            names,
            period_us,
            before,
            since_us,
            lateness,
            first_us: None,
            monitor: None,
            is_guarded: false,
            identify: None,
        }
    }

    fn snapshot(
        bus: &KeybedBus,
        supervisor: &BoardSupervisor,
        place: usize,
    ) -> Option<LinkSnapshot> {
        let snapshot = bus.snapshot(place)?;
        Some(match snapshot {
            LinkSnapshot::Line(..) => snapshot,
            LinkSnapshot::Board(board, it) => {
                let status = supervisor.status(board);
                LinkSnapshot::Board(board, BoardSnapshot { status, ..it })
            }
        })
    }

    /// Dates the samples of this tick by their board's clock.
    fn date(&mut self, tick: u64) {
        let period_us = self.period_us.max(1);
        let passed_us = tick.saturating_mul(period_us);
        // The ticks are regular; the wake-up of this thread is not, and must not move a sample.
        let first_us = self.supervisor.now().saturating_sub(passed_us);
        let due_us = *self.first_us.get_or_insert(first_us) + passed_us;
        for (board, lateness) in self.lateness.iter_mut().enumerate() {
            let newest = self.bus.boards().get(board).and_then(BoardEnd::newest);
            let Some(newest) = newest.filter(|_| self.bus.has_news(board)) else { continue };
            let stamp_us = newest.header.stamp_us;
            let Some(age_us) = self.supervisor.age_us(board, due_us, stamp_us) else { continue };
            lateness.learn(age_us, period_us);
            self.supervisor.take_age(board, age_us, period_us);
            if let Some(usual_us) = lateness.usual_us() {
                self.supervisor.watch_lateness(board, usual_us);
            }
            self.bus.date(board, lateness.of(age_us) / period_us as f64);
        }
    }
}

/// Ages a sample by its unusual delay: zero within the usual delay and a tick or two.
fn outdate(sample: &mut KeySample) {
    /// Ticks beyond the usual that a sample may be late.
    const MOST_LATE: f64 = 2.0;
    if MOST_LATE <= sample.taken {
        sample.age = sample.age.max(whole(sample.taken));
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
const fn whole(ticks: f64) -> u32 {
    ticks as u32
}

impl Keybed<Armed> {
    /// Processes received frames and sends requests to boards, without forces.
    pub fn attend(&mut self) {
        let Self { lines, stage: Armed { bus, supervisor, is_guarded, .. }, clock } = self;
        supervisor.set_now(clock.now_us());
        for (index, NamedLink { link, .. }) in lines.iter_mut().enumerate() {
            if index < bus.n_lines() {
                bus.receive(index, link, supervisor);
                supervisor.attend(index, bus, link);
            }
        }
        for board in 0..bus.boards().len() {
            // Measurements without a model need no stable loop.
            let share = match supervisor.armings(board) {
                Some(_) if !*is_guarded => 1.0,
                _ => supervisor.share(board),
            };
            bus.limit_share(board, share);
        }
    }

    /// Returns the state of the line or board at `place`, lines first; `None` behind the last.
    ///
    /// # Real-time
    /// Copies, and sorts 15 numbers; no heap.
    pub fn snapshot(&self, place: usize) -> Option<LinkSnapshot> {
        Armed::snapshot(&self.stage.bus, &self.stage.supervisor, place)
    }

    /// Returns a ring of link snapshots, one per second of ticks at `tick_hz`; not for the tick.
    pub fn monitor(&mut self, tick_hz: u32) -> Consumer<LinkSample> {
        let (monitor, samples) = LinkMonitor::new(tick_hz);
        self.stage.monitor = Some(monitor);
        samples
    }

    /// Returns the sender of requests for lights, by index among all boards; not for the tick.
    pub fn identify_requests(&mut self) -> Producer<usize> {
        let (requests, identify) = RingBuffer::new(MOST_IDENTIFY_REQUESTS);
        self.stage.identify = Some(identify);
        requests
    }

    pub fn request_light(&mut self, board: usize) {
        self.stage.supervisor.request_light(board);
    }

    pub fn is_ready(&self) -> bool {
        self.stage.supervisor.is_ready()
    }

    pub(super) fn is_settled(&self) -> bool {
        self.stage.supervisor.is_settled()
    }

    /// Plays `gestures` on `key`, in time from [`Self::begin_at`] on.
    pub fn play(&mut self, key: KeyIndex, gestures: &[Gesture]) {
        let Armed { bus, supervisor, .. } = &mut self.stage;
        for (index, board) in bus.boards().iter().enumerate() {
            let keys = board.terms().place.keys();
            if keys.contains(&key.index())
                && let Ok(slot) = u8::try_from(key.index() - keys.start)
            {
                supervisor.play(index, slot, gestures);
            }
        }
    }

    /// Repeats all gestures, each pass `length` (s) after the one before.
    pub fn repeat_after(&mut self, length: f64) {
        self.stage.supervisor.repeat_after(length);
    }

    /// Returns the newest sample of every key, with its age since arrival.
    pub const fn newest(&self) -> &[KeySample; KEYS] {
        self.stage.bus.samples()
    }

    pub fn terms(&self) -> impl Iterator<Item = &BoardTerms> {
        self.stage.bus.boards().iter().map(BoardEnd::terms)
    }

    pub const fn period_us(&self) -> u64 {
        self.stage.period_us
    }

    /// Returns how often the board of `key` was armed, if it renders forces.
    pub fn armings(&self, key: KeyIndex) -> Option<u64> {
        let has = |it: &BoardTerms| it.place.keys().contains(&key.index());
        self.stage.supervisor.armings(self.terms().position(has)?)
    }

    /// Sets the host time from which gestures and frames count (us); discards earlier input.
    pub fn begin_at(&mut self, origin_us: u64) {
        self.stage.supervisor.begin_at(origin_us);
        self.attend();
        self.forget_exchanges();
    }

    fn forget_exchanges(&mut self) {
        let Armed { bus, before, .. } = &mut self.stage;
        for (before, board) in before.iter_mut().zip(bus.boards()) {
            *before = exchanged(&board.statistics());
        }
    }

    /// Stops all boards until an operator restarts them; returns the number of accepted stops. The
    /// others are safe when their forces expire.
    pub fn stop(&mut self, reason: u8) -> usize {
        let mut frame = [0; broadcast::MAX_LEN];
        let len = Broadcast::EmergencyStop { reason }.encode(&mut frame);
        let Self { lines, stage: Armed { bus, .. }, .. } = self;
        let mut told = 0;
        for (index, line) in lines.iter_mut().enumerate() {
            if line.link.try_send(&frame[..len]).is_ok() {
                let boards = bus.boards().iter().map(|board| board.terms().place);
                told += boards.filter(|place| place.line == index).count();
            }
        }
        told
    }

    /// Ends forces and samples of all boards without waiting; skips stopped and failed boards.
    pub fn disarm(&mut self) {
        let Armed { bus, supervisor, .. } = &self.stage;
        let boards = bus.boards().iter().enumerate();
        for (_, board) in boards.filter(|(index, _)| !supervisor.is_latched(*index)) {
            let place = board.terms().place;
            // Differs from the number of any pending request.
            let [first, ..] = self.now_us().to_le_bytes();
            let mut channel = RequestChannel::new(place.board, first ^ 0x80);
            channel.ask(Operation::Disarm, &Nothing);
            if let Some(frame) = channel.due(0) {
                // A board that misses it is safe when its forces expire.
                let _lost = self.lines[place.line].link.try_send(frame);
            }
            channel.ask(Operation::Stream, &Stream { period_us: 0, packing: 0, phase_us: 0 });
            if let Some(frame) = channel.due(0) {
                // A board that misses it sends to no host, which is harmless.
                let _lost = self.lines[place.line].link.try_send(frame);
            }
        }
    }

    pub fn board_reports(&self) -> Vec<BoardReport> {
        let Armed { bus, supervisor, names, .. } = &self.stage;
        let reports = bus.boards().iter().zip(names).enumerate().map(|(index, (board, name))| {
            let (came, went) = exchanged(&board.statistics());
            let (before, already) = self.stage.before.get(index).copied().unwrap_or_default();
            Some(BoardReport {
                name: name.clone(),
                place: board.terms().place,
                is_calibrated: board.terms().is_calibrated(),
                statistics: board.statistics(),
                exchanged: (came - before, went - already),
                condition: supervisor.condition(index)?,
            })
        });
        reports.flatten().collect()
    }

    pub fn line_reports(&self) -> Vec<LineReport> {
        let Armed { bus, supervisor, since_us, .. } = &self.stage;
        let seconds = supervisor.now().saturating_sub(*since_us) as f64 * 1e-6;
        let lines = self.lines.iter().enumerate();
        let report = |(index, line): (usize, &NamedLink)| LineReport {
            name: line.name.clone(),
            statistics: bus.line(index),
            medium: line.medium,
            load: bus.load(index, seconds).filter(|_| 0.0 < seconds),
            fault: line.link.fault().map(ToString::to_string),
        };
        lines.map(report).collect()
    }
}

const fn exchanged(statistics: &BoardStatistics) -> (u64, u64) {
    (statistics.samples.frames, statistics.sent)
}

impl KeyBus for Keybed<Armed> {
    /// # Real-time
    /// At most 128 frames and one request for each board; no heap.
    fn receive(&mut self, tick: u64, samples: &mut [KeySample; KEYS]) {
        if let Some(Ok(board)) = self.stage.identify.as_mut().map(Consumer::pop) {
            self.request_light(board);
        }
        self.stage.bus.begin(tick);
        self.attend();
        self.stage.date(tick);
        samples.copy_from_slice(self.stage.bus.samples());
        samples.iter_mut().for_each(outdate);
        let Armed { bus, supervisor, monitor, .. } = &mut self.stage;
        if let Some(monitor) = monitor {
            monitor.take(tick, |place| Armed::snapshot(bus, supervisor, place));
        }
    }

    /// # Real-time
    /// One frame for each board; no heap.
    fn send(&mut self, _tick: u64, forces: &[f64; KEYS], slopes: &[KeySlope; KEYS]) {
        let now_us = self.now_us();
        let Self { lines, stage: Armed { bus, .. }, .. } = self;
        for (index, NamedLink { link, .. }) in lines.iter_mut().enumerate() {
            if index < bus.n_lines() {
                bus.send(index, now_us, forces, slopes, link);
            }
        }
    }
}
