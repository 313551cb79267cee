//! Everything that a panel may see and change.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};
use telemetry::source::Ticket;
use telemetry::{Arrival, ConnectionState, Log, Reply, Request, Source, Topic, Update, log};

use crate::names::LAST;
use crate::panels::links::Light;
use crate::panels::{deadlines, keyboard, links, midi, phase, tuning};
use crate::scope::Scope;
use crate::store::Store;
use crate::tune::Tuner;
use crate::{WallClock, names};

/// Arrivals that are taken before each frame: a flood does not stop the window.
const MOST: usize = 20_000;

/// Why something was asked.
#[derive(Clone, PartialEq, Eq, Debug)]
enum Purpose {
    Tune,
    Tell,
    Stop,
    Identify { line: u32, board: u32 },
}

/// What became of a stop that was asked for here.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum StopState {
    /// The host has not answered since then (ns since 1970).
    Asked { at: u64 },
    /// No key has a force: how many boards were told of how many, where the host says that, and
    /// its own sentence.
    Confirmed { told: Option<(u32, u32)>, text: String },
    /// Keys may have forces; why that is not known, in a sentence.
    Unconfirmed(String),
}

impl StopState {
    /// What an answer says.
    fn of(result: Result<Reply, String>) -> Self {
        match result {
            Ok(Reply::Stopped { told, boards, text }) if boards <= told => {
                Self::Confirmed { told: Some((told, boards)), text }
            }
            Ok(Reply::Stopped { told, boards, text: _ }) => {
                Self::Unconfirmed(format!("boards told: {told} of {boards}"))
            }
            Ok(Reply::Done { text }) => Self::Confirmed { told: None, text },
            Ok(Reply::Scene { .. } | Reply::Where { .. }) => {
                Self::Unconfirmed("the host said something else".to_owned())
            }
            Err(text) => Self::Unconfirmed(text),
        }
    }
}

/// What panels remember of themselves.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(default)]
pub(crate) struct Views {
    /// The selected key, and those with it.
    pub(crate) selected: u8,
    pub(crate) range: (u8, u8),
    pub(crate) scopes: BTreeMap<u8, Scope>,
    pub(crate) phase: phase::View,
    pub(crate) tuning: tuning::View,
    pub(crate) deadlines: deadlines::View,
    pub(crate) midi: midi::View,
    #[serde(skip)]
    pub(crate) links: links::View,
    #[serde(skip)]
    pub(crate) keyboard: keyboard::View,
    #[serde(skip)]
    pub(crate) instruments: crate::panels::instruments::View,
    /// The time at which everything stands still (s).
    #[serde(skip)]
    pub(crate) frozen: Option<f64>,
    /// The scene as it sounds now, if somebody asked.
    #[serde(skip)]
    pub(crate) scene: Option<String>,
    /// The last answer, in a sentence.
    #[serde(skip)]
    pub(crate) notice: Option<Result<String, String>>,
    /// Where a recording is being written, if this window began it.
    #[serde(skip)]
    pub(crate) recording: Option<String>,
    #[serde(skip)]
    pub(crate) shows_help: bool,
}

/// Everything that a panel may see and change.
pub(crate) struct AppState {
    pub(crate) source: Box<dyn Source>,
    pub(crate) clock: WallClock,
    pub(crate) store: Store,
    pub(crate) tuner: Tuner,
    pub(crate) views: Views,
    /// What became of a stop, if one was asked for.
    pub(crate) stop: Option<StopState>,
    asked: BTreeMap<Ticket, Purpose>,
    followed: BTreeSet<Topic>,
    /// Keys whose rows somebody looked at in this frame.
    wanted: BTreeSet<u8>,
}

impl AppState {
    pub(crate) fn new(source: Box<dyn Source>, clock: WallClock) -> Self {
        let views = Views { selected: 39, range: (39, 39), ..Views::default() };
        Self {
            source,
            clock,
            store: Store::default(),
            tuner: Tuner::default(),
            views,
            stop: None,
            asked: BTreeMap::new(),
            followed: BTreeSet::new(),
            wanted: BTreeSet::new(),
        }
    }

    /// Takes what has arrived.
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
        let (store, views) = (&self.store, &mut self.views);
        for scope in views.scopes.values_mut() {
            scope.look(store, scope.key.unwrap_or(views.selected));
        }
    }

    fn start_anew(&mut self) {
        self.store.forget();
        self.tuner.forget();
        self.views.frozen = None;
        self.views.links = links::View::default();
        self.asked.clear();
        self.stop = match self.stop.take() {
            // Another run, which nobody has stopped.
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
            // It has a place of its own, and a second one that fails takes nothing back.
            if !matches!(self.stop, Some(StopState::Confirmed { .. })) {
                self.stop = Some(StopState::of(result));
            }
            return;
        }
        if purpose == Some(Purpose::Tune) {
            self.tuner.answered(ticket, result.as_ref().map(|_| ()).map_err(String::as_str));
        }
        if let Some(Purpose::Identify { line, board }) = purpose {
            self.views.links.lights.insert((line, board), Light::Answered(told(&result)));
        }
        let is_tuned = purpose == Some(Purpose::Tune) && result.is_ok();
        self.views.notice = match result {
            Ok(Reply::Scene { toml }) => {
                self.views.scene = Some(toml);
                None
            }
            Ok(Reply::Done { .. }) if is_tuned => None,
            Ok(Reply::Done { text } | Reply::Stopped { text, .. }) => Some(Ok(text)),
            Ok(Reply::Where { address, token: _ }) => Some(Ok(address)),
            Err(text) => {
                let level = log::Level::Error.into();
                self.store.log.push(Log { level, text: text.clone() });
                Some(Err(text))
            }
        };
    }

    /// Asks the host; the answer is seen in the bar.
    pub(crate) fn ask(&mut self, request: Request) {
        let ticket = self.source.ask(request);
        self.asked.insert(ticket, Purpose::Tell);
    }

    /// No force on any key.
    pub(crate) fn stop(&mut self) {
        if self.source.standing() == ConnectionState::Recording {
            // It has no keys, and says so as with anything that is asked of it.
            return self.ask(Request::Stop {});
        }
        let ticket = self.source.ask(Request::Stop {});
        self.asked.insert(ticket, Purpose::Stop);
        if !matches!(self.stop, Some(StopState::Confirmed { .. })) {
            self.stop = Some(StopState::Asked { at: (self.clock)() });
        }
        self.views.notice = None;
    }

    /// A board shows its light; the answer is seen beside it too.
    pub(crate) fn identify(&mut self, line: u32, board: u32) {
        self.views.links.lights.insert((line, board), Light::Asked);
        let ticket = self.source.ask(Request::Identify { line, board });
        self.asked.insert(ticket, Purpose::Identify { line, board });
    }

    /// Sends values that were changed, and says which keys are looked at.
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

    /// This key's rows are looked at.
    pub(crate) fn want(&mut self, key: u8) {
        self.wanted.insert(key);
    }

    /// The time that is shown [s]: the newest, or that at which everything stands still.
    pub(crate) fn now(&self) -> f64 {
        self.views.frozen.unwrap_or_else(|| self.store.newest())
    }

    /// Lets everything stand still, or go on.
    pub(crate) fn toggle_freeze(&mut self) {
        self.views.frozen = match self.views.frozen {
            None => Some(self.store.newest()),
            Some(_) => None,
        };
    }

    /// All scopes follow what comes.
    pub(crate) fn follow(&mut self) {
        self.views.frozen = None;
        self.views.scopes.values_mut().for_each(|scope| scope.pinned = None);
    }

    /// The selected range.
    pub(crate) fn range(&self) -> RangeInclusive<u8> {
        self.views.range.0..=self.views.range.1
    }

    /// Selects a key.
    pub(crate) fn select(&mut self, key: u8) {
        let key = key.min(LAST);
        self.views.selected = key;
        self.views.range = (key, key);
    }

    /// Selects all keys from the selected one to `key`.
    pub(crate) fn select_up_to(&mut self, key: u8) {
        let (key, selected) = (key.min(LAST), self.views.selected);
        self.views.range = (key.min(selected), key.max(selected));
    }

    /// Seconds since the newest message was made, as far as both clocks agree.
    pub(crate) fn latency(&self) -> Option<f64> {
        let at = self.store.newest_at();
        (0 < at && self.source.standing() == ConnectionState::Live)
            .then(|| (self.clock)().saturating_sub(at) as f64 * 1e-9)
    }

    /// The key's name, and what plays it.
    pub(crate) fn title(&self, key: u8) -> String {
        let played = self.store.voice(key).map(|voice| voice.instrument.as_str());
        match played.filter(|name| !name.is_empty()) {
            Some(instrument) => format!("{} · {instrument}", names::name(key)),
            None => names::name(key),
        }
    }

    /// Takes a message as if the source had given it: for measurements.
    pub(crate) fn take_update(&mut self, at: u64, update: Update) {
        self.tuner.take(&update);
        self.store.take(at, update);
    }
}

/// An answer in a sentence.
fn told(result: &Result<Reply, String>) -> Result<String, String> {
    match result {
        Ok(Reply::Done { text } | Reply::Stopped { text, .. }) => Ok(text.clone()),
        // Another answer than it should be, but an answer.
        Ok(Reply::Scene { .. } | Reply::Where { .. }) => Ok("done".to_owned()),
        Err(text) => Err(text.clone()),
    }
}
