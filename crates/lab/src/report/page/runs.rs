//! The tables of all runs: ours, and other codes'.

use super::html::{Cell, folded, table};
use crate::accuracy::{Difference, Measured, Row, Sequence};
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
    "steps certified, likely, unknown",
    "energy left over [J]",
];

/// The runs of a scenario.
pub(super) fn ours(measured: &Measured) -> String {
    let rows: Vec<_> = measured.rows.iter().map(row).collect();
    folded(&format!("All {} runs", rows.len()), &table(&OURS, &rows))
}

fn row(row: &Row) -> Vec<Cell> {
    let Row { verdict, counts, times, .. } = row;
    let mut cells = vec![
        Cell::words(row.method.name),
        Cell::Number(setting(row)),
        Cell::Number(verdict.events.to_string()),
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
        Cell::Number(short(times.per_ms)),
        Cell::Number(short(times.worst_tick)),
        Cell::maybe(times.without_event, short),
        Cell::maybe(times.with_one_event, short),
        Cell::Number(most.unwrap_or_default()),
        Cell::Number(short(counts.evaluations_per_ms)),
        Cell::Number(short(counts.guards_per_ms)),
        Cell::Number(format!("{}{jacobians}, {}", counts.worst_derivatives, counts.worst_guards)),
        Cell::Number(format!(
            "{}, {}, {}",
            counts.steps_certified, counts.steps_likely, counts.steps_unknown
        )),
        Cell::Number(error(row.energy_residual)),
    ]);
    cells
}

/// The errors, or what went wrong in their place.
fn judged(row: &Row) -> Vec<Cell> {
    let verdict = &row.verdict;
    let errors = [verdict.event_error, verdict.state_error, verdict.force_error];
    match &verdict.sequence {
        Sequence::Right => errors.map(|value| Cell::maybe(value, error)).to_vec(),
        Sequence::Wrong(Difference { index, expected, found }) => {
            let what = format!("wrong after {index}: {found}; due was {expected}");
            vec![Cell::Wrong(what, errors.len())]
        }
        Sequence::Failed(why) => vec![Cell::Wrong(why.clone(), errors.len())],
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

fn their_row(peer: &Peer) -> Vec<Cell> {
    let mut cells = vec![
        Cell::words(&peer.code),
        Cell::words(&peer.version),
        Cell::words(&peer.method),
        Cell::words(&peer.setting),
        Cell::Number(peer.knob()),
        Cell::Number(peer.events.map(|events| events.to_string()).unwrap_or_default()),
    ];
    if peer.sequence_ok {
        cells.extend([peer.event_error_s, peer.state_error].map(|it| Cell::maybe(it, error)));
    } else {
        let failure = peer.failure.as_deref().unwrap_or("wrong events");
        cells.push(Cell::Wrong(failure.to_owned(), 2));
    }
    let median = peer.ns_per_ms_median.map(|median| format!(" ({})", short(median)));
    let least = peer.ns_per_ms_min.map(|least| short(least) + &median.unwrap_or_default());
    cells.extend([
        Cell::maybe(peer.rhs, |rhs| format!("{rhs:.0}")),
        Cell::Number(least.unwrap_or_default()),
        Cell::words(peer.note.as_deref().unwrap_or_default()),
    ]);
    cells
}
