//! `letoff record FILE [SCENE]`: the host, with everything that it does in a file.

use std::io::Write;
use std::path::PathBuf;
use std::time::Duration;

use clap::Args;
use telemetry::recording::RecordingLimits;

use super::Failure;
use super::arguments::{bytes, seconds};
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

/// How much of the disk recordings take.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Recordings, of --record and of clients")]
pub struct RecordingArgs {
    /// Largest size of a file; the recording goes on in FILE-0002.mcap and so on.
    #[arg(long, value_name = "SIZE", value_parser = file_size, default_value = "1GiB")]
    pub max_size: u64,
    /// Longest time in one file (s); without it, only the size ends a file.
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true)]
    pub max_duration: Option<f64>,
    /// Largest size of all files of a recording together: then the oldest file is removed.
    #[arg(long, value_name = "SIZE", value_parser = file_size, default_value = "16GiB")]
    pub max_total: u64,
    /// Space that stays free on the disk: a recording ends, complete, when there is less.
    #[arg(long, value_name = "SIZE", value_parser = bytes, default_value = "1GiB")]
    pub min_free: u64,
}

impl RecordingArgs {
    pub(super) fn limits(&self) -> RecordingLimits {
        let longest = self.max_duration.map(Duration::try_from_secs_f64);
        RecordingLimits {
            largest_file: self.max_size,
            // What is too long for a clock has no end.
            longest_file: longest.and_then(Result::ok),
            largest_total: self.max_total,
            lowest_free: self.min_free,
        }
    }
}

/// Reads the size of a file that is not too small for a recording (B).
fn file_size(text: &str) -> Result<u64, String> {
    match bytes(text)? {
        size if size >= RecordingLimits::LEAST_FILE => Ok(size),
        _ => Err(format!("`{text}` is too small for a recording: give 1MiB or more")),
    }
}

/// Runs the host and records it.
pub(super) fn run(args: &RecordArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let record = Some(args.file.clone());
    run::run(&RunArgs { record, ..args.run.clone() }, out)
}
