//! How a recording is to be written.

use std::path::PathBuf;
use std::time::Duration;

/// How a recording is to be written.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct RecordingSettings {
    /// The first file; the others are called `<name>-0002.mcap` and so on beside it.
    pub path: PathBuf,
    /// Name of the run: see `Catalogue.run`.
    pub run: String,
    /// Largest size of a file (B); at least [`RecordingSettings::LEAST_FILE`].
    pub largest_file: u64,
    /// Largest size of all files of the recording together (B).
    ///
    /// When they would be, the oldest is removed: of a run that is recorded for days, the last
    /// hours stay. The file that is being written always does.
    pub largest_total: u64,
    /// The recording ends, complete, when less than this is free on the disk (B).
    pub lowest_free: u64,
    /// Longest time for which a message waits in memory; at most a second.
    pub flush: Duration,
}

impl RecordingSettings {
    /// Least limit of a file's size (B): in a smaller one schemas would be most of it.
    pub const LEAST_FILE: u64 = 1 << 20;

    /// Creates settings for `run` at `path`: files of 1 GiB, 16 GiB in all, 1 GiB left free.
    pub fn new(path: impl Into<PathBuf>, run: impl Into<String>) -> Self {
        Self {
            path: path.into(),
            run: run.into(),
            largest_file: 1 << 30,
            largest_total: 16 << 30,
            lowest_free: 1 << 30,
            flush: Duration::from_millis(500),
        }
    }

    /// Returns [`RecordingSettings::flush`] as it is used (ns).
    pub(super) fn flush_ns(&self) -> u64 {
        let flush = self.flush.min(Duration::from_secs(1));
        u64::try_from(flush.as_nanos()).unwrap_or(u64::MAX)
    }

    /// Returns [`RecordingSettings::largest_file`] as it is used (B): there is room for two.
    pub(super) fn file_limit(&self) -> u64 {
        self.largest_file.min(self.largest_total / 2).max(Self::LEAST_FILE)
    }
}
