//! `letoff lab impedance`: Z(f) at a key's front, of a mode, of a voice and of a recorded stroke.

mod ask;
mod recording;

use std::{io::Write, path::PathBuf};

use crate::impedance::{ImpedanceCurve, ImpedanceSummary, write_impedance};
use crate::report::PAGE;
use clap::Args;
use figures::digits::rounded;

use super::{Failure, prepare_report, print_page, print_report};
use ask::ImpedanceQuestion;
use cli::progress::bar;

/// What `letoff lab impedance` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff lab impedance --what grand --out report
  letoff lab impedance --what key-hammer-springs --mode B1 B2 --depth '4 mm' --out report
  letoff lab impedance --what grand-rigid --estimator kalman levant --period '2 ms' --delay '2 ms' --out report
  letoff lab impedance --recording take1.mcap --key C4 --delay '2 ms' --out report

Z is the force on the finger over the finger's velocity. The key is pressed to its depth. There the
model is linearised in the mode in which it then is, or in each that is named: that is what the
equations say. Beside it each voice is shaken by a small sinusoid, tick by tick, and its force is
held for a period and comes late: that is what is felt. Of a recording it is the cross-spectrum of
motion and force, with its coherence. Where Re Z is below zero the key is not passive.
Numbers are in SI units, or with a unit, as '1 ms' and '20 um'.

Exit codes: 0 done; 1 a model or voice that cannot be followed, or a file that could not be
written; 2 wrong usage or recording.")]
pub struct ImpedanceArgs {
    /// An instrument's name or file, or a model's name.
    #[arg(long, value_name = "INSTRUMENT", required_unless_present = "recording")]
    pub what: Option<String>,
    /// A recording of letoff, with the positions and forces of the key.
    #[arg(long, value_name = "FILE", conflicts_with_all = [
        "what", "depth", "mode", "estimator", "amplitude", "period", "encoder_step",
        "jerk_density", "stiffness", "damping", "set",
    ])]
    pub recording: Option<PathBuf>,
    /// Key of the instrument or recording.
    #[arg(long, value_name = "NOTE", default_value = "C4")]
    pub key: String,
    /// How far the key is pressed (m); 6 mm if not given.
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub depth: Option<String>,
    /// Modes in which the model is held; that in which it rests at this depth if none is given.
    #[arg(long, value_name = "MODE", num_args = 1..)]
    pub mode: Vec<String>,
    /// How a voice finds the velocity: a curve for each; kalman if none is given.
    #[arg(long, value_name = "NAME", num_args = 1..)]
    pub estimator: Vec<String>,
    /// Lowest and highest frequency (Hz); as far as the rate allows if not given.
    #[arg(long, value_name = "LOW..HIGH", allow_hyphen_values = true)]
    pub frequency: Option<String>,
    /// Frequencies, evenly spaced in their logarithms.
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = clap::value_parser!(u16).range(2..=2000))]
    pub points: u16,
    /// Largest amplitude by which a voice is shaken (m), at most 0.5 m/s²; 20 µm if not given.
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub amplitude: Option<String>,
    #[command(flatten)]
    pub voice_loop: VoiceLoopArgs,
    /// Values of the model's parameters.
    #[arg(long, value_name = "NAME=VALUE", num_args = 1..)]
    pub set: Vec<String>,
    /// Folder for the report: index.html, impedance.csv and impedance.svg.
    #[arg(long, value_name = "DIR", required_unless_present = "json")]
    pub out: Option<PathBuf>,
    /// Prints the curves as JSON.
    #[arg(long)]
    pub json: bool,
}

/// The loop of a voice.
#[derive(Clone, Debug, Args)]
pub struct VoiceLoopArgs {
    /// Period of a voice's loop (s); 1 ms if not given.
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub period: Option<String>,
    /// From a sample until its force acts (s), at most 16 periods.
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub delay: Option<String>,
    /// Step of the encoder for which a filter is made (m); the samples are exact.
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub encoder_step: Option<String>,
    /// Power density of the jerk that the Kalman filter reckons with (m²/s⁵).
    #[arg(long, value_name = "m^2/s^5", allow_hyphen_values = true)]
    pub jerk_density: Option<String>,
    /// Stiffness of the coupling between model and key (N/m); 0 for none.
    #[arg(long, value_name = "N/m", allow_hyphen_values = true)]
    pub stiffness: Option<String>,
    /// Damping of that coupling (N s/m).
    #[arg(long, value_name = "N*s/m", allow_hyphen_values = true)]
    pub damping: Option<String>,
}

pub(super) fn run(args: &ImpedanceArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let question = ImpedanceQuestion::new(args);
    let question = question.map_err(|mistakes| Failure::Usage(mistakes.join("\n")))?;
    prepare_report(args.out.as_deref())?;
    let bar = bar(question.runs());
    bar.set_message(question.name.clone());
    let curves = question.measure(&|| bar.inc(1));
    bar.finish_and_clear();
    let curves = curves?;
    if let Some(folder) = &args.out {
        let written = write_impedance(folder, &question.name, &curves);
        written.map_err(|error| Failure::Running(error.to_string()))?;
    }
    if args.json {
        return print_report(&ImpedanceSummary::new(&question.name, &curves), out);
    }
    writeln!(out, "{}", question.name)?;
    for curve in &curves {
        tell(curve, out)?;
    }
    print_page(args.out.as_deref(), PAGE, out)
}

fn tell(curve: &ImpedanceCurve, out: &mut dyn Write) -> Result<(), Failure> {
    /// Maximum rows of a table.
    const ROWS: usize = 12;
    writeln!(out, "\n{} ({})", curve.name, curve.remark)?;
    let titles = ["f [Hz]", "|Z| [N·s/m]", "phase [°]", "Re Z [N·s/m]", "coherence"];
    let [f, z, phase, real, coherence] = titles;
    writeln!(out, "{f:>10} {z:>12} {phase:>10} {real:>13} {coherence:>10}")?;
    for it in curve.points.iter().step_by(curve.points.len().div_ceil(ROWS).max(1)) {
        let values = [it.frequency, it.magnitude(), it.phase(), it.real, it.coherence];
        let [f, z, phase, real, coherence] = values.map(rounded);
        writeln!(out, "{f:>10} {z:>12} {phase:>10} {real:>13} {coherence:>10}")?;
    }
    Ok(writeln!(out, "{}", curve.verdict())?)
}
