//! Options of recordings by a run and by clients.

use std::time::Duration;

use clap::Args;
use telemetry::recording::RecordingLimits;

use super::arguments::{bytes, seconds};

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
            // A time too long for a clock has no end.
            longest_file: longest.and_then(Result::ok),
            largest_total: self.max_total,
            lowest_free: self.min_free,
        }
    }
}

/// Parses a file size (B) that is large enough for a recording.
fn file_size(text: &str) -> Result<u64, String> {
    match bytes(text)? {
        size if size >= RecordingLimits::LEAST_FILE => Ok(size),
        _ => Err(format!("`{text}` is too small for a recording: give 1MiB or more")),
    }
}
