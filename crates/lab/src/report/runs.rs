use super::page::{Table, TableCell};
use super::peers::Peer;
use crate::accuracy::{MeasuredScenario, MethodKind, SequenceVerdict, StudyRow};

const OURS: [(&str, &str); 33] = [
    ("scenario", ""),
    ("method", "method"),
    ("order", "order"),
    ("steps", "steps by"),
    ("tick_s", "tick [s]"),
    ("tolerance_or_budget", "tolerance or budget"),
    ("sequence", "events are"),
    ("right_until", "right until"),
    ("events", "events"),
    ("event_error_s", "error of events [s]"),
    ("state_error", "of states"),
    ("force_error", "of force"),
    ("energy_residual_J", "energy left over [J]"),
    ("ns_per_ms", "ns per ms"),
    ("ns_worst_tick", "ns, worst tick"),
    ("ns_tick_without_event", "no event"),
    ("ns_tick_with_one_event", "one event"),
    ("ns_tick_with_most_events", "most events"),
    ("most_events_in_a_tick", "most events of a tick"),
    ("evaluations_per_ms", "evaluations per ms"),
    ("derivatives_per_ms", "derivatives per ms"),
    ("jacobians_per_ms", "Jacobians per ms"),
    ("guards_per_ms", "guards per ms"),
    ("readouts_per_ms", "readouts per ms"),
    ("worst_derivatives", "worst tick: derivatives"),
    ("worst_jacobians", "Jacobians"),
    ("worst_guards", "guards"),
    ("steps_certain", "steps certain"),
    ("steps_unknown", "unknown"),
    ("expected", "due was"),
    ("found", "found"),
    ("failure", "failure"),
    ("reference", ""),
];

pub(super) fn ours(measured: &MeasuredScenario) -> Table {
    Table::new(OURS).with(measured.rows.iter().map(|row| cells(row, measured)))
}

pub(super) fn all(tables: Vec<Table>) -> Table {
    Table::new(OURS).with(tables.into_iter().flat_map(|it| it.rows))
}

fn cells(row: &StudyRow, measured: &MeasuredScenario) -> [TableCell; OURS.len()] {
    let StudyRow { verdict, counts, times, .. } = row;
    let (words, number, maybe) = (TableCell::words, TableCell::Number, TableCell::maybe);
    let [sequence, right_until, expected, found, failure] = sequence(&verdict.sequence);
    [
        words(measured.entry.name),
        words(row.method.name),
        TableCell::Words(row.method.order.to_string()),
        words(steps(row.method.kind)),
        number(row.setting.tick),
        maybe(row.setting.tolerance),
        sequence,
        right_until,
        TableCell::Words(verdict.events.to_string()),
        maybe(verdict.event_error),
        maybe(verdict.state_error),
        maybe(verdict.force_error),
        maybe(row.energy_residual),
        number(times.per_ms),
        number(times.worst_tick),
        maybe(times.without_event),
        maybe(times.with_one_event),
        maybe(times.with_most_events),
        TableCell::Words(times.most_events.to_string()),
        number(counts.evaluations_per_ms),
        number(counts.derivatives_per_ms),
        number(counts.jacobians_per_ms),
        number(counts.guards_per_ms),
        number(counts.readouts_per_ms),
        TableCell::Words(counts.worst_derivatives.to_string()),
        TableCell::Words(counts.worst_jacobians.to_string()),
        TableCell::Words(counts.worst_guards.to_string()),
        TableCell::Words(counts.steps_certain.to_string()),
        TableCell::Words(counts.steps_unknown.to_string()),
        expected,
        found,
        failure,
        words(measured.entry.source),
    ]
}

const fn steps(kind: MethodKind) -> &'static str {
    match kind {
        MethodKind::Fixed => "tick",
        MethodKind::Played => "model",
        MethodKind::Controlled => "tolerance",
        MethodKind::Budgeted => "budget",
    }
}

fn sequence(sequence: &SequenceVerdict) -> [TableCell; 5] {
    const NONE: TableCell = TableCell::Missing;
    let wrong = |it: &str| TableCell::WrongWords(it.to_owned());
    match sequence {
        SequenceVerdict::Right => [TableCell::words("right"), NONE, NONE, NONE, NONE],
        SequenceVerdict::Wrong(it) => [
            wrong("wrong"),
            wrong(&it.index.to_string()),
            wrong(&it.expected),
            wrong(&it.found),
            NONE,
        ],
        SequenceVerdict::Failed(why) => [wrong("failed"), NONE, NONE, NONE, wrong(why)],
    }
}

const THEIRS: [&str; 13] = [
    "code",
    "version",
    "method",
    "setting",
    "tolerance or step",
    "events",
    "error of events [s]",
    "of states",
    "right-hand sides",
    "ns per ms, least",
    "median",
    "wrong",
    "note",
];

pub(super) fn theirs(peers: &[&Peer]) -> Table {
    let row = |peer: &&Peer| {
        let words = [&peer.code, &peer.version, &peer.method, &peer.setting];
        let events = peer.events.map_or(TableCell::Missing, |it| TableCell::words(it.to_string()));
        let errors =
            [peer.event_error_s, peer.state_error].map(|it| it.filter(|_| peer.sequence_ok));
        let failure = peer.failure.as_deref().unwrap_or("wrong events").to_owned();
        let failure =
            if peer.sequence_ok { TableCell::Missing } else { TableCell::WrongWords(failure) };
        let costs = [peer.rhs, peer.ns_per_ms_min, peer.ns_per_ms_median];
        let numbers = errors.into_iter().chain(costs).map(TableCell::maybe);
        let first = words.map(|it| TableCell::words(it.as_str())).into_iter();
        let note = TableCell::words(peer.note.as_deref().unwrap_or_default());
        first
            .chain([TableCell::maybe(peer.tolerance_or_step), events])
            .chain(numbers)
            .chain([failure, note])
            .collect::<Vec<_>>()
    };
    Table::new(THEIRS.map(|it| (it, it))).with(peers.iter().map(row))
}
