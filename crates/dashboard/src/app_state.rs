//! Shared state of all panels: the source, its arrivals, and the selection.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};
use telemetry::source::Ticket;
use telemetry::{Arrival, ConnectionState, Log, Reply, Request, Source, Topic, Update, log};

use crate::names::LAST;
use crate::scope::Scope;
use crate::store::Store;
use crate::tune::Tuner;
use crate::{WallClock, names};

/// Most arrivals taken before each frame, so that a flood does not stop the window.
const MOST: usize = 20_000;

/// Purpose of a request, which decides where its answer is shown.
#[derive(Clone, PartialEq, Eq, Debug)]
enum Purpose {
    Tune,
    Other,
    Stop,
    Identify { line: u32, board: u32 },
}

/// State of a stop that this window asked for.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum StopState {
    /// The host has not answered since then (ns since 1970).
    Asked { at: u64 },
    /// No key has a force: boards reached of all boards, if the host states that, and its sentence.
    Confirmed { told: Option<(u32, u32)>, text: String },
    /// Keys may have forces; the sentence explains why that is unknown.
    Unconfirmed(String),
}

impl StopState {
    fn of(result: Result<Reply, String>) -> Self {
        match result {
            Ok(Reply::Stopped { told, boards, text }) if boards <= told => {
                Self::Confirmed { told: Some((told, boards)), text }
            }
            Ok(Reply::Stopped { told, boards, text: _ }) => {
                Self::Unconfirmed(format!("boards told: {told} of {boards}"))
            }
            Ok(Reply::Done { text }) => Self::Confirmed { told: None, text },
            Ok(Reply::Scene { .. } | Reply::Where { .. } | Reply::Status { .. }) => {
                Self::Unconfirmed("the host said something else".to_owned())
            }
            Err(text) => Self::Unconfirmed(text),
        }
    }
}

/// State of a request for a board's light.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum LightState {
    Asked,
    /// Sentence that the host answered.
    Answered(Result<String, String>),
}

/// Display state shared by all panels.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct SharedView {
    /// The selected key, which is in `range`.
    pub(crate) selected: u8,
    /// Lowest and highest key of the selected range.
    pub(crate) range: (u8, u8),
    pub(crate) scopes: BTreeMap<u8, Scope>,
    /// Time at which the display is frozen (s).
    #[serde(skip)]
    pub(crate) frozen: Option<f64>,
    /// Text of a scene or a preset to be written to a file.
    #[serde(skip)]
    pub(crate) scene: Option<String>,
    /// The last answer, in a sentence.
    #[serde(skip)]
    pub(crate) notice: Option<Result<String, String>>,
    /// Path of a running recording, if this window began it.
    #[serde(skip)]
    pub(crate) recording: Option<String>,
    #[serde(skip)]
    pub(crate) shows_help: bool,
}

/// Shared state of all panels.
pub(crate) struct AppState {
    pub(crate) source: Box<dyn Source>,
    pub(crate) clock: WallClock,
    pub(crate) store: Store,
    pub(crate) tuner: Tuner,
    pub(crate) view: SharedView,
    pub(crate) stop: Option<StopState>,
    /// States of boards' lights by line and board.
    lights: BTreeMap<(u32, u32), LightState>,
    asked: BTreeMap<Ticket, Purpose>,
    followed: BTreeSet<Topic>,
    /// Keys whose rows are drawn in this frame.
    wanted: BTreeSet<u8>,
}

impl AppState {
    pub(crate) fn new(source: Box<dyn Source>, clock: WallClock) -> Self {
        let view = SharedView { selected: 39, range: (39, 39), ..SharedView::default() };
        Self {
            source,
            clock,
            store: Store::default(),
            tuner: Tuner::default(),
            view,
            stop: None,
            lights: BTreeMap::new(),
            asked: BTreeMap::new(),
            followed: BTreeSet::new(),
            wanted: BTreeSet::new(),
        }
    }

    /// Takes the arrivals since the last frame.
    pub(crate) fn take(&mut self) {
        for _ in 0..MOST {
            let Some(arrival) = self.source.next() else { break };
            match arrival {
                Arrival::Update { at, update } => {
                    self.tuner.take(&update);
                    self.store.take(at, *update);
                }
                Arrival::Reply { ticket, result } => self.take_reply(ticket, result),
                Arrival::Anew => self.start_anew(),
            }
        }
        let (store, view) = (&self.store, &mut self.view);
        for scope in view.scopes.values_mut() {
            scope.update(store, scope.key.unwrap_or(view.selected));
        }
    }

    fn start_anew(&mut self) {
        self.store.forget();
        self.tuner.forget();
        self.view.frozen = None;
        self.lights.clear();
        self.asked.clear();
        self.stop = match self.stop.take() {
            // Another run begins, which was not stopped.
            None | Some(StopState::Confirmed { .. }) => None,
            Some(StopState::Asked { .. }) => {
                Some(StopState::Unconfirmed("the host was reached anew meanwhile".to_owned()))
            }
            Some(unconfirmed @ StopState::Unconfirmed(_)) => Some(unconfirmed),
        };
    }

    fn take_reply(&mut self, ticket: Ticket, result: Result<Reply, String>) {
        let purpose = self.asked.remove(&ticket);
        if purpose == Some(Purpose::Stop) {
            // A stop is shown apart, and a second one that fails revokes nothing.
            if !matches!(self.stop, Some(StopState::Confirmed { .. })) {
                self.stop = Some(StopState::of(result));
            }
            return;
        }
        if purpose == Some(Purpose::Tune) {
            self.tuner.answered(ticket, result.as_ref().map(|_| ()).map_err(String::as_str));
        }
        if let Some(Purpose::Identify { line, board }) = purpose {
            self.lights.insert((line, board), LightState::Answered(sentence(&result)));
        }
        let is_tuned = purpose == Some(Purpose::Tune) && result.is_ok();
        self.view.notice = match result {
            Ok(Reply::Scene { toml }) => {
                self.view.scene = Some(toml);
                None
            }
            Ok(Reply::Done { .. }) if is_tuned => None,
            Ok(Reply::Done { text } | Reply::Stopped { text, .. }) => Some(Ok(text)),
            Ok(Reply::Where { address, token: _ }) => Some(Ok(address)),
            Ok(Reply::Status { status }) => Some(Ok(status.line())),
            Err(text) => {
                let level = log::Level::Error.into();
                self.store.log.push(Log { level, text: text.clone() });
                Some(Err(text))
            }
        };
    }

    /// Sends a request; its answer is shown in the bar.
    pub(crate) fn ask(&mut self, request: Request) {
        let ticket = self.source.ask(request);
        self.asked.insert(ticket, Purpose::Other);
    }

    pub(crate) fn stop(&mut self) {
        if self.source.standing() == ConnectionState::Recording {
            // A recording has no keys and rejects the request like any other.
            return self.ask(Request::Stop {});
        }
        let ticket = self.source.ask(Request::Stop {});
        self.asked.insert(ticket, Purpose::Stop);
        if !matches!(self.stop, Some(StopState::Confirmed { .. })) {
            self.stop = Some(StopState::Asked { at: (self.clock)() });
        }
        self.view.notice = None;
    }

    /// Asks a board to show its light; the answer is also shown beside the board.
    pub(crate) fn identify(&mut self, line: u32, board: u32) {
        self.lights.insert((line, board), LightState::Asked);
        let ticket = self.source.ask(Request::Identify { line, board });
        self.asked.insert(ticket, Purpose::Identify { line, board });
    }

    /// Sends changed values, and follows the keys that are drawn.
    pub(crate) fn flush(&mut self) {
        if let Some(changes) = self.tuner.outgoing() {
            let ticket = self.source.ask(Request::Set { changes });
            self.tuner.sent(ticket);
            self.asked.insert(ticket, Purpose::Tune);
        }
        let keys = std::mem::take(&mut self.wanted);
        let topics: BTreeSet<Topic> =
            Topic::COMMON.into_iter().chain(keys.into_iter().map(Topic::Block)).collect();
        if topics != self.followed {
            self.source.follow(&topics);
            self.followed = topics;
        }
    }

    pub(crate) fn light(&self, line: u32, board: u32) -> Option<&LightState> {
        self.lights.get(&(line, board))
    }

    /// Requests a key's rows; a panel calls this in each frame in which it draws them.
    pub(crate) fn want(&mut self, key: u8) {
        self.wanted.insert(key);
    }

    /// Returns the time that is shown (s): the newest, or the frozen one.
    pub(crate) fn now(&self) -> f64 {
        self.view.frozen.unwrap_or_else(|| self.store.newest())
    }

    pub(crate) fn toggle_freeze(&mut self) {
        self.view.frozen = match self.view.frozen {
            None => Some(self.store.newest()),
            Some(_) => None,
        };
    }

    /// Lets all scopes follow the newest rows.
    pub(crate) fn follow(&mut self) {
        self.view.frozen = None;
        self.view.scopes.values_mut().for_each(|scope| scope.pinned = None);
    }

    pub(crate) fn range(&self) -> RangeInclusive<u8> {
        self.view.range.0..=self.view.range.1
    }

    pub(crate) fn select(&mut self, key: u8) {
        let key = key.min(LAST);
        self.view.selected = key;
        self.view.range = (key, key);
    }

    pub(crate) fn select_up_to(&mut self, key: u8) {
        let (key, selected) = (key.min(LAST), self.view.selected);
        self.view.range = (key.min(selected), key.max(selected));
    }

    /// Returns the age of the newest message (s), as far as both clocks agree.
    pub(crate) fn latency(&self) -> Option<f64> {
        let at = self.store.newest_at();
        (0 < at && self.source.standing() == ConnectionState::Live)
            .then(|| (self.clock)().saturating_sub(at) as f64 * 1e-9)
    }

    /// Returns the key's name and instrument.
    pub(crate) fn title(&self, key: u8) -> String {
        let played = self.store.voice(key).map(|voice| voice.instrument.as_str());
        match played.filter(|name| !name.is_empty()) {
            Some(instrument) => format!("{} · {instrument}", names::name(key)),
            None => names::name(key),
        }
    }

    /// Takes a message as if from the source, for measurements.
    pub(crate) fn take_update(&mut self, at: u64, update: Update) {
        self.tuner.take(&update);
        self.store.take(at, update);
    }
}

fn sentence(result: &Result<Reply, String>) -> Result<String, String> {
    match result {
        Ok(Reply::Done { text } | Reply::Stopped { text, .. }) => Ok(text.clone()),
        // The reply has an unexpected kind, but it is a reply.
        Ok(Reply::Scene { .. } | Reply::Where { .. } | Reply::Status { .. }) => {
            Ok("done".to_owned())
        }
        Err(text) => Err(text.clone()),
    }
}
