//! The tables of all runs: ours, and other codes'.

use super::html::{HtmlCell, folded, table};
use crate::accuracy::{EventMismatch, MeasuredScenario, SequenceVerdict, StudyRow};
use crate::report::peers::Peer;
use crate::report::text::{error, setting, short};

const OURS: [&str; 16] = [
    "method",
    "step",
    "events",
    "error of events [s]",
    "of states",
    "of force",
    "ns per ms",
    "ns, worst tick",
    "no event",
    "one event",
    "most events",
    "derivatives per ms",
    "guards per ms",
    "worst tick: derivatives, guards",
    "steps certain, unknown",
    "energy left over [J]",
];

/// The runs of a scenario.
pub(super) fn ours(measured: &MeasuredScenario) -> String {
    let rows: Vec<_> = measured.rows.iter().map(row).collect();
    folded(&format!("All {} runs", rows.len()), &table(&OURS, &rows))
}

fn row(row: &StudyRow) -> Vec<HtmlCell> {
    let StudyRow { verdict, counts, times, .. } = row;
    let mut cells = vec![
        HtmlCell::words(row.method.name),
        HtmlCell::Number(setting(row)),
        HtmlCell::Number(verdict.events.to_string()),
    ];
    cells.extend(judged(row));
    let most = times.with_most_events.map(|time| (time, times.most_events));
    let most = most.map(|(time, events)| format!("{} ({events})", short(time)));
    let jacobians = if counts.worst_jacobians > 0 {
        format!(" + {} Jacobians", counts.worst_jacobians)
    } else {
        String::new()
    };
    cells.extend([
        HtmlCell::Number(short(times.per_ms)),
        HtmlCell::Number(short(times.worst_tick)),
        HtmlCell::maybe(times.without_event, short),
        HtmlCell::maybe(times.with_one_event, short),
        HtmlCell::Number(most.unwrap_or_default()),
        HtmlCell::Number(short(counts.evaluations_per_ms)),
        HtmlCell::Number(short(counts.guards_per_ms)),
        HtmlCell::Number(format!(
            "{}{jacobians}, {}",
            counts.worst_derivatives, counts.worst_guards
        )),
        HtmlCell::Number(format!("{}, {}", counts.steps_certain, counts.steps_unknown)),
        HtmlCell::Number(error(row.energy_residual)),
    ]);
    cells
}

/// The errors, or what went wrong in their place.
fn judged(row: &StudyRow) -> Vec<HtmlCell> {
    let verdict = &row.verdict;
    let errors = [verdict.event_error, verdict.state_error, verdict.force_error];
    match &verdict.sequence {
        SequenceVerdict::Right => errors.map(|value| HtmlCell::maybe(value, error)).to_vec(),
        SequenceVerdict::Wrong(EventMismatch { index, expected, found }) => {
            let what = format!("wrong after {index}: {found}; due was {expected}");
            vec![HtmlCell::Wrong(what, errors.len())]
        }
        SequenceVerdict::Failed(why) => vec![HtmlCell::Wrong(why.clone(), errors.len())],
    }
}

const THEIRS: [&str; 11] = [
    "code",
    "version",
    "method",
    "setting",
    "tolerance or step",
    "events",
    "error of events [s]",
    "of states",
    "right-hand sides",
    "ns per ms, least (median)",
    "note",
];

/// The runs of other codes on the same problem; nothing if there are none.
pub(super) fn theirs(peers: &[&Peer]) -> String {
    if peers.is_empty() {
        return String::new();
    }
    let rows: Vec<_> = peers.iter().map(|peer| their_row(peer)).collect();
    folded(&format!("All {} runs of other codes", rows.len()), &table(&THEIRS, &rows))
}

fn their_row(peer: &Peer) -> Vec<HtmlCell> {
    let mut cells = vec![
        HtmlCell::words(&peer.code),
        HtmlCell::words(&peer.version),
        HtmlCell::words(&peer.method),
        HtmlCell::words(&peer.setting),
        HtmlCell::Number(peer.knob()),
        HtmlCell::Number(peer.events.map(|events| events.to_string()).unwrap_or_default()),
    ];
    if peer.sequence_ok {
        cells.extend([peer.event_error_s, peer.state_error].map(|it| HtmlCell::maybe(it, error)));
    } else {
        let failure = peer.failure.as_deref().unwrap_or("wrong events");
        cells.push(HtmlCell::Wrong(failure.to_owned(), 2));
    }
    let median = peer.ns_per_ms_median.map(|median| format!(" ({})", short(median)));
    let least = peer.ns_per_ms_min.map(|least| short(least) + &median.unwrap_or_default());
    cells.extend([
        HtmlCell::maybe(peer.rhs, |rhs| format!("{rhs:.0}")),
        HtmlCell::Number(least.unwrap_or_default()),
        HtmlCell::words(peer.note.as_deref().unwrap_or_default()),
    ]);
    cells
}
