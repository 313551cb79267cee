//! `letoff lab hard`: numerical stability on hard cases.

use std::{io::Write, path::PathBuf};

use crate::hard::{HardChoice, HardRow, HardSummary, hard_cases, measure, write_hard};
use crate::report::PAGE;
use clap::Args;
use cli::progress::bar;

use super::accuracy::sentence;
use super::{Failure, prepare_report, print_page, print_report};

/// What `letoff lab hard` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff lab hard --out report
  letoff lab hard --quick --out report
  letoff lab hard --case 'a detent' --method rk4 dop853 --json

Every case has a known answer; most are public bug reports of other tools, rebuilt. Every method
runs each at four steps: is the sequence of events right, how large are the errors of times, of
values at the end and of the energy, and does the run report what is wrong? A case fails if rk4,
dop853, tsitouras5, by-need or exact is wrong at the shortest step without a report.

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
    let all = hard_cases().map_err(|error| Failure::Running(error.to_string()))?;
    let choice = HardChoice::new(all, &args.case, &args.method).map_err(|unknown| {
        Failure::Usage(unknown.iter().map(sentence).collect::<Vec<_>>().join("\n"))
    })?;
    let choice = if args.quick { choice.quick() } else { choice };
    prepare_report(args.out.as_deref())?;
    let bar = bar(choice.count());
    let rows = measure(&choice, &|| bar.inc(1));
    bar.finish_and_clear();
    let rows = rows.map_err(|error| Failure::Running(error.to_string()))?;
    if let Some(folder) = &args.out {
        write_hard(folder, &rows).map_err(|error| Failure::Running(error.to_string()))?;
    }
    if args.json {
        print_report(&HardSummary::new(&rows), out)?;
    } else {
        tell(args, &rows, out)?;
    }
    let failed: Vec<_> = rows.iter().filter(|it| it.is_unexplained()).collect();
    if failed.is_empty() {
        return Ok(());
    }
    let names: Vec<_> = failed.iter().map(|it| it.case.name.as_str()).collect();
    Err(Failure::Running(format!("cases fail without an explanation: {}", names.join(", "))))
}

fn tell(args: &HardArgs, rows: &[HardRow], out: &mut dyn Write) -> Result<(), Failure> {
    for row in rows {
        let mark = if row.failures().is_empty() { " " } else { "✗" };
        writeln!(out, "{mark} {:42} {}", row.case.name, row.outcome())?;
    }
    let summary = HardSummary::new(rows);
    let counts: Vec<_> = summary.verdicts.iter().map(|it| format!("{} {}", it.1, it.0)).collect();
    let (cases, failed) = (summary.cases, summary.failed.len());
    writeln!(
        out,
        "{cases} cases, {failed} of them fail; {} runs: {}",
        summary.runs,
        counts.join(", ")
    )?;
    print_page(args.out.as_deref(), PAGE, out)
}
