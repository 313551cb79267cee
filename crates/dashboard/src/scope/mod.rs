//! Contents of a scope, without drawing: channels, a stretch of time, a trigger, two cursors.

pub mod heights;
pub mod trigger;

use std::collections::BTreeSet;

use serde::{Deserialize, Serialize};
use telemetry::signal::Kind;

use crate::store::Store;
use heights::Heights;
use trigger::{On, Trigger, TriggerState};

/// Shortest and longest window (s).
const WINDOW: (f64, f64) = (2e-3, 600.0);

/// Most keys beside the scope's own: more could not be distinguished.
const COMPARED: usize = 4;

/// The settings of a scope.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
#[serde(default)]
pub struct Scope {
    /// The key; the selected one if `None`.
    pub key: Option<u8>,
    pub compared: BTreeSet<u8>,
    /// Channels of each plot, from the top; the usual ones if empty.
    pub lanes: Vec<Vec<String>>,
    /// Length of the time shown (s).
    pub window: f64,
    pub trigger: Trigger,
    pub has_cursors: bool,
    /// `true` if the scope has its own window.
    pub is_popped: bool,
    /// Times of the cursors (s).
    #[serde(skip)]
    pub cursors: [f64; 2],
    /// End of the view (s); if `None`, the view follows the newest time.
    #[serde(skip)]
    pub pinned: Option<f64>,
    #[serde(skip)]
    pub heights: Heights,
    #[serde(skip)]
    pub hidden: BTreeSet<(u8, String)>,
    #[serde(skip)]
    pub typed: String,
    /// Beginning of a stretch that is being selected (s).
    #[serde(skip)]
    pub selects: Option<f64>,
    #[serde(skip)]
    pub armed: TriggerState,
}

impl Default for Scope {
    fn default() -> Self {
        Self {
            key: None,
            compared: BTreeSet::new(),
            lanes: Vec::new(),
            window: 2.0,
            trigger: Trigger::default(),
            has_cursors: false,
            is_popped: false,
            cursors: [0.0; 2],
            pinned: None,
            heights: Heights::default(),
            hidden: BTreeSet::new(),
            typed: String::new(),
            selects: None,
            armed: TriggerState::default(),
        }
    }
}

impl Scope {
    /// Returns the view (s) when `now` is the newest time.
    pub fn view(&self, now: f64) -> (f64, f64) {
        let held = self.armed.end(&self.trigger, self.window, now);
        let end = self.pinned.or(held).unwrap_or(now);
        (end - self.window, end)
    }

    pub fn follows(&self) -> bool {
        self.pinned.is_none()
    }

    pub fn update(&mut self, store: &Store, key: u8) {
        if self.trigger.on != On::Nothing && self.pinned.is_none() {
            self.armed.update(&self.trigger, store, key, self.window);
        }
    }

    /// Makes the window `factor` times as long around the time `about` (s).
    pub fn zoom(&mut self, factor: f64, about: f64, now: f64) {
        let (start, end) = self.view(now);
        let window = (self.window * factor).clamp(WINDOW.0, WINDOW.1);
        let factor = window / (end - start);
        self.window = window;
        self.pinned = Some(about + (end - about) * factor);
    }

    /// Moves the view by `by` (s).
    pub fn pan(&mut self, by: f64, now: f64) {
        self.pinned = Some(self.view(now).1 + by);
    }

    /// Shows `a` to `b` (s).
    pub fn show(&mut self, a: f64, b: f64) {
        self.window = (b - a).abs().clamp(WINDOW.0, WINDOW.1);
        self.pinned = Some(a.max(b));
    }

    pub fn place_cursors(&mut self, now: f64) {
        let (start, end) = self.view(now);
        self.cursors = [start + (end - start) / 3.0, start + (end - start) * 2.0 / 3.0];
    }

    pub fn keys(&self, key: u8) -> Vec<u8> {
        let is_other = |other: &u8| *other != key && usize::from(*other) < telemetry::KEYS;
        let others = self.compared.iter().copied().filter(is_other);
        std::iter::once(key).chain(others).collect()
    }

    /// Compares with further keys, as far as there is room for them.
    pub fn compare(&mut self, keys: impl IntoIterator<Item = u8>) {
        for key in keys {
            if self.compared.len() < COMPARED {
                self.compared.insert(key);
            }
        }
    }

    /// Returns the channels of each plot: as chosen, or as in the paper's figure 6.
    pub fn channels(&self, store: &Store, key: u8) -> Vec<Vec<String>> {
        if self.lanes.is_empty() { usual(store, key) } else { self.lanes.clone() }
    }

    pub fn toggle(&mut self, store: &Store, key: u8, lane: usize, channel: &str) {
        let mut lanes = self.channels(store, key);
        lanes.resize(lanes.len().max(lane + 1), Vec::new());
        let shown = &mut lanes[lane];
        if shown.iter().any(|it| it == channel) {
            shown.retain(|it| it != channel);
        } else {
            shown.push(channel.to_owned());
        }
        self.lanes = lanes;
        // The chosen range was for other values.
        self.heights.fit(lane);
    }
}

/// Returns the usual channels: force and guards above, displacements below.
fn usual(store: &Store, key: u8) -> Vec<Vec<String>> {
    let signals = store.signals(key);
    let guards = signals.iter().filter(|signal| signal.kind() == Kind::Guard);
    // Speeds have another scale.
    let is_place = |unit: &str| !unit.ends_with("/s");
    let places = signals.iter().filter(|it| it.kind() == Kind::State && is_place(&it.unit));
    let mut above = vec!["sent".to_owned()];
    above.extend(guards.take(3).map(|signal| signal.name.clone()));
    let mut below = vec!["position".to_owned()];
    below.extend(places.take(3).map(|signal| signal.name.clone()));
    vec![above, below]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn sees(scope: &Scope, now: f64, start: f64, end: f64) {
        let view = scope.view(now);
        assert!((view.0 - start).abs() < 1e-9 && (view.1 - end).abs() < 1e-9, "{view:?}");
    }

    #[test]
    fn zooming_leaves_the_time_under_the_pointer() {
        let mut scope = Scope::default();
        scope.zoom(0.5, 8.5, 10.0);
        sees(&scope, 10.0, 8.25, 9.25);
        scope.zoom(1e-9, 8.5, 10.0);
        assert!((scope.window - WINDOW.0).abs() < 1e-12);
    }

    #[test]
    fn a_scope_shows_a_few_keys_and_each_once() {
        let mut scope = Scope::default();
        scope.compare([43, 39, 43, 46]);
        assert_eq!(scope.keys(39), [39, 43, 46]);
        assert_eq!(scope.keys(40), [40, 39, 43, 46]);
        scope.compare(0..88);
        assert_eq!(scope.compared.len(), COMPARED);
    }
}
