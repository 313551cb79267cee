//! The CSV: one row for each run.

use crate::accuracy::{MeasuredScenario, MethodKind, SequenceVerdict, StudyRow};

const HEADER: [&str; 33] = [
    "scenario",
    "method",
    "order",
    "steps",
    "tick_s",
    "tolerance_or_budget",
    "sequence",
    "right_until",
    "events",
    "event_error_s",
    "state_error",
    "force_error",
    "energy_residual_J",
    "ns_per_ms",
    "ns_worst_tick",
    "ns_tick_without_event",
    "ns_tick_with_one_event",
    "ns_tick_with_most_events",
    "most_events_in_a_tick",
    "evaluations_per_ms",
    "derivatives_per_ms",
    "jacobians_per_ms",
    "guards_per_ms",
    "readouts_per_ms",
    "worst_derivatives",
    "worst_jacobians",
    "worst_guards",
    "steps_certain",
    "steps_unknown",
    "expected",
    "found",
    "failure",
    "reference",
];

/// All rows as CSV.
pub(super) fn csv(measured: &[MeasuredScenario]) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(HEADER)?;
    for measured in measured {
        for row in &measured.rows {
            writer.write_record(record(row, measured.entry.source))?;
        }
    }
    let bytes = writer.into_inner().map_err(|error| csv::Error::from(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

fn record(row: &StudyRow, source: &str) -> [String; HEADER.len()] {
    let StudyRow { verdict, counts, times, .. } = row;
    let number = |value: f64| format!("{value:?}");
    let maybe = |value: Option<f64>| value.map(number).unwrap_or_default();
    let [sequence, right_until, expected, found, failure] = sequence(&verdict.sequence);
    [
        row.scenario.to_owned(),
        row.method.name.to_owned(),
        row.method.order.to_string(),
        steps(row.method.kind).to_owned(),
        number(row.setting.tick),
        maybe(row.setting.tolerance),
        sequence,
        right_until,
        verdict.events.to_string(),
        maybe(verdict.event_error),
        maybe(verdict.state_error),
        maybe(verdict.force_error),
        number(row.energy_residual),
        number(times.per_ms),
        number(times.worst_tick),
        maybe(times.without_event),
        maybe(times.with_one_event),
        maybe(times.with_most_events),
        times.most_events.to_string(),
        number(counts.evaluations_per_ms),
        number(counts.derivatives_per_ms),
        number(counts.jacobians_per_ms),
        number(counts.guards_per_ms),
        number(counts.readouts_per_ms),
        counts.worst_derivatives.to_string(),
        counts.worst_jacobians.to_string(),
        counts.worst_guards.to_string(),
        counts.steps_certain.to_string(),
        counts.steps_unknown.to_string(),
        expected,
        found,
        failure,
        source.to_owned(),
    ]
}

/// Where the steps come from, in a word.
const fn steps(kind: MethodKind) -> &'static str {
    match kind {
        MethodKind::Fixed => "tick",
        MethodKind::Played => "model",
        MethodKind::Controlled => "tolerance",
        MethodKind::Budgeted => "budget",
    }
}

/// Verdict, right events, what was expected and found, and what failed.
fn sequence(sequence: &SequenceVerdict) -> [String; 5] {
    let none = String::new;
    match sequence {
        SequenceVerdict::Right => ["right".to_owned(), none(), none(), none(), none()],
        SequenceVerdict::Wrong(it) => [
            "wrong".to_owned(),
            it.index.to_string(),
            it.expected.clone(),
            it.found.clone(),
            none(),
        ],
        SequenceVerdict::Failed(why) => ["failed".to_owned(), none(), none(), none(), why.clone()],
    }
}
