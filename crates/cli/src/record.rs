//! `letoff record FILE [SCENE]`: runs the host and records everything.

use std::io::Write;
use std::path::PathBuf;

use clap::Args;

use super::Failure;
use super::run::{self, RunArgs};

/// What `letoff record` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff record tuesday.mcap                  the default scene, until its piece is over
  letoff record take1.mcap bach --midi \"Synth\" --duration 60
  letoff record week.mcap --max-duration 3600 --max-total 100GB --min-free 5GB
  letoff replay take1.mcap                    the same again, compared to the last bit")]
pub struct RecordArgs {
    /// The file, which must not be there yet.
    #[arg(value_name = "FILE.mcap", conflicts_with = "record")]
    pub file: PathBuf,
    #[command(flatten)]
    pub run: RunArgs,
}

pub(super) fn run(args: &RecordArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let record = Some(args.file.clone());
    run::run(&RunArgs { record, ..args.run.clone() }, out)
}
