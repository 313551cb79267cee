//! The arrivals, up to a bound. Time is the tick's number times the period (s since the run began).
//!
//! Nothing here draws, asks or reads a clock.

mod column;
pub mod condition;
pub mod journal;
pub mod key_summary;
pub mod timing;
pub mod trace;

use std::collections::BTreeMap;

use telemetry::{
    Catalogue, Deadlines, Event, Links, Log, Midi, Model, Parameter, Signal, Status, Update, Voice,
};

use crate::number;
use condition::Conditions;
use journal::Journal;
use key_summary::KeySummaries;
use timing::Timing;
use trace::{OWN, Trace};

/// Size of each key's rows (B): two minutes of a model of eight signals.
const TRACE_BYTES: usize = 8 << 20;

/// The last accepted tick: thousands of years.
pub(crate) const LAST_TICK: u64 = 1 << 48;

const USUAL_HZ: u32 = 1000;

/// All data of a host that a window shows.
#[derive(Clone, Debug)]
pub struct Store {
    pub catalogue: Option<Catalogue>,
    pub summaries: KeySummaries,
    pub events: Journal<Event>,
    /// Messages with their times (ns since 1970); 0 for those of this window.
    pub log: Journal<(u64, Log)>,
    pub midi: Journal<Midi>,
    pub timing: Timing,
    pub deadlines: Option<Deadlines>,
    pub links: Option<Links>,
    pub status: Option<Status>,
    /// Keys without a force.
    pub conditions: Conditions,
    voices: BTreeMap<u8, Voice>,
    traces: BTreeMap<u8, Trace>,
    /// Time of the newest message (ns since 1970).
    newest_at: u64,
    version: u64,
}

impl Default for Store {
    fn default() -> Self {
        Self {
            catalogue: None,
            summaries: KeySummaries::default(),
            events: Journal::new(20_000),
            log: Journal::new(2_000),
            midi: Journal::new(5_000),
            timing: Timing::default(),
            deadlines: None,
            links: None,
            status: None,
            conditions: Conditions::default(),
            voices: BTreeMap::new(),
            traces: BTreeMap::new(),
            newest_at: 0,
            version: 0,
        }
    }
}

impl Store {
    /// Takes a message from `at` (ns since 1970).
    pub fn take(&mut self, at: u64, update: Update) {
        self.version += 1;
        self.newest_at = self.newest_at.max(at);
        match update {
            Update::Catalogue(it) => self.catalogue = Some(it),
            Update::Voice(it) => {
                if let Some(key) = number::key(it.key) {
                    self.voices.insert(key, it);
                }
            }
            Update::Overview(it) if LAST_TICK < it.tick => {}
            Update::Overview(it) => self.summaries.take(&it),
            Update::Block(it) => {
                if let Some(key) = number::key(it.key) {
                    let period = self.period();
                    let trace = self.traces.entry(key).or_default();
                    trace.append(&it, period);
                    trace.cap(TRACE_BYTES);
                }
            }
            Update::State(..) => {}
            Update::Event(it) if LAST_TICK < it.tick => {}
            Update::Event(it) => self.events.push(it),
            Update::Ticks(it) => self.timing.take(&it),
            Update::Deadlines(it) => self.deadlines = Some(it),
            Update::Links(it) => {
                if self.status.is_none() {
                    // A recording has no status.
                    let lines: Vec<_> = it.lines.iter().map(|line| line.name.clone()).collect();
                    self.conditions = Conditions::new(&it.boards, &lines, None);
                }
                self.links = Some(it);
            }
            Update::Status(it) => {
                self.conditions = Conditions::new(&it.boards, &it.lines, Some(&it));
                self.status = Some(it);
            }
            Update::Midi(it) => self.midi.push(it),
            Update::Log(it) => {
                // A host repeats its last lines after each connection.
                let entry = (at, it);
                if at == 0 || !self.log.iter().rev().any(|known| *known == entry) {
                    self.log.push(entry);
                }
            }
        }
    }

    /// Forgets the data before another run or position; the catalogue and the voices stay.
    pub fn forget(&mut self) {
        *self = Self {
            catalogue: self.catalogue.take(),
            voices: std::mem::take(&mut self.voices),
            version: self.version + 1,
            ..Self::default()
        };
    }

    /// Forgets the catalogue, the voices and the status of a run that is over.
    pub fn forget_run(&mut self) {
        (self.catalogue, self.status) = (None, None);
        self.conditions = Conditions::default();
        self.voices.clear();
        self.version += 1;
    }

    /// Forgets rows, events and messages, and nothing else.
    pub fn clear(&mut self) {
        self.traces.clear();
        self.events.clear();
        self.midi.clear();
        self.timing = Timing::default();
        self.version += 1;
    }

    pub fn period(&self) -> f64 {
        let hz = self.catalogue.as_ref().map_or(USUAL_HZ, |it| it.tick_hz.max(1));
        1.0 / f64::from(hz)
    }

    /// Returns the time at which a tick began (s).
    pub fn seconds(&self, tick: u64) -> f64 {
        tick as f64 * self.period()
    }

    pub fn tick(&self, seconds: f64) -> u64 {
        number::floor(seconds / self.period() + 1e-6)
    }

    /// Returns the time of an event (s).
    pub fn when(&self, event: &Event) -> f64 {
        let theta = if event.theta.is_finite() { event.theta } else { 0.0 };
        (event.tick as f64 + theta) * self.period()
    }

    /// Returns the newest time of any data (s).
    pub fn newest(&self) -> f64 {
        let rows = self.traces.values().filter_map(|trace| trace.ticks().last());
        let tick = rows.copied().fold(self.summaries.tick, u64::max);
        self.seconds(tick)
    }

    /// Returns the time of the newest message (ns since 1970).
    pub const fn newest_at(&self) -> u64 {
        self.newest_at
    }

    /// Returns a count of arrivals: nothing has changed while it is constant.
    pub const fn version(&self) -> u64 {
        self.version
    }

    pub fn trace(&self, key: u8) -> Option<&Trace> {
        self.traces.get(&key)
    }

    /// Returns the size of all rows (B).
    pub fn bytes(&self) -> usize {
        self.traces.values().map(Trace::bytes).sum()
    }

    pub fn voice(&self, key: u8) -> Option<&Voice> {
        self.voices.get(&key)
    }

    pub fn voices(&self) -> impl Iterator<Item = (u8, &Voice)> {
        self.voices.iter().map(|(key, voice)| (*key, voice))
    }

    pub fn model(&self, name: &str) -> Option<&Model> {
        self.catalogue.as_ref()?.models.iter().find(|model| model.name == name)
    }

    /// Returns the model of a key, in the version that plays it.
    pub fn model_of(&self, key: u8) -> Option<&Model> {
        let voice = self.voice(key)?;
        let mut models = self.catalogue.as_ref()?.models.iter();
        let found = models.find(|it| (&it.name, it.version) == (&voice.model, voice.version));
        found.or_else(|| self.model(&voice.model))
    }

    pub fn parameters(&self, key: u8) -> &[Parameter] {
        self.model_of(key).map_or(&[], |model| &model.parameters)
    }

    pub fn signals(&self, key: u8) -> &[Signal] {
        self.model_of(key).map_or(&[], |model| &model.signals)
    }

    pub fn mode_name(&self, key: u8, mode: u8) -> String {
        let named = self.model_of(key).and_then(|model| model.modes.get(usize::from(mode)));
        named.cloned().unwrap_or_else(|| format!("mode {mode}"))
    }

    /// Returns the column of a key's channel `name`, and its unit.
    pub fn channel(&self, key: u8, name: &str) -> Option<(usize, &str)> {
        if let Some(i) = OWN.iter().position(|(own, _)| *own == name) {
            return Some((i, OWN[i].1));
        }
        let signals = self.signals(key);
        let i = signals.iter().position(|signal| signal.name == name)?;
        Some((OWN.len() + i, &signals[i].unit))
    }

    pub fn channels(&self, key: u8) -> Vec<(String, String)> {
        let own = OWN.iter().map(|(name, unit)| ((*name).to_owned(), (*unit).to_owned()));
        let signals = self.signals(key).iter();
        own.chain(signals.map(|signal| (signal.name.clone(), signal.unit.clone()))).collect()
    }

    pub fn value(&self, key: u8, channel: &str, seconds: f64) -> Option<f64> {
        let (column, _) = self.channel(key, channel)?;
        self.trace(key)?.value_at(column, self.tick(seconds)).map(f64::from)
    }

    /// Returns the keys that have a fault in the newest overview.
    pub fn faulty(&self) -> Vec<u8> {
        (0..=crate::names::LAST).filter(|key| self.summaries.key(*key).fault != 0).collect()
    }
}
