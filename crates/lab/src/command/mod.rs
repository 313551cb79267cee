//! The command line: `letoff lab STUDY`, a file or folder for each study.

pub mod accuracy;
pub mod figure6;
pub mod fit;
pub mod hard;
pub mod impedance;
pub mod performance;
pub mod piano;
pub mod stability;

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::{Parser, Subcommand};
use documents::shown;

pub(crate) use cli::about::{print_json, print_report};
use cli::{Failure, about};

/// Offline studies with reports.
#[derive(Debug, Parser)]
#[command(name = "letoff-lab", bin_name = "letoff lab", version = about::version(), about,
          arg_required_else_help = true, args_conflicts_with_subcommands = true)]
pub struct LabArgs {
    #[command(subcommand)]
    study: Option<Study>,
    /// Writes man pages, and completions for bash, zsh and fish, into this folder.
    #[arg(long, value_name = "DIR", hide = true)]
    manual: Option<PathBuf>,
}

/// Defines the list of studies: name, arguments and function of each.
macro_rules! studies {
    ($($(#[$doc:meta])* $name:ident($module:ident::$args:ident),)+) => {
        /// The study that was asked for.
        #[derive(Debug, Subcommand)]
        enum Study {
            $($(#[$doc])* $name(Box<$module::$args>),)+
        }

        impl Study {
            fn run(&self, out: &mut dyn Write) -> Result<(), Failure> {
                match self {
                    $(Self::$name(args) => $module::run(args, out),)+
                }
            }
        }
    };
}

studies! {
    /// Speed against error of every method, on problems whose answers are known.
    Accuracy(accuracy::AccuracyArgs),
    /// Numerical stability on hard cases, most of them public bug reports of other tools.
    Hard(hard::HardArgs),
    /// Touch, timing, check, repetition and energy of an instrument, beside measured grands.
    Piano(piano::PianoArgs),
    /// The paper's experiment and its figure 6, at the paper's rates, and how wrong its step was.
    Figure6(figure6::Figure6Args),
    /// An instrument from a measured action: its parameters, with how well they are known.
    Fit(fit::FitArgs),
    /// Where a virtual wall or an instrument is stable on a key: maps, beside theory.
    Stability(stability::StabilityArgs),
    /// Music as people play it: which of it the virtual pianist meets on an instrument.
    Performance(performance::PerformanceArgs),
    /// The mechanical impedance of a mode, of a voice as it is rendered, or of a recorded stroke.
    Impedance(impedance::ImpedanceArgs),
}

/// Runs the study that `args` name; an error carries its sentence and exit code.
pub fn run(args: &LabArgs, out: &mut dyn Write) -> Result<(), Failure> {
    match (&args.study, &args.manual) {
        (Some(study), _) => study.run(out),
        (None, Some(folder)) => cli::manual::write::<LabArgs>("letoff-lab", folder),
        (None, None) => Ok(()),
    }
}

/// Creates the folder of a report before anything is measured.
fn prepare_report(folder: Option<&Path>) -> Result<(), Failure> {
    let prepared = folder.map_or(Ok(()), crate::report::prepare);
    prepared.map_err(|error| Failure::Usage(format!("{error}; choose another --out")))
}

fn print_page(folder: Option<&Path>, page: &str, out: &mut dyn Write) -> Result<(), Failure> {
    let page = folder.map(|folder| folder.join(page)).unwrap_or_default();
    Ok(writeln!(out, "{}", shown(&page))?)
}
