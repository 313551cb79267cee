//! `letoff lab fit`: fits an instrument to a measured action.

use std::{io::Write, path::PathBuf};

use crate::fit::{FitOutcome, FitSubject, MeasuredStroke, fit, read_stroke, write_fit};
use crate::report::PAGE;
use clap::Args;
use documents::{choice, quoted, shown};
use instruments::ModelEntry;
use keyboard::KeyIndex;
use scene::{FittedValues, Instrument, Library, fitted_text};

use super::{Failure, prepare_report, print_report};
use crate::command::stability::ask::key_named;
use cli::progress::counter;

/// Allowed speeds of a static curve (m/s).
const SPEEDS: (f64, f64) = (1e-5, 1.0);

/// What `letoff lab fit` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff lab fit grand slow.csv forte.csv --fit leads,t_pin,button --out fitted
  letoff lab fit synth curve.csv --fit soft,firm --key C4 --speed 5 --json --out fitted
  letoff lab piano fitted/grand-fitted.toml --out report

A file is one stroke of one key: CSV with the columns time_s (s), travel_m (key front, down
positive, 0 at rest, m) and force_n (of the key on the finger, up positive, N). Without time_s it is
a static curve, rows down and then up, at --speed. The instrument's key is driven by the travel, with
its noise smoothed away, and the parameters are those for which the force that comes out is nearest
to the measured force: least squares, each difference over its noise. What the strokes cannot
determine is said, and keeps its value.

Exit codes: 0 done; 1 a model that cannot follow, or a file that could not be written; 2 wrong usage
or data.")]
pub struct FitArgs {
    /// The instrument from which to begin: its name or file.
    #[arg(value_name = "INSTRUMENT")]
    pub instrument: String,
    /// Measured strokes, a file for each.
    #[arg(value_name = "DATA.csv", required = true)]
    pub data: Vec<PathBuf>,
    /// The parameters to fit; without it they are listed with their names.
    #[arg(long, value_name = "P,P", value_delimiter = ',')]
    pub fit: Vec<String>,
    /// The key that was measured.
    #[arg(long, value_name = "NOTE", default_value = "C4")]
    pub key: String,
    /// Speed at which a static curve was taken (mm/s).
    #[arg(long, value_name = "MM/S", default_value_t = 5.0)]
    pub speed: f64,
    /// Standard deviation of the measured forces (N); estimated from each file if not given.
    #[arg(long, value_name = "N")]
    pub noise: Option<f64>,
    /// Folder for the instrument, index.html, parameters.csv, and the charts as SVG.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Prints the result as JSON.
    #[arg(long)]
    pub json: bool,
}

struct FitJob {
    instrument: Instrument,
    key: KeyIndex,
    fitted: Vec<usize>,
    strokes: Vec<MeasuredStroke>,
}

pub(super) fn run(args: &FitArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let job = check(args).map_err(|mistakes| Failure::Usage(mistakes.join("\n")))?;
    prepare_report(Some(&args.out))?;
    let FitJob { instrument, key, fitted, strokes } = &job;
    let runs = counter();
    runs.set_message(instrument.name.clone());
    let subject = FitSubject {
        name: &instrument.name,
        model: instrument.model(),
        values: &instrument.values(key.number()),
        fitted,
        strokes,
        force_noise: args.noise,
    };
    let outcome = fit(&subject, &|| runs.inc(1));
    runs.finish_and_clear();
    let outcome = outcome.map_err(Failure::Running)?;
    // Write the results even if their values are invalid together on another key.
    let text = text(args, &job, &outcome);
    let file = format!("{}-fitted.toml", instrument.name);
    let fitted = text.as_ref().ok().map(|text| (file.as_str(), text.as_str()));
    let written = write_fit(&args.out, &outcome, fitted);
    written.map_err(|error| Failure::Running(error.to_string()))?;
    tell(args, &outcome, fitted.map(|(file, _text)| file), out)?;
    text.map(drop)
}

fn check(args: &FitArgs) -> Result<FitJob, Vec<String>> {
    let mut mistakes = Vec::new();
    let instrument = Instrument::load(&Library::default(), &args.instrument)
        .map_err(|wrong| mistakes.push(mechanism::rendered(&wrong)));
    let key = key_named(&args.key).map_err(|wrong| mistakes.push(wrong));
    if !(SPEEDS.0..=SPEEDS.1).contains(&(1e-3 * args.speed)) {
        let speed = args.speed;
        mistakes
            .push(format!("--speed {speed} is not from 0.01 to 1000 mm/s; give the curve's speed"));
    }
    if let Some(noise) = args.noise.filter(|it| !(it.is_finite() && *it > 0.0)) {
        mistakes.push(format!("--noise {noise} is no spread of forces; give newtons above 0"));
    }
    let model = instrument.as_ref().ok().map(Instrument::model);
    let fitted = model.map_or_else(Vec::new, |model| places(model, &args.fit, &mut mistakes));
    let mut strokes = Vec::new();
    for path in &args.data {
        match read_stroke(path, 1e-3 * args.speed) {
            Ok(stroke) => strokes.push(stroke),
            Err(wrong) => mistakes.extend(wrong.iter().map(ToString::to_string)),
        }
    }
    let rows: usize = strokes.iter().map(MeasuredStroke::len).sum();
    if strokes.len() == args.data.len() && rows <= fitted.len() {
        let count = fitted.len();
        mistakes.push(format!("{rows} rows cannot determine {count} parameters; fit fewer"));
    }
    match (instrument, key) {
        (Ok(instrument), Ok(key)) if mistakes.is_empty() => {
            Ok(FitJob { instrument, key, fitted, strokes })
        }
        _ => Err(mistakes),
    }
}

fn places(model: &ModelEntry, wanted: &[String], mistakes: &mut Vec<String>) -> Vec<usize> {
    let names = || model.parameters.iter().map(|it| it.name);
    let mut found = Vec::new();
    for name in wanted.iter().map(|name| name.trim()) {
        match names().position(|it| it == name) {
            Some(place) if found.contains(&place) => {
                mistakes.push(format!("--fit has {name} twice; name it once"));
            }
            Some(place) => found.push(place),
            None => {
                let (model, name, help) = (model.name, quoted(name), choice(name, names()));
                mistakes.push(format!("{model} has no parameter {name}: {help}"));
            }
        }
    }
    if wanted.is_empty() {
        let line =
            |it: &instruments::Parameter| format!("  {:16} {} [{}]", it.name, it.title, it.unit);
        let lines: Vec<_> = model.parameters.iter().map(line).collect();
        let list = lines.join("\n");
        mistakes.push(format!(
            "--fit must name the parameters, as --fit a,b; of {} there are\n{list}",
            model.name
        ));
    }
    found
}

fn text(args: &FitArgs, job: &FitJob, outcome: &FitOutcome) -> Result<String, Failure> {
    let FitJob { instrument, key, strokes, .. } = job;
    let files: Vec<_> = strokes.iter().map(|it| it.name.as_str()).collect();
    let known = || outcome.parameters.iter().filter(|it| it.interval.is_some());
    let names: Vec<_> = known().map(|it| it.name).collect();
    let doc = format!(
        "{}, with {} fitted to {} on {key} by `letoff lab fit`.",
        instrument.title,
        names.join(", "),
        files.join(", ")
    );
    let values: Vec<_> = known().map(|it| (it.name, it.value)).collect();
    let title = format!("{}, fitted", instrument.title);
    let fitted = FittedValues { title: &title, doc: &doc, key: *key, values: &values };
    fitted_text(&Library::default(), &args.instrument, &fitted).map_err(|wrong| {
        let wrong = mechanism::rendered(&wrong);
        Failure::Running(format!(
            "with the fitted values it is no instrument on all keys, so none was written: fit fewer \
             parameters, or change the others\n{wrong}"
        ))
    })
}

fn tell(
    args: &FitArgs,
    found: &FitOutcome,
    file: Option<&str>,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    if args.json {
        return print_report(found, out);
    }
    for it in &found.parameters {
        let interval = it.interval.map_or_else(
            || "not determined".to_owned(),
            |(low, high)| format!("{low:.4e} to {high:.4e}"),
        );
        let (title, name, unit) = (&it.title, it.name, it.unit);
        let (before, value) = (it.before, it.value);
        writeln!(
            out,
            "{title:24} {name:14} {before:>11.4e} → {value:>11.4e} {unit:10} {interval}"
        )?;
    }
    for it in &found.strokes {
        let (name, before, after) = (&it.name, it.before, it.after);
        writeln!(out, "{name}: {before:.3} N before, {after:.3} N after, of {} rows", it.rows)?;
    }
    for remark in &found.remarks {
        writeln!(out, "{remark}")?;
    }
    for file in std::iter::once(PAGE).chain(file) {
        writeln!(out, "{}", shown(&args.out.join(file)))?;
    }
    Ok(())
}
