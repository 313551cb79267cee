//! table.md: per problem the cheapest rows at 1e-9 s, the defaults, and the failures.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use crate::cases::Case;
use crate::probes::Probe;
use crate::rounds::{Outcome, Plan};
use crate::row::Row;
use crate::versions::Machine;

/// Error of event times at which codes are compared (s).
const ERROR: f64 = 1e-9;

pub(crate) fn render(
    cases: &[Case],
    outcome: &Outcome,
    probes: &[Probe],
    machine: &Machine,
    plan: Plan,
) -> String {
    let mut text = heading(machine, plan);
    for case in cases {
        let rows: Vec<&Row> = outcome.rows.iter().filter(|row| row.problem == case.name).collect();
        text.push_str(&problem(case, &rows));
    }
    text.push_str("## Observations\n\nMeasured by this program before the rounds.\n\n");
    for probe in probes {
        line(&mut text, format_args!("- **{}**: {}", probe.code, probe.seen));
    }
    if !outcome.skipped.is_empty() {
        text.push_str("\n## Skipped\n\n");
        outcome.skipped.iter().for_each(|it| line(&mut text, format_args!("- {it}")));
    }
    text
}

fn heading(machine: &Machine, plan: Plan) -> String {
    let mut text = "# Speed against error, side by side\n\n".to_owned();
    let Machine { cpu, cores, kernel, rustc, date } = machine;
    line(&mut text, format_args!("{cpu}, {cores} cores, {kernel}, {rustc}, {date}."));
    let (rounds, budget) = (plan.rounds, plan.budget.as_millis());
    line(
        &mut text,
        format_args!(
            "{rounds} rounds over all codes, {budget} ms for each row in a round; times in ns of \
             CPU time per simulated ms, of whole runs with their events."
        ),
    );
    text + "README.md says what is compared and how; results.json has every row.\n\n"
}

fn problem(case: &Case, rows: &[&Row]) -> String {
    let mut text = String::new();
    line(&mut text, format_args!("## {}\n\n{}.\n", case.name, case.summary));
    text.push_str("### Cheapest with all events in order and within 1e-9 s\n\n");
    let mut best: Vec<&Row> = cheapest(rows).into_values().collect();
    best.sort_by(|a, b| time(a).total_cmp(&time(b)));
    text.push_str(&table(&best));
    let missed = missed(rows, &best);
    if !missed.is_empty() {
        text.push_str("\nNot within 1e-9 s at any setting: the least error of each.\n\n");
        text.push_str(&table(&missed));
    }
    let is_by_states = |row: &&Row| !row.sequence_ok && row.failure.is_none();
    let by_states: Vec<_> = rows.iter().copied().filter(is_by_states).collect();
    if !by_states.is_empty() {
        text.push_str("\n### Without events: judged by states alone\n\n");
        text.push_str(&table(&by_states));
    }
    text.push_str("\n### As they come\n\n");
    let defaults: Vec<_> = rows.iter().copied().filter(|row| row.setting == "default").collect();
    text.push_str(&table(&defaults));
    text.push_str(&failures(rows));
    text
}

/// Code, method and setting (the default counts as "sweep").
type Key<'a> = (&'a str, &'a str, &'a str);

fn key(row: &Row) -> Key<'_> {
    let setting = if row.setting == "default" { "sweep" } else { row.setting.as_str() };
    (&row.code, &row.method, setting)
}

fn time(row: &Row) -> f64 {
    row.ns_per_ms_median.unwrap_or(f64::INFINITY)
}

fn cheapest<'a>(rows: &[&'a Row]) -> BTreeMap<Key<'a>, &'a Row> {
    let mut best: BTreeMap<_, &Row> = BTreeMap::new();
    for row in rows.iter().filter(|row| row.event_error_s.is_some_and(|error| error <= ERROR)) {
        let known = best.entry(key(row)).or_insert(row);
        if time(row) < time(known) {
            *known = row;
        }
    }
    best
}

fn missed<'a>(rows: &[&'a Row], best: &[&Row]) -> Vec<&'a Row> {
    let mut closest: BTreeMap<_, &Row> = BTreeMap::new();
    let is_listed = |row: &Row| best.iter().any(|known| key(known) == key(row));
    let is_swept = |row: &Row| row.sequence_ok && row.setting != "default";
    for row in rows.iter().filter(|row| is_swept(row) && !is_listed(row)) {
        let known = closest.entry(key(row)).or_insert(row);
        if row.event_error_s < known.event_error_s {
            *known = row;
        }
    }
    closest.into_values().collect()
}

fn table(rows: &[&Row]) -> String {
    let mut text =
        "| code | method | setting | tolerance or step | median | minimum | event error \
                    [s] | state error | evaluations |\n|---|---|---|--:|--:|--:|--:|--:|--:|\n"
            .to_owned();
    for row in rows {
        let Row { code, method, setting, .. } = row;
        let version = row.version.trim_matches('-');
        let knob = scientific(Some(row.tolerance_or_step));
        let error = if row.failure.is_none() {
            scientific(row.event_error_s)
        } else {
            "**failed**".to_owned()
        };
        let (median, minimum) = (figure(row.ns_per_ms_median), figure(row.ns_per_ms_min));
        let state = scientific(row.state_error);
        let rhs = row.rhs.map_or_else(|| "–".to_owned(), |count| count.to_string());
        line(
            &mut text,
            format_args!(
                "| {code} {version} | {method} | {setting} | {knob} | {median} | {minimum} | \
                 {error} | {state} | {rhs} |"
            ),
        );
    }
    text
}

fn failures(rows: &[&Row]) -> String {
    let mut by_code: BTreeMap<Key<'_>, Vec<&Row>> = BTreeMap::new();
    for row in rows.iter().filter(|row| row.failure.is_some()) {
        let (code, method, _) = key(row);
        by_code.entry((code, method, &row.setting)).or_default().push(row);
    }
    if by_code.is_empty() {
        return "\nNobody failed.\n\n".to_owned();
    }
    let mut text = "\n### Failures\n\n".to_owned();
    for ((code, method, setting), rows) in by_code {
        let knobs: Vec<_> =
            rows.iter().map(|row| scientific(Some(row.tolerance_or_step))).collect();
        let why = rows.iter().find_map(|row| row.failure.as_deref()).unwrap_or("no reason");
        let knobs = match knobs.as_slice() {
            [one] => format!("at {one}"),
            [first, .., last] => format!("{} times, from {first} to {last}", rows.len()),
            [] => String::new(),
        };
        line(&mut text, format_args!("- {code}, {method}, {setting}, {knobs}: {why}"));
    }
    text + "\n"
}

fn figure(value: Option<f64>) -> String {
    value.map_or_else(
        || "–".to_owned(),
        |value| match value {
            value if value < 10.0 => format!("{value:.2}"),
            value if value < 100.0 => format!("{value:.1}"),
            value => format!("{value:.0}"),
        },
    )
}

fn scientific(value: Option<f64>) -> String {
    value.map_or_else(|| "–".to_owned(), |value| format!("{value:.1e}"))
}

fn line(text: &mut String, arguments: std::fmt::Arguments<'_>) {
    let _ = writeln!(text, "{arguments}");
}
