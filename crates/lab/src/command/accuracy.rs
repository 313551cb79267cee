//! `letoff lab accuracy`: speed against error of every method.

use std::{io::Write, path::PathBuf, time::SystemTime};

use crate::accuracy::{Effort, METHODS, SequenceVerdict, StudyChoice, UnknownName, measure};
use crate::report::{self, Machine, PAGE, StudyReport, read_peers};
use crate::scenario::SCENARIOS;
use clap::Args;

use super::{Failure, print_report};
use cli::progress::bar;
use documents::{choice, quoted, shown};

/// What `letoff lab accuracy` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = after_help())]
pub struct AccuracyArgs {
    /// Folder for the report: index.html, accuracy.csv, and a plot for each scenario.
    #[arg(long, value_name = "DIR", required_unless_present = "json")]
    pub out: Option<PathBuf>,
    /// Studies only the scenarios of these names.
    #[arg(long, value_name = "NAME", num_args = 1..)]
    pub scenario: Vec<String>,
    /// Studies only the methods of these names.
    #[arg(long, value_name = "NAME", num_args = 1..)]
    pub method: Vec<String>,
    /// Every second step only, and little time for each run: for a look, not for a claim.
    #[arg(long)]
    pub quick: bool,
    /// Results of other codes on the same problems, as benches/peers writes them.
    #[arg(long, value_name = "FILE")]
    pub peers: Option<PathBuf>,
    /// Prints the main figures as JSON.
    #[arg(long)]
    pub json: bool,
}

fn after_help() -> String {
    let scenarios: Vec<_> = SCENARIOS.iter().map(|entry| entry.name).collect();
    let methods: Vec<_> = METHODS.iter().map(|method| method.name).collect();
    format!(
        "Examples:
  letoff lab accuracy --out report
  letoff lab accuracy --out report --peers benches/peers/results/results.json
  letoff lab accuracy --quick --json --scenario figure-6 pendulum --method rk4 heun

Scenarios: {}.
Methods: {}.

Times are least times over repeats; run it on an idle machine. What is done is in DIR after
each scenario, however the study ends.

Exit codes: 0 done; 1 a file could not be written; 2 wrong usage or file.",
        scenarios.join(", "),
        methods.join(", ")
    )
}

pub(super) fn run(args: &AccuracyArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let (choice, mut report) = check(args).map_err(|lines| Failure::Usage(lines.join("\n")))?;
    let bar = bar(choice.count());
    for entry in &choice.scenarios {
        bar.set_message(entry.name);
        let measured = measure(entry, &choice, &mut |_run| bar.inc(1));
        report.measured.push(measured.map_err(|error| Failure::Running(error.to_string()))?);
        if let Some(folder) = &args.out {
            report.write(folder).map_err(|error| Failure::Running(error.to_string()))?;
        }
    }
    bar.finish_and_clear();
    if args.json {
        return print_report(&report.summary(), out);
    }
    tell(args, &report, out)
}

fn check(args: &AccuracyArgs) -> Result<(StudyChoice, StudyReport), Vec<String>> {
    let mut mistakes = Vec::new();
    let effort = if args.quick { Effort::QUICK } else { Effort::FULL };
    let chosen = StudyChoice::new(&args.scenario, &args.method, effort);
    let chosen = chosen.map_err(|unknown| mistakes.extend(unknown.iter().map(sentence)));
    let peers = args.peers.as_deref().map_or_else(|| Ok(Vec::new()), read_peers);
    let peers = peers.map_err(|error| mistakes.push(error.to_string()));
    let folder = args.out.as_deref().map_or(Ok(()), report::prepare);
    if let Err(error) = folder {
        mistakes.push(format!("{error}; choose another --out"));
    }
    match (chosen, peers) {
        (Ok(choice), Ok(peers)) if mistakes.is_empty() => {
            let (machine, date) = (Machine::this(), SystemTime::now());
            Ok((choice, StudyReport { machine, date, measured: Vec::new(), peers }))
        }
        _ => Err(mistakes),
    }
}

pub(super) fn sentence(unknown: &UnknownName) -> String {
    let UnknownName { what, name, known } = unknown;
    format!("there is no {what} {}: {}", quoted(name), choice(name, known))
}

fn tell(args: &AccuracyArgs, report: &StudyReport, out: &mut dyn Write) -> Result<(), Failure> {
    let rows = || report.measured.iter().flat_map(|measured| &measured.rows);
    let wrong = rows().filter(|row| row.verdict.sequence != SequenceVerdict::Right).count();
    let page = args.out.as_deref().map(|folder| folder.join(PAGE)).unwrap_or_default();
    Ok(writeln!(
        out,
        "{}: {} scenarios, {} runs, {wrong} of them with wrong events or without an end",
        shown(&page),
        report.measured.len(),
        rows().count(),
    )?)
}
