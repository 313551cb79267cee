//! `letoff lab accuracy`: speed against error of every method.

use std::io::Write;
use std::path::PathBuf;

use crate::accuracy::{
    Effort, LONG_RUN, METHODS, SequenceVerdict, StudyChoice, StudyNames, UnknownName, measure,
    measure_drifts,
};
use crate::part::StudyPart;
use crate::report::{self, Machine, PAGE, StoredRuns, StudyReport, read_peers};
use crate::scenario::{BadFile, SCENARIOS, ScenarioEntry};
use clap::Args;

use super::{Failure, print_report};
use cli::progress::{bar, print_lines};
use documents::{choice, quoted, shown};
use figures::parallel::in_parallel;

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
    /// Every second step only, each run timed once and beside others: for a look, not for a claim.
    #[arg(long)]
    pub quick: bool,
    /// Results of other codes on the same problems, as benches/peers writes them.
    #[arg(long, value_name = "FILE")]
    pub peers: Option<PathBuf>,
    /// Runs one share of the study, as 3/16; --join makes the report of all shares.
    #[arg(long, value_name = "I/N", requires = "out")]
    pub part: Option<StudyPart>,
    /// Makes the report of the shares in these folders, and runs nothing.
    #[arg(long, value_name = "DIR", num_args = 1..,
          conflicts_with_all = ["part", "scenario", "method", "quick"])]
    pub join: Vec<PathBuf>,
    /// Prints the main figures as JSON.
    #[arg(long)]
    pub json: bool,
}

fn after_help() -> String {
    let scenarios: Vec<_> = SCENARIOS.iter().map(|entry| entry.name).chain([LONG_RUN]).collect();
    let methods: Vec<_> = METHODS.iter().map(|method| method.name).collect();
    format!(
        "Examples:
  letoff lab accuracy --out report
  letoff lab accuracy --out report --peers benches/peers/results/results.json
  letoff lab accuracy --quick --json --scenario figure-6 pendulum --method rk4 heun
  parallel letoff lab accuracy --part {{}}/4 --out part{{}} ::: 1 2 3 4
  letoff lab accuracy --join part1 part2 part3 part4 --out report

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
    let usage = |lines: Vec<String>| Failure::Usage(lines.join("\n"));
    let (choice, mut report, stored) = check(args).map_err(usage)?;
    if let Some(stored) = stored {
        let joined = stored.into_report(&choice).map_err(usage)?;
        report = StudyReport { peers: report.peers, ..joined };
    } else {
        measure_all(args, &choice, &mut report)?;
    }
    write(args, &choice, &report)?;
    if args.json {
        return print_report(&report.summary(), out);
    }
    tell(args, &report, out)
}

fn write(args: &AccuracyArgs, choice: &StudyChoice, report: &StudyReport) -> Result<(), Failure> {
    let written = args.out.as_deref().map_or(Ok(()), |folder| report.write(choice, folder));
    written.map_err(|error| Failure::Running(error.to_string()))
}

/// Measures one scenario after another; a quick study, without claims of time, all in parallel.
fn measure_all(
    args: &AccuracyArgs,
    choice: &StudyChoice,
    report: &mut StudyReport,
) -> Result<(), Failure> {
    let fail = |error: BadFile| Failure::Running(error.to_string());
    let bar = bar(choice.count());
    print_lines(&bar);
    let one = |entry: &&'static ScenarioEntry| {
        bar.set_message(entry.name);
        measure(entry, choice, &|_run| bar.inc(1))
    };
    let together = if choice.effort.is_quick { choice.scenarios.len() } else { 1 };
    for entries in choice.scenarios.chunks(together.max(1)) {
        let measured: Result<Vec<_>, _> = in_parallel(entries, &one).into_iter().collect();
        report.measured.extend(measured.map_err(fail)?);
        write(args, choice, report)?;
    }
    bar.set_message(LONG_RUN);
    report.drifts = measure_drifts(choice, &|_run| bar.inc(1)).map_err(fail)?;
    bar.finish_and_clear();
    Ok(())
}

type Checked = (StudyChoice, StudyReport, Option<StoredRuns>);

fn check(args: &AccuracyArgs) -> Result<Checked, Vec<String>> {
    let mut mistakes = Vec::new();
    let stored = StoredRuns::read(&args.join).unwrap_or_else(|bad| {
        mistakes.extend(bad);
        None
    });
    let (scenarios, methods) = (args.scenario.clone(), args.method.clone());
    let asked = StudyNames { scenarios, methods, is_quick: args.quick };
    let names = stored.as_ref().map_or(asked, |stored| stored.names.clone());
    let effort = if names.is_quick { Effort::QUICK } else { Effort::FULL };
    let chosen = StudyChoice::new(&names.scenarios, &names.methods, effort);
    let chosen = chosen.map_err(|unknown| mistakes.extend(unknown.iter().map(sentence)));
    let peers = args.peers.as_deref().map_or_else(|| Ok(Vec::new()), read_peers);
    let peers = peers.map_err(|error| mistakes.push(error.to_string()));
    let folder = args.out.as_deref().map_or(Ok(()), report::prepare);
    if let Err(error) = folder {
        mistakes.push(format!("{error}; choose another --out"));
    }
    match (chosen, peers) {
        (Ok(choice), Ok(peers)) if mistakes.is_empty() => {
            let choice = StudyChoice { part: args.part.unwrap_or(StudyPart::WHOLE), ..choice };
            Ok((choice, StudyReport { peers, ..StudyReport::new(Machine::this()) }, stored))
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
