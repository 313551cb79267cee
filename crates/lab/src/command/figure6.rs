//! `letoff lab figure6`: the paper's experiment at the paper's own rates.

use std::{io::Write, path::PathBuf};

use crate::figure6::{ClosedLoop, Figure6, Pace, TIME_SCALES, figure6, write_figure6};
use crate::report::PAGE;
use clap::Args;

use super::{Failure, prepare_report, print_page, print_report};

/// What `letoff lab figure6` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff lab figure6 --out report
  letoff lab figure6 --time-scale 0.5 --out report
  letoff lab figure6 --json

A hand that grips a simulated handle throws and catches the hammer of the paper's model B, in a
closed loop: encoder of 50 lines an inch, one step of RK4 over 2 ms with the input held, guards seen
once a step, motor. The paper's servo took 7 ms for each step; the same is shown with 2 ms. Beside
it are the same gesture with located events, and how wrong the paper's step is in event times,
force and energy, against the trajectory of an independent program.

Exit codes: 0 done; 1 a file could not be written; 2 wrong usage.")]
pub struct Figure6Args {
    /// Folder for the report: index.html, the figure as SVG and CSV, errors, and figure6.json.
    #[arg(long, value_name = "DIR", required_unless_present = "json")]
    pub out: Option<PathBuf>,
    /// Model seconds per second of the hand, 0.1 to 1; the paper had 2 ms in 7 ms.
    #[arg(long, value_name = "S", default_value_t = Pace::PAPER.time_scale())]
    pub time_scale: f64,
    /// Prints the main figures as JSON.
    #[arg(long)]
    pub json: bool,
}

pub(super) fn run(args: &Figure6Args, out: &mut dyn Write) -> Result<(), Failure> {
    let Some(pace) = Pace::of(args.time_scale) else {
        let (given, (low, high)) = (args.time_scale, TIME_SCALES);
        let sentence = format!(
            "--time-scale {given} is not from {low} to {high}; the paper had 2 ms in 7 ms, 0.2857"
        );
        return Err(Failure::Usage(sentence));
    };
    prepare_report(args.out.as_deref())?;
    let figure = figure6(pace).map_err(|error| Failure::Running(error.to_string()))?;
    if let Some(folder) = &args.out {
        write_figure6(folder, &figure).map_err(|error| Failure::Running(error.to_string()))?;
    }
    if args.json { print_report(&figure.summary(), out) } else { tell(args, &figure, out) }
}

fn tell(args: &Figure6Args, figure: &Figure6, out: &mut dyn Write) -> Result<(), Failure> {
    for it in [&figure.slow_motion, &figure.real_time] {
        writeln!(out, "{}", events(it))?;
    }
    writeln!(out, "against the reference, largest error of")?;
    writeln!(out, "  {:54} {:>10} {:>10} {:>10}", "", "event [s]", "force [N]", "energy [J]")?;
    for it in &figure.errors {
        let errors = [it.event_largest, it.force_largest, it.energy_largest];
        let [event, force, energy] = errors.map(|it| format!("{it:.1e}"));
        writeln!(out, "  {:54} {event:>10} {force:>10} {energy:>10}", it.kind.title())?;
    }
    print_page(args.out.as_deref(), PAGE, out)
}

fn events(it: &ClosedLoop) -> String {
    let events = it.paper.events.iter().map(|event| format!("{} {:.3}", event.guard, event.t));
    let scale = it.pace.time_scale();
    format!("{scale:.4} model seconds a second: {}", events.collect::<Vec<_>>().join(", "))
}
