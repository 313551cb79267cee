//! `letoff lab piano`: an instrument, measured as a player and a technician would.

use std::io::Write;
use std::path::{Path, PathBuf};

use crate::{piano::write_sheet, report::PAGE};
use clap::Args;
use documents::{choice, quoted, shown};
use figures::action::{Examination, Figure, JOBS, PianoSubject, examine, figure_names};
use indicatif::ProgressBar;
use scene::{Instrument, Library};
use serde::Serialize;

use super::{Failure, prepare_report, print_json, print_report};
use cli::progress::bar;

/// What `letoff lab piano` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff lab piano grand --out report
  letoff lab piano grand --beside upright --out report
  letoff lab piano my-instrument.toml --json

The key's front is driven by position and its force is what comes out. Force against travel at
four slow speeds and a fast one; travel time, key bottom and free flight against hammer speed,
pressed and struck, beside three measured grands; softest and loudest tone; check and second
strikes on all 88 keys; repetition; the key's return; energy. What an instrument should show stands
in its file, under [figures].

Exit codes: 0 every figure is within its limits; 1 one is not, or a file could not be written;
2 wrong usage or file.")]
pub struct PianoArgs {
    /// An instrument's name or file.
    #[arg(value_name = "INSTRUMENT")]
    pub instrument: String,
    /// Another instrument, measured beside it.
    #[arg(long, value_name = "INSTRUMENT")]
    pub beside: Option<String>,
    /// Folder for the report: index.html, figures.csv, and the charts as SVG.
    #[arg(long, value_name = "DIR", required_unless_present = "json")]
    pub out: Option<PathBuf>,
    /// Prints the figures as JSON.
    #[arg(long)]
    pub json: bool,
}

#[derive(Serialize)]
struct Sheet<'a> {
    instrument: &'a str,
    failed_strokes: usize,
    figures: &'a [Figure],
}

pub(super) fn run(args: &PianoArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let instruments = [Some(&args.instrument), args.beside.as_ref()];
    let instruments = instruments.into_iter().flatten().map(|it| load(it));
    let instruments = instruments.collect::<Result<Vec<_>, _>>()?;
    prepare_report(args.out.as_deref())?;
    let bar = bar(JOBS * instruments.len());
    let examined: Vec<_> = instruments.iter().map(|it| measure(it, &bar)).collect();
    bar.finish_and_clear();
    if let Some(folder) = &args.out {
        write_sheet(folder, &examined).map_err(|error| Failure::Running(error.to_string()))?;
    }
    tell(args, &examined, out)?;
    let missed: usize = examined.iter().map(|it| it.missed() + it.failed()).sum();
    if missed == 0 { Ok(()) } else { Err(Failure::Running(verdict(&examined))) }
}

fn load(name: &str) -> Result<Instrument, Failure> {
    let instrument = Instrument::load(&Library::default(), name)
        .map_err(|mistakes| Failure::Usage(mechanism::rendered(&mistakes)))?;
    let unknown: Vec<_> = instrument
        .figures
        .iter()
        .filter(|(name, _)| !figure_names().any(|known| known == name))
        .map(|(name, _)| {
            format!("there is no figure {}: {}", quoted(name), choice(name, figure_names()))
        })
        .collect();
    if unknown.is_empty() { Ok(instrument) } else { Err(Failure::Usage(unknown.join("\n"))) }
}

fn measure(instrument: &Instrument, bar: &ProgressBar) -> Examination {
    bar.set_message(instrument.name.clone());
    let subject = PianoSubject {
        name: &instrument.name,
        model: instrument.model(),
        values: &|key| instrument.values(key),
        expected: &instrument.figures,
    };
    examine(&subject, &|| bar.inc(1))
}

fn tell(args: &PianoArgs, examined: &[Examination], out: &mut dyn Write) -> Result<(), Failure> {
    if args.json {
        let sheet = |it: &Examination| {
            let Examination { name, figures, .. } = it.clone();
            (name, it.failed(), figures)
        };
        let sheets: Vec<_> = examined.iter().map(sheet).collect();
        let sheets: Vec<_> = sheets
            .iter()
            .map(|(instrument, failed_strokes, figures)| Sheet {
                instrument,
                failed_strokes: *failed_strokes,
                figures,
            })
            .collect();
        return match sheets.as_slice() {
            [one] => print_report(one, out),
            several => print_json(&several, out),
        };
    }
    for it in examined {
        writeln!(out, "{}", it.name)?;
        for figure in it.figures.iter().filter(|it| it.value.is_some() || it.pass.is_some()) {
            writeln!(out, "  {}", line(figure))?;
        }
    }
    let page = args.out.as_deref().map(|folder: &Path| folder.join(PAGE)).unwrap_or_default();
    Ok(writeln!(out, "{}", shown(&page))?)
}

fn line(figure: &Figure) -> String {
    let value = figure.value.map_or_else(|| "—".to_owned(), |it| format!("{it:.3}"));
    let limits = match (figure.low, figure.high) {
        (Some(low), Some(high)) if low == f64::NEG_INFINITY => format!("at most {high}"),
        (Some(low), Some(high)) if high == f64::INFINITY => format!("at least {low}"),
        (Some(low), Some(high)) => format!("{low} to {high}"),
        _ => String::new(),
    };
    let verdict = match figure.pass {
        Some(true) => "right",
        Some(false) => "WRONG",
        None => "",
    };
    format!("{:66} {value:>10}  {limits:14} {verdict}", figure.title).trim_end().to_owned()
}

fn verdict(examined: &[Examination]) -> String {
    let sentence = |it: &Examination| {
        let wrong = it.figures.iter().filter(|figure| figure.pass == Some(false));
        let names: Vec<_> = wrong.map(|figure| figure.name).collect();
        let failed = match it.failed() {
            0 => String::new(),
            count => format!("; the model failed in {count} strokes"),
        };
        format!(
            "{}: {} figures are not within their limits: {}{failed}",
            it.name,
            names.len(),
            names.join(", ")
        )
    };
    let wrong = examined.iter().filter(|it| it.missed() + it.failed() > 0);
    wrong.map(sentence).collect::<Vec<_>>().join("\n")
}
