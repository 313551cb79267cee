//! The reference: events in their order, and states away from them.

use pode::Model;

/// An event that must occur.
#[derive(Clone, PartialEq, Debug)]
pub struct ExpectedEvent<M: Model> {
    /// Time of the event (s).
    pub t: f64,
    pub guard: String,
    pub to: M::Mode,
}

/// State and force at one time.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ReferenceSample<S> {
    /// Time of the sample (s).
    pub t: f64,
    pub state: S,
    /// Force of the kind [`ForceKind`](super::ForceKind), in the readout's unit or that times s.
    pub force: f64,
}

/// The right events and states.
#[derive(Clone, PartialEq, Debug)]
pub struct Reference<M: Model> {
    pub events: Vec<ExpectedEvent<M>>,
    /// `true` if no other event occurs until the end; otherwise only the first events are judged.
    pub is_whole: bool,
    /// Last mode and its entry (s), if events without number lead to it.
    pub rest: Option<(f64, M::Mode)>,
    /// Names of modes; for others `Debug` provides them.
    pub names: Vec<(M::Mode, &'static str)>,
    pub samples: Vec<ReferenceSample<M::State>>,
}

impl<M: Model> Reference<M> {
    pub(crate) fn mode_name(&self, mode: M::Mode) -> String {
        let name = self.names.iter().find(|(known, _)| *known == mode);
        name.map_or_else(|| format!("{mode:?}"), |(_, name)| (*name).to_owned())
    }

    /// Samples every `row` (s) until `until` (s), at least `away` (s) from every time in `events`
    /// and not at the start; `at` returns state and force, where they are known.
    pub(super) fn samples(
        (row, until): (f64, f64),
        away: f64,
        events: &[f64],
        at: impl Fn(f64) -> Option<(M::State, f64)>,
    ) -> Vec<ReferenceSample<M::State>> {
        let rows = (1_u32..).map(|n| f64::from(n) * row).take_while(|t| *t < until + 0.5 * row);
        let is_away = |t: &f64| events.iter().all(|event| (event - t).abs() > away);
        let sample = |t: f64| at(t).map(|(state, force)| ReferenceSample { t, state, force });
        rows.filter(is_away).filter_map(sample).collect()
    }
}
