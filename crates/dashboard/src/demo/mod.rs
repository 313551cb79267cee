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
use action::{DemoAction, DemoValues, Happened};
use catalogue::TICK_HZ;

/// Ticks between messages.
const CHUNK: u64 = 32;

/// Ticks that are made at most before somebody looks: after a long pause the rest is skipped.
const MOST: u64 = 4000;

/// Nanoseconds of a tick.
const TICK: u64 = 1_000_000_000 / TICK_HZ as u64;

/// How long the recording is (ns).
const LENGTH: u64 = 24_000_000_000;

/// What a [`Demo`] was asked, for those who gave it away.
pub type RequestLog = Arc<Mutex<Vec<Request>>>;

/// Where the time comes from.
enum Time {
    Live,
    /// It is chosen: seconds that go by in one, and where it was at which time of the clock.
    Recorded {
        speed: f64,
        at: u64,
        since: u64,
        marks: Vec<Mark>,
    },
}

/// One key.
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
    /// A host that is playing, since now.
    pub fn live(clock: WallClock) -> Self {
        Self::new(clock, Time::Live)
    }

    /// A recording of what it would have played.
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

    /// What it was asked so far; the list goes on being written.
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
        self.tell(Update::Catalogue(catalogue::catalogue(self.began)));
        for key in 0..=names::LAST {
            self.tell_voice(key);
        }
        let text = "The demonstration: nothing here is a real key.".into();
        self.tell(Update::Log(Log { level: log::Level::Info.into(), text }));
    }

    /// Says what a key is played by.
    fn tell_voice(&mut self, key: u8) {
        let played = &self.keys[usize::from(key)];
        let voice = catalogue::voice(key, played.revision, &played.instrument, &played.values);
        self.tell(Update::Voice(voice));
    }

    fn tell(&mut self, update: Update) {
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

    /// The tick that is due.
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
                self.tell_chunk();
            }
            if self.tick.is_multiple_of(TICK_HZ.into()) {
                self.tell(Update::Deadlines(machine::deadlines(self.tick)));
                self.tell(Update::Links(machine::links(self.tick)));
            }
        }
    }

    /// One tick of all keys.
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
            let happened = played.action.advance(&played.values, push, 1.0 / f64::from(TICK_HZ));
            self.enter_row(key);
            for it in happened {
                self.tell_happened(key, it);
            }
        }
        if !self.is_stopped {
            self.tell_notes();
        }
        self.tell_fault();
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

    fn tell_happened(&mut self, key: u8, happened: Happened) {
        let event = Event { tick: self.tick, key: key.into(), ..Event::default() };
        let event = match happened {
            Happened::Switch { from, to, theta } => Event {
                kind: event::Kind::Switch.into(),
                theta,
                from: from.into(),
                to: to.into(),
                guard: if to == 1 { "lift" } else { "land" }.into(),
                ..event
            },
            Happened::Strike { speed, theta } => {
                self.tell_note(key, speed);
                Event { kind: event::Kind::Strike.into(), theta, speed, ..event }
            }
        };
        self.tell(Update::Event(event));
    }

    fn tell_note(&mut self, key: u8, speed: f64) {
        let velocity = number::byte(number::f32((30.0 * speed).clamp(1.0, 127.0)));
        let note = key + 21;
        let text = format!("note on {} velocity {velocity}", names::name(key));
        let at = self.tick as f64 / f64::from(TICK_HZ);
        self.tell(Update::Midi(Midi { at, bytes: vec![0x90, note, velocity], text }));
    }

    fn tell_notes(&mut self) {
        for key in score::released(self.tick) {
            let text = format!("note off {} velocity 40", names::name(key));
            let at = self.tick as f64 / f64::from(TICK_HZ);
            self.tell(Update::Midi(Midi { at, bytes: vec![0x80, key + 21, 40], text }));
        }
    }

    /// F#4 cannot be trusted for a while.
    fn tell_fault(&mut self) {
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
        self.tell(Update::Event(Event { kind: kind.into(), tick, key, text, ..Event::default() }));
    }

    fn tell_chunk(&mut self) {
        let from = self.tick - CHUNK;
        self.tell(Update::Ticks(machine::ticks(from, self.tick)));
        for key in 0..KEYS {
            let rows = &mut self.keys[key].rows;
            let empty = KeyBlock { key: rows.key, ..KeyBlock::default() };
            let block = std::mem::replace(rows, empty);
            if !block.after.is_empty() {
                self.tell(Update::Block(block));
            }
        }
        self.overview.tick = self.tick;
        self.overview.ticks = u32::try_from(CHUNK).unwrap_or(0);
        self.tell(Update::Overview(self.overview.clone()));
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

/// All keys at rest.
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

/// Pushes by key (N).
type Pushes = BTreeMap<u8, f64>;
