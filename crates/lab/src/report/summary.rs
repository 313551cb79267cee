//! The main figures: the cheapest run at each error, and the number of failed runs.

use serde::Serialize;

use super::{Machine, StudyReport, date, peers::Author, text};
use crate::accuracy::{
    MeasuredScenario, MethodKind, ObservedOrder, RunVerdict, SequenceVerdict, StudyRow,
    observed_orders,
};

/// Errors of event times (s) at which speed is compared.
pub(super) const TARGETS: [f64; 3] = [1e-6, 1e-9, 1e-12];

/// Main figures of a report, for programs.
#[derive(Clone, Debug, Serialize)]
pub struct Summary<'a> {
    machine: &'a Machine,
    date: String,
    scenarios: Vec<ScenarioSummary>,
}

#[derive(Clone, Debug, Serialize)]
struct ScenarioSummary {
    name: &'static str,
    runs: usize,
    failures: usize,
    /// Our cheapest run in ticks, as at a deadline, for each target that one meets.
    in_ticks: Vec<Cheapest>,
    /// Our cheapest run with steps by a tolerance, for each target that one meets.
    offline: Vec<Cheapest>,
    side_by_side: [Vec<Cheapest>; 3],
    orders: Vec<ObservedOrder>,
}

/// The cheapest run with an event-time error below a target.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub(super) struct Cheapest {
    /// Largest allowed error (s).
    pub(super) target_s: f64,
    pub(super) who: String,
    pub(super) setting: String,
    pub(super) event_error_s: f64,
    pub(super) ns_per_ms: f64,
}

impl<'a> Summary<'a> {
    pub(super) fn new(report: &'a StudyReport) -> Self {
        let scenario = |measured: &MeasuredScenario| ScenarioSummary {
            name: measured.entry.name,
            runs: measured.rows.len(),
            failures: failures(measured),
            in_ticks: TARGETS.into_iter().filter_map(|it| in_ticks(measured, it)).collect(),
            offline: TARGETS.into_iter().filter_map(|it| offline(measured, it)).collect(),
            side_by_side: [Author::Ours, Author::Others, Author::ByHand].map(|author| {
                TARGETS.into_iter().filter_map(|it| peer(report, measured, author, it)).collect()
            }),
            orders: observed_orders(measured),
        };
        Self {
            machine: &report.machine,
            date: date::utc(report.date),
            scenarios: report.measured.iter().map(scenario).collect(),
        }
    }
}

pub(super) fn failures(measured: &MeasuredScenario) -> usize {
    let wrong = |row: &&StudyRow| row.verdict.sequence != SequenceVerdict::Right;
    measured.rows.iter().filter(wrong).count()
}

/// Errors of event times (s) and states that are rounding.
const ROUNDING: f64 = 1e-11;

/// Returns the largest error (s) of a scenario on which every method of order 2 or higher errs by
/// rounding alone; `None` of another scenario.
pub(super) fn error_where_exact(measured: &MeasuredScenario) -> Option<f64> {
    let rows = measured.rows.iter().filter(|row| row.method.order > 1);
    let errors = rows.map(|row| {
        let RunVerdict { event_error, state_error, .. } = row.verdict;
        event_error.zip(state_error).filter(|it| it.0.max(it.1) < ROUNDING).map(|it| it.0)
    });
    errors.collect::<Option<Vec<f64>>>()?.into_iter().reduce(f64::max)
}

pub(super) fn in_ticks(measured: &MeasuredScenario, target: f64) -> Option<Cheapest> {
    ours(measured, target, |kind| kind != MethodKind::Controlled)
}

pub(super) fn offline(measured: &MeasuredScenario, target: f64) -> Option<Cheapest> {
    ours(measured, target, |kind| kind == MethodKind::Controlled)
}

fn ours(
    measured: &MeasuredScenario,
    target: f64,
    is_of: impl Fn(MethodKind) -> bool,
) -> Option<Cheapest> {
    let run = |row: &StudyRow| {
        Some(Cheapest {
            target_s: target,
            who: row.method.name.to_owned(),
            setting: text::setting(row),
            event_error_s: row.verdict.event_error?,
            ns_per_ms: row.times.per_ms,
        })
    };
    cheapest(measured.rows.iter().filter(|row| is_of(row.method.kind)).filter_map(run))
}

pub(super) fn peer(
    report: &StudyReport,
    measured: &MeasuredScenario,
    author: Author,
    target: f64,
) -> Option<Cheapest> {
    let rows = report.peers_on(measured.entry.name);
    let rows = rows.into_iter().filter(|peer| peer.sequence_ok && peer.author() == author);
    cheapest(rows.filter_map(|peer| {
        Some(Cheapest {
            target_s: target,
            who: peer.curve(),
            setting: peer.knob(),
            event_error_s: peer.event_error_s?,
            ns_per_ms: peer.ns_per_ms_min?,
        })
    }))
}

fn cheapest(runs: impl Iterator<Item = Cheapest>) -> Option<Cheapest> {
    let good = runs.filter(|run| run.event_error_s <= run.target_s);
    good.min_by(|a, b| a.ns_per_ms.total_cmp(&b.ns_per_ms))
}
