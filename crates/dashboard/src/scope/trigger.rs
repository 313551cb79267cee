//! Trigger that holds a scope: at a level, at a mode switch, at a strike.

use serde::{Deserialize, Serialize};
use telemetry::event::Kind;

use crate::store::Store;

/// Direction in which a level is crossed.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub enum Edge {
    #[default]
    Rising,
    Falling,
}

/// Event that a trigger waits for.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub enum On {
    /// No event: the scope follows.
    #[default]
    Nothing,
    Level,
    Switch,
    Strike,
}

impl On {
    pub const ALL: [Self; 4] = [Self::Nothing, Self::Level, Self::Switch, Self::Strike];

    pub const fn text(self) -> &'static str {
        match self {
            Self::Nothing => "no trigger",
            Self::Level => "level",
            Self::Switch => "mode switch",
            Self::Strike => "strike",
        }
    }
}

/// Display between two triggers.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub enum Sweep {
    /// The scope follows the newest time while there is no trigger.
    #[default]
    Auto,
    Normal,
    /// The first trigger stays until it is armed again.
    Single,
}

impl Sweep {
    pub const ALL: [Self; 3] = [Self::Auto, Self::Normal, Self::Single];

    pub const fn text(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::Normal => "normal",
            Self::Single => "single",
        }
    }
}

/// The settings of a trigger.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(default)]
pub struct Trigger {
    pub on: On,
    pub channel: String,
    /// Level in the channel's own unit.
    pub level: f64,
    pub edge: Edge,
    pub sweep: Sweep,
    /// Time after a trigger in which no other is accepted (s).
    pub hold_off: f64,
    /// Share of the window that lies before the trigger.
    pub before: f64,
}

impl Default for Trigger {
    fn default() -> Self {
        Self {
            on: On::Nothing,
            channel: "force".into(),
            level: 1.0,
            edge: Edge::Rising,
            sweep: Sweep::Auto,
            hold_off: 0.0,
            before: 0.25,
        }
    }
}

/// State of a trigger: the checked time, and its latest event.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct TriggerState {
    seen: f64,
    fired: Option<f64>,
}

impl TriggerState {
    /// Checks the rows and events since the last call, for a window of `window` (s).
    pub fn update(&mut self, trigger: &Trigger, store: &Store, key: u8, window: f64) {
        let now = store.newest();
        if now < self.seen {
            *self = Self::default();
        }
        let hits = hits(trigger, store, key, self.seen, now);
        self.seen = now;
        let rest = trigger.hold_off.max(window * (1.0 - trigger.before));
        for hit in hits {
            let is_free = self.fired.is_none_or(|fired| fired + rest <= hit);
            let is_over = trigger.sweep == Sweep::Single && self.fired.is_some();
            if is_free && !is_over {
                self.fired = Some(hit);
            }
        }
    }

    pub fn rearm(&mut self) {
        self.fired = None;
    }

    /// Returns the time of the latest trigger (s).
    pub const fn fired(&self) -> Option<f64> {
        self.fired
    }

    /// Returns the end of the window (s), unless it follows the newest time.
    pub fn end(&self, trigger: &Trigger, window: f64, now: f64) -> Option<f64> {
        let end = self.fired? + window * (1.0 - trigger.before);
        let is_old = trigger.sweep == Sweep::Auto && end + window.max(0.5) < now;
        (trigger.on != On::Nothing && !is_old).then_some(end)
    }
}

/// Returns the times after `from` up to `to` at which the trigger fires (s).
fn hits(trigger: &Trigger, store: &Store, key: u8, from: f64, to: f64) -> Vec<f64> {
    match trigger.on {
        On::Nothing => Vec::new(),
        On::Level => crossings(trigger, store, key, from),
        On::Switch => events(store, key, Kind::Switch, from, to),
        On::Strike => events(store, key, Kind::Strike, from, to),
    }
}

fn events(store: &Store, key: u8, kind: Kind, from: f64, to: f64) -> Vec<f64> {
    let of_kind = store.events.iter().filter(|it| it.kind() == kind && it.key == u32::from(key));
    of_kind.map(|it| store.when(it)).filter(|at| from < *at && *at <= to).collect()
}

fn crossings(trigger: &Trigger, store: &Store, key: u8, from: f64) -> Vec<f64> {
    let Some((column, _)) = store.channel(key, &trigger.channel) else { return Vec::new() };
    let Some(trace) = store.trace(key) else { return Vec::new() };
    let (ticks, values) = (trace.ticks(), trace.values(column));
    let first = trace.row_at(store.tick(from)).unwrap_or(0);
    let crosses = |pair: &[f32]| {
        let (a, b) = (f64::from(pair[0]) - trigger.level, f64::from(pair[1]) - trigger.level);
        match trigger.edge {
            Edge::Rising => a < 0.0 && 0.0 <= b,
            Edge::Falling => 0.0 < a && b <= 0.0,
        }
    };
    let pairs = values[first.min(values.len())..].windows(2).enumerate();
    let hits = pairs.filter(|(_, pair)| crosses(pair));
    hits.map(|(i, _)| store.seconds(ticks[first + i + 1])).filter(|at| from < *at).collect()
}

#[cfg(test)]
mod tests {
    use telemetry::{Event, KeyBlock, Update};

    use super::*;

    const KEY: u8 = 39;

    fn feed(store: &mut Store, from: u32, to: u32) {
        let rows = (to - from) as usize;
        let force = (from..to).map(|tick| if tick % 100 < 50 { 0.0 } else { 2.0 }).collect();
        let block = KeyBlock {
            key: KEY.into(),
            tick: from.into(),
            after: (0..to - from).collect(),
            position: vec![0.0; rows],
            force,
            sent: vec![0.0; rows],
            mode: vec![0; rows],
            ..KeyBlock::default()
        };
        store.take(0, Update::Block(block));
    }

    fn strike(store: &mut Store, tick: u64) {
        let kind = Kind::Strike.into();
        store.take(0, Update::Event(Event { kind, tick, key: KEY.into(), ..Event::default() }));
    }

    #[track_caller]
    fn fired(armed: &TriggerState, at: Option<f64>) {
        let found = armed.fired();
        let same =
            found.zip(at).map_or(found.is_none() && at.is_none(), |(a, b)| (a - b).abs() < 1e-9);
        assert!(same, "fired at {found:?}, not {at:?}");
    }

    #[test]
    fn a_level_fires_on_its_edge() {
        let mut store = Store::default();
        feed(&mut store, 0, 120);
        let mut trigger = Trigger { on: On::Level, ..Trigger::default() };
        let mut armed = TriggerState::default();
        armed.update(&trigger, &store, KEY, 1.0);
        fired(&armed, Some(0.05));
        trigger.edge = Edge::Falling;
        let mut armed = TriggerState::default();
        armed.update(&trigger, &store, KEY, 1.0);
        fired(&armed, Some(0.1));
    }

    #[test]
    fn a_crossing_between_two_looks_is_not_missed() {
        let mut store = Store::default();
        feed(&mut store, 0, 50);
        let trigger = Trigger { on: On::Level, ..Trigger::default() };
        let mut armed = TriggerState::default();
        armed.update(&trigger, &store, KEY, 0.1);
        fired(&armed, None);
        feed(&mut store, 50, 52);
        armed.update(&trigger, &store, KEY, 0.1);
        fired(&armed, Some(0.05));
    }

    #[test]
    fn none_fires_while_it_is_held_off() {
        let mut store = Store::default();
        feed(&mut store, 0, 1000);
        let trigger = Trigger { on: On::Level, hold_off: 0.25, ..Trigger::default() };
        let mut armed = TriggerState::default();
        armed.update(&trigger, &store, KEY, 0.01);
        // 0.05, then 0.35, 0.65, 0.95.
        fired(&armed, Some(0.95));
    }

    #[test]
    fn a_single_one_stays_until_it_is_armed_again() {
        let mut store = Store::default();
        strike(&mut store, 100);
        strike(&mut store, 900);
        feed(&mut store, 0, 1000);
        let trigger = Trigger { on: On::Strike, sweep: Sweep::Single, ..Trigger::default() };
        let mut armed = TriggerState::default();
        armed.update(&trigger, &store, KEY, 0.01);
        fired(&armed, Some(0.1));
        armed.rearm();
        strike(&mut store, 1500);
        feed(&mut store, 1000, 2000);
        armed.update(&trigger, &store, KEY, 0.01);
        fired(&armed, Some(1.5));
    }

    #[test]
    fn auto_follows_when_nothing_comes_and_normal_holds() {
        let armed = TriggerState { seen: 0.0, fired: Some(1.0) };
        let mut trigger = Trigger { on: On::Strike, before: 0.5, ..Trigger::default() };
        assert_eq!(armed.end(&trigger, 1.0, 1.6), Some(1.5));
        assert_eq!(armed.end(&trigger, 1.0, 60.0), None);
        trigger.sweep = Sweep::Normal;
        assert_eq!(armed.end(&trigger, 1.0, 60.0), Some(1.5));
    }

    #[test]
    fn a_recording_that_is_wound_back_is_looked_at_anew() {
        let mut store = Store::default();
        strike(&mut store, 100);
        feed(&mut store, 0, 200);
        let trigger = Trigger { on: On::Strike, ..Trigger::default() };
        let mut armed = TriggerState { seen: 60.0, fired: Some(59.0) };
        armed.update(&trigger, &store, KEY, 0.01);
        fired(&armed, Some(0.1));
    }
}
