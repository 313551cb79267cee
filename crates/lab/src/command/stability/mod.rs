//! `letoff lab stability`: where a wall or an instrument is stable on a key.

pub(super) mod ask;
pub(super) mod quantities;
pub(super) mod voices;

use std::{io::Write, path::PathBuf};

use crate::report::PAGE;
use crate::stability::{
    StabilityMap, StabilityStudy, StabilitySubject, StabilitySummary, VoiceOrder, write_maps,
};
use clap::Args;
use haptics::EstimatorName;

use super::{Failure, prepare_report, print_page, print_report};
use ask::StabilityQuestion;
use cli::progress::bar;

/// What `letoff lab stability` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff lab stability --out report
  letoff lab stability --x stiffness --y damping --period '0.25 ms' --delay '1 ms' --out report
  letoff lab stability --x 'encoder-step=1 um..1 mm' --y friction --stiffness '5 kN/m' --out report
  letoff lab stability --x finger --y period --damping 5 --out report
  letoff lab stability --what grand-springs --x k1 --y k2 --period '2 ms' --out report
  letoff lab stability --what grand-rigid --x stiffness=200..20000 --y damping=1..200 --out report
  letoff lab stability --what key-hammer-rigid --x period --y jerk-density=0.1..1e6 --estimator kalman --out report

Each cell of a map is one closed loop: the key rests, is knocked once by a weight that is laid on it
and taken away, and is left alone. A wall is F = K x + B v on a key that moves freely; for an
instrument the key has its felts, its return spring and its motor. Theory is drawn into maps of walls
whose velocity is a backward difference.

Axes: stiffness and damping, of the wall or of the coupling between an instrument and its key, which
a stiffness of 0 leaves out; period, delay, encoder-step, friction, mass, device-damping, bandwidth
(of the motor), jerk-density (of the Kalman filter), finger; and parameters of the model.
Numbers are in SI units, or with a unit, as '1 ms' and '50 gf'. An axis over a decade is logarithmic;
fingers always stand from left to right.

Exit codes: 0 done; 1 a map without any stable cell, or a file that could not be written; 2 wrong
usage.")]
pub struct StabilityArgs {
    /// A wall, an instrument's name or file, or a model's name.
    #[arg(long, value_name = "WALL|INSTRUMENT", default_value = "wall")]
    pub what: String,
    /// Key of the instrument.
    #[arg(long, value_name = "NOTE", default_value = "C4")]
    pub key: String,
    /// What changes from left to right, with its ends if they are not the usual ones.
    #[arg(long, value_name = "AXIS[=LOW..HIGH]")]
    pub x: Option<String>,
    /// What changes from below to above.
    #[arg(long, value_name = "AXIS[=LOW..HIGH]")]
    pub y: Option<String>,
    /// How the velocity is found: backward-difference or kalman, a map for each.
    #[arg(long, value_name = "NAME", num_args = 1..)]
    pub estimator: Vec<String>,
    #[command(flatten)]
    pub closed_loop: ClosedLoopArgs,
    /// Values of the model's parameters.
    #[arg(long, value_name = "NAME=VALUE", num_args = 1..)]
    pub set: Vec<String>,
    /// Cells along each axis.
    #[arg(long, value_name = "N", default_value_t = 40, value_parser = clap::value_parser!(u16).range(2..=400))]
    pub cells: u16,
    /// Folder for the report: index.html, map.csv, boundary.csv, and a picture for each map.
    #[arg(long, value_name = "DIR", required_unless_present = "json")]
    pub out: Option<PathBuf>,
    /// Prints the boundaries as JSON.
    #[arg(long)]
    pub json: bool,
}

/// The loop and the key that are tried, where they are no axis.
#[derive(Clone, Debug, Args)]
pub struct ClosedLoopArgs {
    /// Stiffness K of the wall, or of the coupling of an instrument (N/m).
    #[arg(long, value_name = "N/m", allow_hyphen_values = true)]
    pub stiffness: Option<String>,
    /// Damping B of the wall, or of the coupling of an instrument (N s/m).
    #[arg(long, value_name = "N*s/m", allow_hyphen_values = true)]
    pub damping: Option<String>,
    /// Period of the loop (s); 1 ms if not given.
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub period: Option<String>,
    /// From a sample until its force acts (s), at most 16 periods.
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub delay: Option<String>,
    /// Displacement of one count of the encoder (m); 0 for none.
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub encoder_step: Option<String>,
    /// Friction of the key (N); stiction is 1.2 times as much.
    #[arg(long, value_name = "FORCE", allow_hyphen_values = true)]
    pub friction: Option<String>,
    /// Mass of the key at its front (kg).
    #[arg(long, value_name = "MASS", allow_hyphen_values = true)]
    pub mass: Option<String>,
    /// Damping b of the key (N s/m).
    #[arg(long, value_name = "N*s/m", allow_hyphen_values = true)]
    pub device_damping: Option<String>,
    /// Bandwidth of the motor (Hz); 0 for no lag.
    #[arg(long, value_name = "Hz", allow_hyphen_values = true)]
    pub bandwidth: Option<String>,
    /// Power density of the jerk that the Kalman filter reckons with (m²/s⁵).
    #[arg(long, value_name = "m^2/s^5", allow_hyphen_values = true)]
    pub jerk_density: Option<String>,
    /// Finger that presses the key: none, limp, ordinary or stiff.
    #[arg(long, value_name = "NAME")]
    pub finger: Option<String>,
}

pub(super) fn run(args: &StabilityArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let question = StabilityQuestion::new(args);
    let question = question.map_err(|mistakes| Failure::Usage(mistakes.join("\n")))?;
    let voices = question.voices.as_ref();
    let make = |order: &VoiceOrder<'_>| match voices {
        Some(voices) => voices.make(order),
        None => Err("a wall has no voice".to_owned()),
    };
    let subject =
        if voices.is_some() { StabilitySubject::Voice(&make) } else { StabilitySubject::Wall };
    let study = question.study(subject);
    let mistakes = study.mistakes();
    if !mistakes.is_empty() {
        return Err(Failure::Usage(mistakes.join("\n")));
    }
    prepare_report(args.out.as_deref())?;
    let maps = measure(&study, &question.estimators);
    if let Some(folder) = &args.out {
        let written = write_maps(folder, &study, &maps);
        written.map_err(|error| Failure::Running(error.to_string()))?;
    }
    tell(args, &study, &maps, out)?;
    let without: Vec<_> = maps.iter().filter(|it| it.counts().rests == 0).collect();
    if without.is_empty() {
        return Ok(());
    }
    let names: Vec<_> = without.iter().map(|it| it.estimator.name()).collect();
    Err(Failure::Running(format!(
        "{} comes to rest nowhere in the map of {}; try other axes, a shorter period or more \
         damping of the key",
        study.name,
        names.join(" and of ")
    )))
}

fn measure(study: &StabilityStudy<'_>, estimators: &[EstimatorName]) -> Vec<StabilityMap> {
    let bar = bar(study.runs() * estimators.len());
    let maps = estimators.iter().map(|estimator| {
        bar.set_message(estimator.name());
        study.measure(*estimator, &|| bar.inc(1))
    });
    let maps = maps.collect();
    bar.finish_and_clear();
    maps
}

fn tell(
    args: &StabilityArgs,
    study: &StabilityStudy<'_>,
    maps: &[StabilityMap],
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let summary = StabilitySummary::new(study, maps);
    if args.json {
        return print_report(&summary, out);
    }
    for map in &summary.maps {
        let (cells, name) = (&map.cells, map.estimator);
        let failed = if cells.fails > 0 {
            format!(", in {} the model fails", cells.fails)
        } else {
            String::new()
        };
        writeln!(
            out,
            "{}, {name}: {} cells come to rest, {} ring, {} make energy{failed}",
            study.name, cells.rests, cells.rings, cells.makes_energy
        )?;
        for (theory, ratio) in &map.ratios {
            writeln!(
                out,
                "  measured boundary over {theory}: {:.2} to {:.2}, median {:.2}, in {} columns",
                ratio.least, ratio.most, ratio.median, ratio.columns
            )?;
        }
    }
    print_page(args.out.as_deref(), PAGE, out)
}
