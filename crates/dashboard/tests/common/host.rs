//! The recorded take behind a window, as a live host that answers or as a recording.

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::sync::{Arc, Mutex, PoisonError};

use dashboard::WallClock;
use telemetry::recording::Playback;
use telemetry::request::Change;
use telemetry::source::{Mark, Ticket};
use telemetry::{
    Arrival, Board, ConnectionState, Deadlines, Event, Line, Links, Overview, Reply, Request,
    Source, Spread, Ticks, Timeline, Topic, Update, Voice, event,
};

use super::{BEGAN, Behind};

pub(crate) type RequestLog = Arc<Mutex<Vec<Request>>>;

/// F#4, which fails at [`FAULT_TICK`].
const FAULTY: u8 = 45;
const FAULT_TICK: u64 = 600;

const GONE: &str = "the connection was lost before the host answered";

/// The recorded take. As a host it also has a machine that is sometimes late, boards on two lines,
/// a key that fails, and answers to requests; a run in virtual time has none of these.
#[derive(Debug)]
pub(crate) struct TakeHost {
    playback: Playback,
    behind: Behind,
    scripted: VecDeque<Arrival>,
    voices: BTreeMap<u32, Voice>,
    asked: RequestLog,
    tickets: u64,
    is_faulty: bool,
    is_gone: bool,
    marks: Vec<Mark>,
}

impl TakeHost {
    pub(crate) fn new(clock: WallClock, behind: Behind) -> Self {
        let seconds = Box::new(move || (clock() - BEGAN) as f64 * 1e-9);
        let playback = dashboard::demonstration(seconds).expect("a take of this version");
        let mark = |at: u64, text: &str, is_fault| Mark { at, text: text.to_owned(), is_fault };
        Self {
            playback,
            behind,
            scripted: VecDeque::new(),
            voices: BTreeMap::new(),
            asked: RequestLog::default(),
            tickets: 0,
            is_faulty: false,
            is_gone: false,
            // Those of the take are gathered on a thread of their own.
            marks: vec![
                mark(1_000_000_000, "F#4: fault", true),
                mark(2_000_000_000, "F#4 recovered", false),
                mark(3_000_000_000, "late", true),
            ],
        }
    }

    pub(crate) fn asked(&self) -> RequestLog {
        Arc::clone(&self.asked)
    }

    fn send(&mut self, at: u64, update: Update) {
        self.scripted.push_back(Arrival::Update { at, update: Box::new(update) });
    }

    fn script(&mut self, at: u64, update: &mut Update) {
        match update {
            Update::Voice(voice) => {
                self.voices.insert(voice.key, voice.clone());
            }
            Update::Overview(overview) => self.script_fault(at, overview),
            Update::Ticks(ticks) => {
                retime(ticks);
                self.send(at, Update::Deadlines(deadlines(ticks.tick)));
            }
            Update::Links(it) => *it = links(),
            Update::Catalogue(_)
            | Update::Block(_)
            | Update::State(..)
            | Update::Event(_)
            | Update::Deadlines(_)
            | Update::Midi(_)
            | Update::Log(_)
            | Update::Status(_) => {}
        }
    }

    fn script_fault(&mut self, at: u64, overview: &mut Overview) {
        if overview.tick < FAULT_TICK {
            return;
        }
        overview.fault[usize::from(FAULTY)] = 3;
        if !std::mem::replace(&mut self.is_faulty, true) {
            let kind = event::Kind::Fault.into();
            let text = "64 guards fired in one tick".into();
            let event =
                Event { kind, tick: FAULT_TICK, key: FAULTY.into(), text, ..Event::default() };
            self.send(at, Update::Event(event));
        }
    }

    fn answer(&mut self, request: &Request) -> Result<Reply, String> {
        let done = |text: &str| Ok(Reply::Done { text: text.to_owned() });
        match request {
            Request::Set { changes } => {
                for change in changes {
                    self.set(change);
                }
                done("Values changed.")
            }
            Request::Stop {} if matches!(self.behind, Behind::Vanishing) => {
                self.is_gone = true;
                Err(GONE.to_owned())
            }
            Request::Stop {} => {
                Ok(Reply::Stopped { text: "No force on any key.".to_owned(), told: 8, boards: 8 })
            }
            Request::Identify { line, board } => {
                let text = format!("board {board} of line {line} shows its light");
                let kind = event::Kind::Board.into();
                self.send(BEGAN, Update::Event(Event { kind, key: 255, text, ..Event::default() }));
                done("It shows its light.")
            }
            Request::Scene {} => {
                Ok(Reply::Scene { toml: "title = \"Demonstration\"\n".to_owned() })
            }
            Request::UseInstrument { .. }
            | Request::Render { .. }
            | Request::Load { .. }
            | Request::Press { .. }
            | Request::FollowBase { .. }
            | Request::SaveInstrument { .. }
            | Request::Margin { .. }
            | Request::Figures { .. }
            | Request::Grip { .. }
            | Request::Where {}
            | Request::Status {}
            | Request::Record { .. } => done("Done."),
        }
    }

    fn set(&mut self, change: &Change) {
        let Ok(Some(catalogue)) = self.playback.recording().catalogue() else { return };
        let Some(voice) = self.voices.get_mut(&change.key.into()) else { return };
        let model = catalogue.models.iter().find(|it| it.name == voice.model);
        let parameters = model.map_or(&[][..], |it| &it.parameters);
        if let Some(i) = parameters.iter().position(|it| it.name == change.parameter) {
            voice.values[i] = change.value;
            voice.revision += 88;
            let voice = voice.clone();
            self.send(BEGAN, Update::Voice(voice));
        }
    }
}

impl Source for TakeHost {
    fn next(&mut self) -> Option<Arrival> {
        if let Some(arrival) = self.scripted.pop_front() {
            return Some(arrival);
        }
        let is_beginning = Timeline::at(self) == self.span().0;
        match (self.playback.next()?, self.behind) {
            (Arrival::Update { at, mut update }, Behind::Live | Behind::Vanishing) => {
                if is_beginning && matches!(*update, Update::Block(_)) {
                    // A host sends the first rows a few ticks later.
                    return self.next();
                }
                let at = BEGAN + at;
                self.script(at, &mut update);
                Some(Arrival::Update { at, update })
            }
            (arrival, _) => Some(arrival),
        }
    }

    fn follow(&mut self, topics: &BTreeSet<Topic>) {
        self.playback.follow(topics);
    }

    fn ask(&mut self, request: Request) -> Ticket {
        self.asked.lock().unwrap_or_else(PoisonError::into_inner).push(request.clone());
        if matches!(self.behind, Behind::Recording) {
            return self.playback.ask(request);
        }
        self.tickets += 1;
        let (ticket, result) = (Ticket(self.tickets), self.answer(&request));
        self.scripted.push_back(Arrival::Reply { ticket, result });
        ticket
    }

    fn standing(&self) -> ConnectionState {
        match self.behind {
            Behind::Recording => ConnectionState::Recording,
            Behind::Live | Behind::Vanishing if self.is_gone => {
                ConnectionState::Lost("the host ended the connection".to_owned())
            }
            Behind::Live | Behind::Vanishing => ConnectionState::Live,
        }
    }

    fn name(&self) -> String {
        self.playback.name()
    }

    fn timeline(&mut self) -> Option<&mut dyn Timeline> {
        matches!(self.behind, Behind::Recording).then_some(self)
    }
}

impl Timeline for TakeHost {
    fn span(&self) -> (u64, u64) {
        self.playback.span()
    }

    fn at(&self) -> u64 {
        Timeline::at(&self.playback)
    }

    fn seek(&mut self, at: u64) {
        self.playback.seek(at);
    }

    fn speed(&self) -> f64 {
        self.playback.speed()
    }

    fn set_speed(&mut self, speed: f64) {
        self.playback.set_speed(speed);
    }

    fn marks(&self) -> &[Mark] {
        &self.marks
    }
}

fn retime(it: &mut Ticks) {
    let ticks: Vec<_> = it.after.iter().map(|after| it.tick + u64::from(*after)).collect();
    let each = |f: &dyn Fn(u64) -> f32| ticks.iter().map(|tick| f(*tick)).collect();
    it.work = each(&|tick| 90.0 + (tick % 41) as f32);
    it.turnaround = each(&|tick| 96.0 + (tick % 41) as f32);
    it.lateness = each(&|tick| {
        if tick == FAULT_TICK { 900.0 } else { 8.0 + (tick % 13) as f32 }
    });
    it.outcome = ticks.iter().map(|tick| u8::from(*tick == FAULT_TICK)).collect();
}

fn spread(middle: f64, width: f64) -> Spread {
    let edge = (1..=24).map(|i| f64::from(i) * width).collect();
    let count = (1..=24_u64).map(|i| 1000 / (1 + i.abs_diff(9)).pow(3)).collect();
    let (p99, p999) = (middle + 4.5 * width, middle + 7.0 * width);
    Spread { p50: middle, p99, p999, max: middle + 16.0 * width, edge, count }
}

fn deadlines(ticks: u64) -> Deadlines {
    Deadlines {
        ticks,
        missed: 2,
        own_work: 1,
        woken_late: 1,
        preempted: 0,
        skipped: 0,
        lateness: Some(spread(15.0, 4.0)),
        turnaround: Some(spread(116.0, 12.0)),
        work: Some(spread(110.0, 12.0)),
        baseline: Some(spread(12.0, 4.0)),
    }
}

/// Returns eight boards on two lines. A USB device takes any rate, so its load is unknown.
fn links() -> Links {
    let line = |name: &str, planned: f64| Line {
        name: name.into(),
        planned,
        seen: planned,
        state: "active".into(),
        ..Line::default()
    };
    let board = |id: u32| Board {
        line: id / 4,
        id,
        first_key: 11 * id,
        keys: 11,
        samples: 1000,
        armings: 1,
        round_trip: 180.0 + f64::from(id),
        state: "armed".into(),
        ..Board::default()
    };
    Links {
        lines: vec![line("can0", 0.62), line("/dev/ttyACM0", f64::NAN)],
        boards: (0..8).map(board).collect(),
    }
}
