//! Which figures of a run a panel shows.

use crate::accuracy::StudyRow;
use crate::report::peers::Peer;

/// One run's figures: cost and error, as far as there are any.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct CostErrorPoint {
    /// Whether the events were the right ones.
    pub(super) is_right: bool,
    event_error: Option<f64>,
    state_error: Option<f64>,
    force_error: Option<f64>,
    per_ms: Option<f64>,
    evaluations: Option<f64>,
    without_event: Option<f64>,
    with_one_event: Option<f64>,
    with_most_events: Option<f64>,
    worst_tick: Option<f64>,
}

impl CostErrorPoint {
    pub(super) fn of(row: &StudyRow) -> Self {
        let StudyRow { verdict, counts, times, .. } = row;
        Self {
            is_right: verdict.sequence.is_right(),
            event_error: verdict.event_error,
            state_error: verdict.state_error,
            force_error: verdict.force_error,
            per_ms: Some(times.per_ms),
            evaluations: Some(counts.evaluations_per_ms),
            without_event: times.without_event,
            with_one_event: times.with_one_event,
            with_most_events: times.with_most_events,
            worst_tick: Some(times.worst_tick),
        }
    }

    /// The same of another code's run until `until` (s).
    pub(super) fn of_peer(peer: &Peer, until: f64) -> Self {
        Self {
            is_right: peer.sequence_ok,
            event_error: peer.event_error_s,
            state_error: peer.state_error,
            per_ms: peer.ns_per_ms_min,
            evaluations: peer.rhs.map(|rhs| rhs / (1e3 * until)),
            ..Self::default()
        }
    }
}

/// A figure of a run, if it has it.
type Figure = fn(&CostErrorPoint) -> Option<f64>;

/// What a panel shows: titles and figures of both axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quantities {
    pub(super) x_title: &'static str,
    pub(super) y_title: &'static str,
    pub(super) x: Figure,
    pub(super) y: Figure,
}

const PER_MS: (&str, Figure) = ("ns per simulated ms", |point| point.per_ms);
const EVALUATIONS: (&str, Figure) =
    ("evaluations of the derivative per simulated ms", |point| point.evaluations);

const EVENTS: (&str, Figure) = ("error of event times [s]", |point| point.event_error);
const STATES: (&str, Figure) =
    ("error of states away from events, of their size", |point| point.state_error);

/// A panel of `y` against `x`.
const fn panel(y: (&'static str, Figure), x: (&'static str, Figure)) -> Quantities {
    Quantities { x_title: x.0, y_title: y.0, x: x.1, y: y.1 }
}

/// The panels of our methods, row by row.
pub(super) const OURS: [Quantities; 8] = [
    panel(EVENTS, PER_MS),
    panel(EVENTS, EVALUATIONS),
    panel(STATES, PER_MS),
    panel(("error of the force, of its size", |point| point.force_error), PER_MS),
    panel(EVENTS, ("ns of a tick without event", |point| point.without_event)),
    panel(EVENTS, ("ns of a tick with one event", |point| point.with_one_event)),
    panel(EVENTS, ("ns of a tick with the most events", |point| point.with_most_events)),
    panel(EVENTS, ("ns of the worst tick", |point| point.worst_tick)),
];

/// The panels of other codes.
pub(super) const THEIRS: [Quantities; 4] = [
    panel(EVENTS, PER_MS),
    panel(EVENTS, EVALUATIONS),
    panel(STATES, PER_MS),
    panel(STATES, EVALUATIONS),
];
