//! A source without a host: a piece of a few notes, played on keys that follow their parameters.
//!
//! For looking at the window, and for tests: it is a pure function of the time that it is given,
//! and remembers what it was asked.

mod action;
mod catalogue;
mod machine;
mod replies;
mod score;

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

use telemetry::source::{Mark, Ticket};
use telemetry::{
    Arrival, ConnectionState, Event, KEYS, KeyBlock, Log, Midi, Overview, Request, Source,
    Timeline, Topic, Update, event, log,
};

use crate::{WallClock, names, number};
use action::{DemoAction, DemoEvent, DemoValues};
use catalogue::TICK_HZ;

/// Number of ticks between messages.
const CHUNK: u64 = 32;

/// Most ticks that are caught up: after a long pause the rest is skipped.
const MOST: u64 = 4000;

/// Period of a tick (ns).
const TICK: u64 = 1_000_000_000 / TICK_HZ as u64;

/// Length of the recording (ns).
const LENGTH: u64 = 24_000_000_000;

/// The requests to a [`Demo`], which tests read.
pub type RequestLog = Arc<Mutex<Vec<Request>>>;

/// The time of the demonstration.
enum Time {
    Live,
    /// The time is chosen: its speed, and its place at a time of the clock.
    Recorded {
        speed: f64,
        at: u64,
        since: u64,
        marks: Vec<Mark>,
    },
}

/// A key of the demonstration.
#[derive(Clone, Debug)]
struct DemoKey {
    action: DemoAction,
    instrument: String,
    values: DemoValues,
    revision: u32,
    pressed: f64,
    rows: KeyBlock,
}

/// A source without a host.
pub struct Demo {
    clock: WallClock,
    time: Time,
    began: u64,
    tick: u64,
    keys: Vec<DemoKey>,
    followed: BTreeSet<Topic>,
    queue: VecDeque<Arrival>,
    overview: Overview,
    asked: RequestLog,
    tickets: u64,
    is_stopped: bool,
}

impl fmt::Debug for Demo {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Demo").field("tick", &self.tick).finish_non_exhaustive()
    }
}

impl Demo {
    /// Creates a host that plays from now on.
    pub fn live(clock: WallClock) -> Self {
        Self::new(clock, Time::Live)
    }

    /// Creates a recording of what it would have played.
    pub fn recording(clock: WallClock) -> Self {
        let now = clock();
        let mark = |seconds: u64, text: &str, is_fault| Mark {
            at: now + seconds * 1_000_000_000,
            text: text.to_owned(),
            is_fault,
        };
        let marks = vec![
            mark(2, "F#4: capped", true),
            mark(8, "instrument changed", false),
            mark(14, "tick missed", true),
        ];
        Self::new(clock, Time::Recorded { speed: 1.0, at: now, since: now, marks })
    }

    fn new(clock: WallClock, time: Time) -> Self {
        let began = clock();
        let mut demo = Self {
            clock,
            time,
            began,
            tick: 0,
            keys: Vec::new(),
            followed: BTreeSet::new(),
            queue: VecDeque::new(),
            overview: overview(),
            asked: RequestLog::default(),
            tickets: 0,
            is_stopped: false,
        };
        demo.begin();
        demo
    }

    /// Returns the list of its requests, which goes on being written.
    pub fn asked(&self) -> RequestLog {
        Arc::clone(&self.asked)
    }

    /// Puts all keys at rest and says what there is.
    fn begin(&mut self) {
        let played = |key: u8| DemoKey {
            action: DemoAction::default(),
            instrument: "grand-springs".into(),
            values: catalogue::values("grand-springs", key),
            revision: u32::from(key) + 1,
            pressed: 0.0,
            rows: KeyBlock { key: key.into(), ..KeyBlock::default() },
        };
        self.keys = (0..=names::LAST).map(played).collect();
        self.send(Update::Catalogue(catalogue::catalogue(self.began)));
        for key in 0..=names::LAST {
            self.send_voice(key);
        }
        let text = "The demonstration: nothing here is a real key.".into();
        self.send(Update::Log(Log { level: log::Level::Info.into(), text }));
    }

    /// Says what a key is played by.
    fn send_voice(&mut self, key: u8) {
        let played = &self.keys[usize::from(key)];
        let voice = catalogue::voice(key, played.revision, &played.instrument, &played.values);
        self.send(Update::Voice(voice));
    }

    fn send(&mut self, update: Update) {
        let is_wanted = match update.topic() {
            Some(topic @ (Topic::Block(_) | Topic::State(_))) => self.followed.contains(&topic),
            Some(_) => true,
            None => false,
        };
        if is_wanted {
            let at = self.began + self.tick * TICK;
            self.queue.push_back(Arrival::Update { at, update: Box::new(update) });
        }
    }

    /// Returns the tick that is due.
    fn due(&self) -> u64 {
        let now = (self.clock)();
        let at = match &self.time {
            Time::Live => now,
            Time::Recorded { speed, at, since, .. } => {
                let gone = now.saturating_sub(*since) as f64 * speed;
                (at + number::floor(gone)).min(self.began + LENGTH)
            }
        };
        at.saturating_sub(self.began) / TICK
    }

    /// Plays on until now.
    fn catch_up(&mut self) {
        let due = self.due();
        if self.tick + MOST < due {
            self.tick = due - MOST;
        }
        while self.tick < due {
            self.advance();
            self.tick += 1;
            if self.tick.is_multiple_of(CHUNK) {
                self.send_chunk();
            }
            if self.tick.is_multiple_of(TICK_HZ.into()) {
                self.send(Update::Deadlines(machine::deadlines(self.tick)));
                self.send(Update::Links(machine::links(self.tick)));
            }
        }
    }

    /// Advances all keys by a tick.
    fn advance(&mut self) {
        let pushes = score::pushes(self.tick);
        for key in 0..=names::LAST {
            let played = &mut self.keys[usize::from(key)];
            let push = if self.is_stopped {
                0.0
            } else {
                pushes.get(&key).copied().unwrap_or(0.0) + played.pressed
            };
            if push < 1e-9 && played.action.is_still() {
                continue;
            }
            let events = played.action.advance(&played.values, push, 1.0 / f64::from(TICK_HZ));
            self.enter_row(key);
            for it in events {
                self.send_event(key, it);
            }
        }
        if !self.is_stopped {
            self.send_notes();
        }
        self.send_fault();
    }

    fn enter_row(&mut self, key: u8) {
        let force = self.keys[usize::from(key)].action.force;
        let sent = if self.is_stopped { 0.0 } else { force.clamp(0.0, catalogue::LIMIT) };
        let played = &mut self.keys[usize::from(key)];
        let (action, rows) = (&played.action, &mut played.rows);
        if rows.after.is_empty() {
            rows.tick = self.tick;
        }
        rows.after.push(u32::try_from(self.tick - rows.tick).unwrap_or(u32::MAX));
        rows.position.push(action.key[0]);
        rows.age.push(0);
        rows.taken.push(0.0);
        rows.force.push(action.force);
        rows.sent.push(sent);
        rows.mode.push(action.mode);
        rows.flags.push(0);
        rows.fault.push(0);
        rows.revision.push(played.revision);
        rows.signals.extend(action.signals(&played.values).map(number::f32));
        let (i, position) = (usize::from(key), number::f32(action.key[0]));
        let force = number::f32(sent);
        self.overview.position_min[i] = self.overview.position_min[i].min(position);
        self.overview.position_max[i] = self.overview.position_max[i].max(position);
        self.overview.force_min[i] = self.overview.force_min[i].min(force);
        self.overview.force_max[i] = self.overview.force_max[i].max(force);
        self.overview.mode[i] = action.mode;
        self.overview.flags[i] = 0;
    }

    fn send_event(&mut self, key: u8, what: DemoEvent) {
        let event = Event { tick: self.tick, key: key.into(), ..Event::default() };
        let event = match what {
            DemoEvent::Switch { from, to, theta } => Event {
                kind: event::Kind::Switch.into(),
                theta,
                from: from.into(),
                to: to.into(),
                guard: if to == 1 { "lift" } else { "land" }.into(),
                ..event
            },
            DemoEvent::Strike { speed, theta } => {
                self.send_note(key, speed);
                Event { kind: event::Kind::Strike.into(), theta, speed, ..event }
            }
        };
        self.send(Update::Event(event));
    }

    fn send_note(&mut self, key: u8, speed: f64) {
        let velocity = number::byte(number::f32((30.0 * speed).clamp(1.0, 127.0)));
        let note = key + 21;
        let text = format!("note on {} velocity {velocity}", names::name(key));
        let at = self.tick as f64 / f64::from(TICK_HZ);
        self.send(Update::Midi(Midi { at, bytes: vec![0x90, note, velocity], text }));
    }

    fn send_notes(&mut self) {
        for key in score::released(self.tick) {
            let text = format!("note off {} velocity 40", names::name(key));
            let at = self.tick as f64 / f64::from(TICK_HZ);
            self.send(Update::Midi(Midi { at, bytes: vec![0x80, key + 21, 40], text }));
        }
    }

    /// Sends the fault of F#4, and its recovery.
    fn send_fault(&mut self) {
        const KEY: u8 = 45;
        let kind = match self.tick {
            1500 => event::Kind::Fault,
            6500 => event::Kind::Recovery,
            _ => return,
        };
        let is_fault = kind == event::Kind::Fault;
        self.overview.fault[usize::from(KEY)] = if is_fault { 3 } else { 0 };
        let text = if is_fault { "64 guards fired in one tick" } else { "in time for 5 s" }.into();
        let (tick, key) = (self.tick, KEY.into());
        self.send(Update::Event(Event { kind: kind.into(), tick, key, text, ..Event::default() }));
    }

    fn send_chunk(&mut self) {
        let from = self.tick - CHUNK;
        self.send(Update::Ticks(machine::ticks(from, self.tick)));
        for key in 0..KEYS {
            let rows = &mut self.keys[key].rows;
            let empty = KeyBlock { key: rows.key, ..KeyBlock::default() };
            let block = std::mem::replace(rows, empty);
            if !block.after.is_empty() {
                self.send(Update::Block(block));
            }
        }
        self.overview.tick = self.tick;
        self.overview.ticks = u32::try_from(CHUNK).unwrap_or(0);
        self.send(Update::Overview(self.overview.clone()));
        self.overview.position_min = self.positions();
        self.overview.position_max = self.positions();
        self.overview.force_min = self.forces();
        self.overview.force_max = self.forces();
    }

    fn positions(&self) -> Vec<f32> {
        self.keys.iter().map(|played| number::f32(played.action.key[0])).collect()
    }

    fn forces(&self) -> Vec<f32> {
        self.keys.iter().map(|played| number::f32(played.action.force)).collect()
    }
}

/// Returns an overview of all keys at rest.
fn overview() -> Overview {
    Overview {
        position_min: vec![0.0; KEYS],
        position_max: vec![0.0; KEYS],
        force_min: vec![0.0; KEYS],
        force_max: vec![0.0; KEYS],
        mode: vec![0; KEYS],
        flags: vec![1; KEYS],
        fault: vec![0; KEYS],
        ..Overview::default()
    }
}

impl Source for Demo {
    fn next(&mut self) -> Option<Arrival> {
        if self.queue.is_empty() {
            self.catch_up();
        }
        self.queue.pop_front()
    }

    fn follow(&mut self, topics: &BTreeSet<Topic>) {
        let before = std::mem::replace(&mut self.followed, topics.clone());
        // As a host does: a key that lies still has no rows but the one that says so.
        for topic in topics.difference(&before) {
            if let Topic::Block(key) = topic
                && self.keys.get(usize::from(*key)).is_some_and(|it| it.rows.after.is_empty())
            {
                self.enter_row(*key);
            }
        }
    }

    fn ask(&mut self, request: Request) -> Ticket {
        self.tickets += 1;
        let ticket = Ticket(self.tickets);
        self.asked.lock().unwrap_or_else(PoisonError::into_inner).push(request.clone());
        let result = match self.time {
            Time::Live => self.answer(request),
            Time::Recorded { .. } => Err("A recording cannot be changed.".into()),
        };
        self.queue.push_back(Arrival::Reply { ticket, result });
        ticket
    }

    fn standing(&self) -> ConnectionState {
        match self.time {
            Time::Live => ConnectionState::Live,
            Time::Recorded { .. } => ConnectionState::Recording,
        }
    }

    fn name(&self) -> String {
        match self.time {
            Time::Live => "demonstration".into(),
            Time::Recorded { .. } => "demonstration.mcap".into(),
        }
    }

    fn timeline(&mut self) -> Option<&mut dyn Timeline> {
        match self.time {
            Time::Live => None,
            Time::Recorded { .. } => Some(self),
        }
    }
}

impl Timeline for Demo {
    fn span(&self) -> (u64, u64) {
        (self.began, self.began + LENGTH)
    }

    fn at(&self) -> u64 {
        self.began + self.due() * TICK
    }

    fn seek(&mut self, to: u64) {
        let now = (self.clock)();
        if let Time::Recorded { at, since, .. } = &mut self.time {
            *at = to.clamp(self.began, self.began + LENGTH);
            *since = now;
        }
        self.queue.clear();
        self.queue.push_back(Arrival::Anew);
        self.overview = overview();
        self.tick = self.due().saturating_sub(MOST);
        self.begin();
    }

    fn speed(&self) -> f64 {
        match self.time {
            Time::Live => 1.0,
            Time::Recorded { speed, .. } => speed,
        }
    }

    fn set_speed(&mut self, to: f64) {
        let now = (self.clock)();
        let here = self.began + self.due() * TICK;
        if let Time::Recorded { speed, at, since, .. } = &mut self.time {
            (*speed, *at, *since) = (to, here, now);
        }
    }

    fn marks(&self) -> &[Mark] {
        match &self.time {
            Time::Live => &[],
            Time::Recorded { marks, .. } => marks,
        }
    }
}

/// Forces of fingers by key (N).
type Pushes = BTreeMap<u8, f64>;
