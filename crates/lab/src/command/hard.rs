//! `letoff lab hard`: numerical stability on hard cases.

use std::{io::Write, path::PathBuf};

use crate::hard::{HardChoice, HardRow, HardVerdict, measure, write_hard};
use crate::report::PAGE;
use clap::Args;
use cli::progress::bar;
use serde_json::json;

use super::accuracy::sentence;
use super::{Failure, prepare_report, print_page, print_report};

/// What `letoff lab hard` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff lab hard --out report
  letoff lab hard --quick --out report
  letoff lab hard --case 'a detent' --method rk4 dop853 --json

A case fails if rk4, dop853, tsitouras5, by-need or exact is wrong at the shortest of four steps
without a report.

Exit codes: 0 done; 1 a case fails without an explanation in its file, or a file could not be
written; 2 wrong usage.")]
pub struct HardArgs {
    /// Folder for the report: index.html, hard.csv, reports.csv, and the picture.
    #[arg(long, value_name = "DIR", required_unless_present = "json")]
    pub out: Option<PathBuf>,
    /// Runs only the cases of these names.
    #[arg(long, value_name = "NAME", num_args = 1..)]
    pub case: Vec<String>,
    /// Runs only the methods of these names.
    #[arg(long, value_name = "NAME", num_args = 1..)]
    pub method: Vec<String>,
    /// Every second step only, four methods, and no case of many ticks.
    #[arg(long)]
    pub quick: bool,
    /// Prints all results as JSON.
    #[arg(long)]
    pub json: bool,
}

pub(super) fn run(args: &HardArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let choice = HardChoice::new(&args.case, &args.method).map_err(|unknown| {
        Failure::Usage(unknown.iter().map(sentence).collect::<Vec<_>>().join("\n"))
    })?;
    let choice = if args.quick { choice.quick() } else { choice };
    prepare_report(args.out.as_deref())?;
    let bar = bar(choice.count());
    let rows = measure(&choice, &|| bar.inc(1));
    bar.finish_and_clear();
    if let Some(folder) = &args.out {
        write_hard(folder, &rows).map_err(|error| Failure::Running(error.to_string()))?;
    }
    let named = |is_it: fn(&&HardRow) -> bool| -> Vec<&str> {
        rows.iter().filter(is_it).map(|it| it.case.name.as_str()).collect()
    };
    let failed = named(|it| !it.failures().is_empty());
    if args.json {
        print_report(&json!({ "failed": failed, "rows": rows }), out)?;
    } else {
        print_rows(&rows, failed.len(), out)?;
        print_page(args.out.as_deref(), PAGE, out)?;
    }
    let unexplained = named(|it| it.is_unexplained());
    if unexplained.is_empty() {
        return Ok(());
    }
    let names = unexplained.join(", ");
    Err(Failure::Running(format!("cases fail without an explanation: {names}")))
}

fn print_rows(rows: &[HardRow], failed: usize, out: &mut dyn Write) -> Result<(), Failure> {
    for row in rows {
        let mark = if row.failures().is_empty() { " " } else { "✗" };
        writeln!(out, "{mark} {:42} {}", row.case.name, row.outcome())?;
    }
    let runs: Vec<_> = rows.iter().flat_map(|it| &it.runs).collect();
    let count = |verdict| runs.iter().filter(|it| it.verdict == verdict).count();
    let counts = HardVerdict::ALL.map(|it| format!("{} {}", count(it), it.title())).join(", ");
    Ok(writeln!(out, "{failed} of {} cases fail; {} runs: {counts}", rows.len(), runs.len())?)
}
