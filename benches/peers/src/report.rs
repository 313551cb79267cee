//! Writes results.json and table.md.

use std::fs;
use std::path::Path;

use serde::Serialize;

use crate::cases::Case;
use crate::probes::Probe;
use crate::rounds::{Outcome, Plan};
use crate::row::Row;
use crate::table;
use crate::versions::Machine;

#[derive(Serialize)]
struct Results<'a> {
    machine: &'a Machine,
    /// Rounds over all codes, and time for each row in a round (ms).
    rounds: u32,
    budget_ms: f64,
    probes: &'a [Probe],
    skipped: &'a [String],
}

pub(crate) fn write(
    out: &Path,
    cases: &[Case],
    outcome: &Outcome,
    probes: &[Probe],
    plan: Plan,
) -> Result<(), String> {
    let machine = Machine::here();
    let results = Results {
        machine: &machine,
        rounds: plan.rounds,
        budget_ms: plan.budget.as_secs_f64() * 1e3,
        probes,
        skipped: &outcome.skipped,
    };
    let json = json(&results, &outcome.rows).map_err(|error| error.to_string())?;
    let table = table::render(cases, outcome, probes, &machine, plan);
    for (name, text) in [("results.json", json), ("table.md", table)] {
        let path = out.join(name);
        fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))?;
        println!("{}", path.display());
    }
    Ok(())
}

/// Formats an indented head and one row a line, so that a diff of two runs is readable.
fn json(head: &Results<'_>, rows: &[Row]) -> serde_json::Result<String> {
    let head = serde_json::to_string_pretty(head)?;
    let rows: serde_json::Result<Vec<_>> = rows.iter().map(serde_json::to_string).collect();
    let head = head.trim_end_matches('}').trim_end();
    Ok(format!("{head},\n  \"rows\": [\n{}\n  ]\n}}\n", rows?.join(",\n")))
}
