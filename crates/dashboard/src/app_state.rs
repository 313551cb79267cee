//! Shared state of all panels: the source, its arrivals, and the selection.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};
use telemetry::{
    Arrival, ConnectionState, Log, Reply, Request, Source, Status, Topic, Update, log::Level,
    source::Ticket, status, stream::Role,
};

use crate::toast::{Toast, ToastAction, Toasts};
use crate::{
    WallClock, names, names::LAST, scope::Scope, source_state::SourceState, store::Store,
    store::condition::Conditions, store::journal::Journal, tune::Tuner,
};

/// Most arrivals taken before each frame, so that a flood does not stop the window.
const MOST: usize = 20_000;

/// Purpose of a request, which decides where its answer is shown.
#[derive(Clone, PartialEq, Eq, Debug)]
enum Purpose {
    Tune,
    /// A success of it is seen at the key.
    Press,
    Record,
    Other,
    Stop,
    Identify {
        line: u32,
        board: u32,
    },
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
    /// Keys had no force, and now a host runs again that rejects this window for this reason.
    RunsAgain(String),
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
            Ok(
                Reply::Scene { .. }
                | Reply::Where { .. }
                | Reply::Figures { .. }
                | Reply::Status { .. },
            ) => Self::Unconfirmed("the host said something else".to_owned()),
            Err(text) => Self::Unconfirmed(text),
        }
    }
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum LightState {
    Asked,
    Answered(Result<String, String>),
}

/// Display state shared by all panels.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct SharedView {
    pub(crate) selected: u8,
    /// Lowest and highest key of the selected range.
    pub(crate) range: (u8, u8),
    pub(crate) scopes: BTreeMap<u8, Scope>,
    /// Time at which the display is frozen (s).
    #[serde(skip)]
    pub(crate) frozen: Option<f64>,
    #[serde(skip)]
    pub(crate) scene: Option<String>,
    /// Path of a running recording, if this window began it.
    #[serde(skip)]
    pub(crate) recording: Option<String>,
    #[serde(skip)]
    pub(crate) shows_help: bool,
}

pub(crate) struct AppState {
    pub(crate) source: Box<dyn Source>,
    pub(crate) clock: WallClock,
    pub(crate) store: Store,
    pub(crate) tuner: Tuner,
    pub(crate) view: SharedView,
    pub(crate) stop: Option<StopState>,
    pub(crate) toasts: Toasts,
    /// `true` between a new connection and the catalogue or status of its run.
    awaits_run: bool,
    lights: BTreeMap<(u32, u32), LightState>,
    asked: BTreeMap<Ticket, Purpose>,
    followed: BTreeSet<Topic>,
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
            toasts: Toasts::default(),
            awaits_run: true,
            lights: BTreeMap::new(),
            asked: BTreeMap::new(),
            followed: BTreeSet::new(),
            wanted: BTreeSet::new(),
        }
    }

    pub(crate) fn take(&mut self) {
        for _ in 0..MOST {
            let Some(arrival) = self.source.next() else { break };
            match arrival {
                Arrival::Update { at, update } => self.take_update(at, *update),
                Arrival::Reply { ticket, result } => self.take_reply(ticket, result),
                Arrival::Anew => self.start_anew(),
            }
        }
        if let (Some(StopState::Confirmed { .. }), ConnectionState::Refused(why)) =
            (&self.stop, self.source.standing())
        {
            self.stop = Some(StopState::RunsAgain(why));
        }
        let (store, view) = (&self.store, &mut self.view);
        for scope in view.scopes.values_mut() {
            scope.update(store, scope.key.unwrap_or(view.selected));
        }
    }

    fn start_anew(&mut self) {
        let is_live = self.source.timeline().is_none();
        let log = is_live.then(|| std::mem::replace(&mut self.store.log, Journal::new(0)));
        self.store.forget();
        if let Some(log) = log {
            self.store.log = log;
        }
        self.awaits_run = is_live;
        self.tuner.connection_lost();
        if !is_live {
            // Another position in a recording has other values.
            self.new_run();
        }
        self.view.frozen = None;
        self.lights.clear();
        self.asked.clear();
        self.stop = match self.stop.take() {
            // A host runs again.
            None | Some(StopState::Confirmed { .. } | StopState::RunsAgain(_)) => None,
            Some(StopState::Asked { .. }) => {
                Some(StopState::Unconfirmed("the host was reached anew meanwhile".to_owned()))
            }
            Some(unconfirmed @ StopState::Unconfirmed(_)) => Some(unconfirmed),
        };
    }

    /// Begins with another run, or with another position in a recording.
    fn new_run(&mut self) {
        self.tuner.forget();
        self.view.recording = None;
    }

    /// Compares the run behind a new connection with the run before; an unknown run is a new one.
    fn recognise_run(&mut self, update: &Update) {
        let before = self.store.catalogue.as_ref().map(|it| it.run.as_str());
        let is_known = if let Update::Catalogue(it) = update {
            before == Some(it.run.as_str())
        } else if is_before_ticks(update) {
            false
        } else {
            return;
        };
        self.awaits_run = false;
        if !is_known {
            self.store.forget_run();
            self.new_run();
        }
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
        if self.tuner.checks.answered(ticket, &result) {
            return;
        }
        if purpose == Some(Purpose::Tune) {
            self.tuner.answered(ticket, result.as_ref().map(|_| ()).map_err(String::as_str));
        }
        if let Some(Purpose::Identify { line, board }) = purpose {
            self.lights.insert((line, board), LightState::Answered(sentence(&result)));
        }
        let is_seen = matches!(purpose, Some(Purpose::Tune | Purpose::Press));
        match result {
            Ok(Reply::Scene { toml }) => self.view.scene = Some(toml),
            Ok(Reply::Done { .. }) if is_seen => {}
            Ok(Reply::Done { text } | Reply::Stopped { text, .. }) => self.notify(Ok(text)),
            Ok(Reply::Where { address, token: _ }) => self.notify(Ok(address)),
            Ok(Reply::Status { status }) => self.notify(Ok(status.line())),
            Ok(Reply::Figures { warnings, .. }) if warnings.is_empty() => {}
            Ok(Reply::Figures { warnings, .. }) => self.notify(Err(warnings.join("; "))),
            Err(text) => {
                if purpose == Some(Purpose::Record) {
                    self.view.recording = None;
                }
                self.notify(Err(text));
            }
        }
    }

    /// Shows a result in the corner of the window, and keeps it in the log.
    pub(crate) fn notify(&mut self, result: Result<String, String>) {
        let (level, text) = match result {
            Ok(text) => (Level::Info, text),
            Err(text) => (Level::Error, text),
        };
        self.show(Toast { text, level, actions: Vec::new() });
    }

    /// Shows `toast` in the corner of the window, and keeps its text in the log.
    pub(crate) fn show(&mut self, toast: Toast) {
        self.store.log.push((0, Log { level: toast.level.into(), text: toast.text.clone() }));
        self.toasts.push(toast, (self.clock)());
    }

    pub(crate) fn source_state(&self) -> SourceState {
        SourceState::new(self.source.standing(), self.store.status.as_ref())
    }

    pub(crate) fn may_change(&self) -> bool {
        self.may(Role::Tuner)
    }

    pub(crate) fn may(&self, role: Role) -> bool {
        let is_live = self.source.standing() == ConnectionState::Live;
        is_live && self.source.role().is_none_or(|granted| role <= granted)
    }

    /// Sends a request; its answer is shown in the corner of the window.
    pub(crate) fn ask(&mut self, request: Request) {
        let purpose = if matches!(request, Request::Press { .. } | Request::Grip { .. }) {
            Purpose::Press
        } else if matches!(request, Request::Record { .. }) {
            Purpose::Record
        } else {
            Purpose::Other
        };
        let ticket = self.source.ask(request);
        self.asked.insert(ticket, purpose);
    }

    pub(crate) fn stop(&mut self) {
        if self.source.timeline().is_some() {
            // A recording has no keys and rejects the request like any other.
            return self.ask(Request::Stop {});
        }
        let ticket = self.source.ask(Request::Stop {});
        self.asked.insert(ticket, Purpose::Stop);
        if !matches!(self.stop, Some(StopState::Confirmed { .. })) {
            self.stop = Some(StopState::Asked { at: (self.clock)() });
        }
    }

    /// Asks a board to show its light; the answer is also shown beside the board.
    pub(crate) fn identify(&mut self, line: u32, board: u32) {
        self.lights.insert((line, board), LightState::Asked);
        let ticket = self.source.ask(Request::Identify { line, board });
        self.asked.insert(ticket, Purpose::Identify { line, board });
    }

    /// Sends changed values, and follows the keys that are drawn.
    pub(crate) fn flush(&mut self) {
        if let Some(request) = self.tuner.outgoing().filter(|_| self.may_change()) {
            let ticket = self.source.ask(request);
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

    /// Requests a key's rows; a panel calls this in each frame that draws them.
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

    pub(crate) fn undo(&mut self) {
        let keys = self.tuner.undo();
        self.show_keys(keys);
    }

    pub(crate) fn redo(&mut self) {
        let keys = self.tuner.redo();
        self.show_keys(keys);
    }

    /// Selects changed keys, unless the selected key is one of them: no change happens unseen.
    pub(crate) fn show_keys(&mut self, keys: Option<RangeInclusive<u8>>) {
        if let Some(keys) = keys.filter(|keys| !keys.contains(&self.view.selected)) {
            self.select(*keys.start());
            self.select_up_to(*keys.end());
        }
    }

    /// Returns the age of the newest message (s), as far as both clocks agree.
    pub(crate) fn latency(&self) -> Option<f64> {
        let at = self.store.newest_at();
        (0 < at && self.source.standing() == ConnectionState::Live)
            .then(|| (self.clock)().saturating_sub(at) as f64 * 1e-9)
    }

    pub(crate) fn title(&self, key: u8) -> String {
        let played = self.store.voice(key).map(|voice| voice.instrument.as_str());
        match played.filter(|name| !name.is_empty()) {
            Some(instrument) => format!("{} · {instrument}", names::name(key)),
            None => names::name(key),
        }
    }

    /// Takes a message from `at` (ns since 1970).
    pub(crate) fn take_update(&mut self, at: u64, update: Update) {
        if self.awaits_run {
            self.recognise_run(&update);
        }
        if let Update::Status(status) = &update {
            self.report_boards(status);
        }
        self.tuner.take(&update);
        self.store.take(at, update);
    }

    fn report_boards(&mut self, now: &Status) {
        let before = self.store.conditions.boards.clone();
        let now = Conditions::new(&now.boards, &now.lines, Some(now)).boards;
        before.iter().filter(|text| !now.contains(text)).for_each(|text| self.toasts.end(text));
        for text in now.into_iter().filter(|text| !before.contains(text)) {
            let actions = vec![("Show links".to_owned(), ToastAction::ShowLinks)];
            self.show(Toast { text, level: Level::Error, actions });
        }
    }
}

fn is_before_ticks(update: &Update) -> bool {
    matches!(update, Update::Status(it) if it.state() < status::State::Playing)
}

fn sentence(result: &Result<Reply, String>) -> Result<String, String> {
    match result {
        Ok(Reply::Done { text } | Reply::Stopped { text, .. }) => Ok(text.clone()),
        // The reply has an unexpected kind, but it is a reply.
        Ok(
            Reply::Scene { .. }
            | Reply::Where { .. }
            | Reply::Figures { .. }
            | Reply::Status { .. },
        ) => Ok("done".to_owned()),
        Err(text) => Err(text.clone()),
    }
}
