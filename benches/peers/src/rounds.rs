//! All rows, in rounds: a temporary disturbance of the machine affects all codes alike.

use std::path::Path;
use std::time::Duration;

use crate::cases::Case;
use crate::external::External;
use crate::judge::judge;
use crate::log::Log;
use crate::measure;
use crate::row::Row;

#[derive(Clone, Copy, Debug)]
pub(crate) struct Plan {
    pub(crate) rounds: u32,
    pub(crate) budget: Duration,
    /// Exponent of the tightest tolerance 10^-last in the sweep of the programs that are not Rust.
    pub(crate) last: i32,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Outcome {
    pub(crate) rows: Vec<Row>,
    /// `code: reason` of each code that could not run.
    pub(crate) skipped: Vec<String>,
}

pub(crate) fn run(cases: &[Case], externals: &[External], plan: Plan, folder: &Path) -> Outcome {
    let mut outcome = Outcome::default();
    for case in cases {
        for entry in &case.entries {
            let mut log = Log::new(&case.reference.times);
            let ended = (entry.run)(&mut log);
            let verdict = judge(&case.reference, &log.events, &log.states, ended);
            outcome.rows.push(Row::new(case.name, entry, verdict, entry.evaluations()));
        }
    }
    for round in 1..=plan.rounds {
        eprintln!("round {round} of {}", plan.rounds);
        time_entries(cases, plan, &mut outcome.rows);
        let externals: Vec<_> = externals.iter().filter(|it| round <= it.rounds).collect();
        run_externals(cases, &externals, plan, folder, &mut outcome);
    }
    for row in &mut outcome.rows {
        let t_end = cases.iter().find(|case| case.name == row.problem).map(|case| case.t_end);
        row.sum_up(t_end.unwrap_or(1.0));
    }
    outcome
}

fn time_entries(cases: &[Case], plan: Plan, rows: &mut [Row]) {
    let entries = cases.iter().flat_map(|case| &case.entries);
    let mut log = Log::new(&[]);
    for (entry, row) in entries.zip(rows).filter(|(_, row)| row.failure.is_none()) {
        row.times.extend(measure::time(&entry.run, &mut log, plan.budget));
    }
}

fn run_externals(
    cases: &[Case],
    externals: &[&External],
    plan: Plan,
    folder: &Path,
    outcome: &mut Outcome,
) {
    for (case, external) in cases.iter().flat_map(|case| externals.iter().map(move |it| (case, it)))
    {
        match external.run(case, plan.budget, folder, plan.last) {
            Ok(rows) => rows.into_iter().for_each(|row| merge(&mut outcome.rows, row)),
            Err(why) => {
                let line = format!("{} on {}: {why}", external.code, case.name);
                if !outcome.skipped.contains(&line) {
                    eprintln!("skipped: {line}");
                    outcome.skipped.push(line);
                }
            }
        }
    }
}

fn merge(rows: &mut Vec<Row>, row: Row) {
    match rows.iter_mut().find(|known| known.is_same(&row)) {
        Some(known) => known.times.extend(row.times),
        None => rows.push(row),
    }
}
