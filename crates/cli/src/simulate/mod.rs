//! `letoff simulate`: one key, offline, from a model's name to two tables and a summary.
//!
//! In the order of a run: `args`, `check` (arguments to a plan, with every mistake at once),
//! `input` (s(t) with its derivatives), `drive` (all ticks), `output` (the tables), `plot`,
//! `summary`, `error`. Real time is not here; time is an argument.

mod args;
mod check;
mod drive;
mod error;
mod input;
mod mode;
mod output;
mod plot;
mod summary;
#[cfg(test)]
mod tests;

use std::io::Write;
use std::path::Path;

use instruments::{LoadedModel, Playable, Visitor};
use mechanism::Library;

pub use self::args::{CallerArgs, Reconstruct, SimulateArgs};
use self::check::{Start, TickClock};
pub use self::error::{SimulateError, SimulateMistake};
pub use self::input::InputMistake;
pub use self::input::InputTable;
use self::input::{HeldInput, InputSignal};
use self::output::OutputFiles;
pub use self::output::TimedEvent;
pub use self::summary::MOST_ENERGY_ERROR;
use self::summary::SimulationReport;

/// Simulates as `args` ask; writes warnings on the input to `note`, then the summary to `out`.
///
/// # Errors
/// [`SimulateError::Usage`] with every mistake before anything is run or written; the
/// others while running, with everything produced until then in the files.
pub fn run(
    args: &SimulateArgs,
    out: &mut dyn Write,
    note: &mut dyn FnMut(&str),
) -> Result<(), SimulateError> {
    let model = Library::default().find(&args.model, Path::new(""));
    let mut job = SimulationJob::new(args, note);
    let model = match model {
        Ok(model) => model,
        Err(missing) => {
            job.mistakes.insert(0, SimulateMistake::Model(missing));
            return Err(SimulateError::Usage(job.mistakes));
        }
    };
    let (report, _events) = model.visit(job)?;
    summary::write(&report, args, out).map_err(SimulateError::Summary)?;
    report.into_result(args)
}

/// A finished simulation, for a study.
#[derive(Clone, Debug)]
pub struct Simulated {
    /// Counts, final state and energy audit, as `--json` prints them.
    pub report: serde_json::Value,
    pub events: Vec<TimedEvent>,
}

/// Simulates `model`, whatever `args` call it, and returns its events instead of a summary.
///
/// # Errors
/// Like [`run`].
pub fn simulate(model: &LoadedModel, args: &SimulateArgs) -> Result<Simulated, SimulateError> {
    let mut args = args.clone();
    args.caller.lists_events = true;
    let (report, events) = model.visit(SimulationJob::new(&args, &mut |_remark| ()))?;
    let json = report.json();
    report.into_result(&args)?;
    Ok(Simulated { report: json, events })
}

struct SimulationJob<'a> {
    args: &'a SimulateArgs,
    clock: TickClock,
    input: InputSignal,
    mistakes: Vec<SimulateMistake>,
    note: &'a mut dyn FnMut(&str),
}

impl<'a> SimulationJob<'a> {
    fn new(args: &'a SimulateArgs, note: &'a mut dyn FnMut(&str)) -> Self {
        let mut mistakes = Vec::new();
        let clock = TickClock::check(args, &mut mistakes);
        let mut input_mistakes = Vec::new();
        let input = InputSignal::read(args, &mut input_mistakes);
        mistakes.extend(input_mistakes.into_iter().map(SimulateMistake::Input));
        check::rest(args, &mut mistakes);
        Self { args, clock, input, mistakes, note }
    }
}

impl Visitor for SimulationJob<'_> {
    type Output = Result<(SimulationReport, Vec<TimedEvent>), SimulateError>;

    fn visit<M: Playable>(self, model: M) -> Self::Output {
        let Self { args, clock, input, mut mistakes, note } = self;
        let start = Start::check(&model, args, &input, &mut mistakes);
        let (Some(start), true) = (start, mistakes.is_empty()) else {
            return Err(SimulateError::Usage(mistakes));
        };
        let mut files = OutputFiles::create(args, &start).map_err(SimulateError::Usage)?;
        if let Some(held) = held_note(&input.held(clock.until)) {
            note(&held);
        }
        let report = drive::run(&start, (&clock, &input), &mut files)?;
        Ok((report, files.finish()?))
    }
}

/// Warns of an input whose rows do not cover the whole run.
fn held_note(held: &[HeldInput]) -> Option<String> {
    let told = |it: &HeldInput| format!("s = {:?} from {:?} s to {:?} s", it.s, it.from, it.to);
    let told: Vec<_> = held.iter().map(told).collect();
    let held = told.join(" and ");
    (!told.is_empty()).then(|| format!("the input has no rows there and is held at {held}"))
}
