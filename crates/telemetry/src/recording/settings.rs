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
    pub limits: RecordingLimits,
    /// Longest time for which a message waits in memory; at most a second.
    pub flush: Duration,
}

/// How much of a disk a recording takes, and when it goes on in another file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct RecordingLimits {
    /// Largest size of a file (B); at least [`RecordingLimits::LEAST_FILE`].
    pub largest_file: u64,
    /// Longest time that one file has messages of; without, only its size ends it.
    pub longest_file: Option<Duration>,
    /// Largest size of all files of the recording together (B).
    ///
    /// When they would be, the oldest is removed: of a run that is recorded for days, the last
    /// hours stay. The file that is being written always does.
    pub largest_total: u64,
    /// The recording ends, complete, when less than this is free on the disk (B).
    pub lowest_free: u64,
}

impl RecordingLimits {
    /// Least limit of a file's size (B): in a smaller one schemas would be most of it.
    pub const LEAST_FILE: u64 = 1 << 20;

    /// Returns [`RecordingLimits::largest_file`] as it is used (B): there is room for two.
    pub(super) fn file_limit(&self) -> u64 {
        self.largest_file.min(self.largest_total / 2).max(Self::LEAST_FILE)
    }

    /// Returns [`RecordingLimits::longest_file`] (ns).
    pub(super) fn file_ns(&self) -> u64 {
        let longest = self.longest_file.unwrap_or(Duration::MAX);
        u64::try_from(longest.as_nanos()).unwrap_or(u64::MAX)
    }
}

impl Default for RecordingLimits {
    /// Returns files of 1 GiB, 16 GiB in all, and 1 GiB left free.
    fn default() -> Self {
        Self {
            largest_file: 1 << 30,
            longest_file: None,
            largest_total: 16 << 30,
            lowest_free: 1 << 30,
        }
    }
}

impl RecordingSettings {
    /// Creates settings for `run` at `path`, with the usual limits.
    pub fn new(path: impl Into<PathBuf>, run: impl Into<String>) -> Self {
        Self {
            path: path.into(),
            run: run.into(),
            limits: RecordingLimits::default(),
            flush: Duration::from_millis(500),
        }
    }

    /// Returns [`RecordingSettings::flush`] as it is used (ns).
    pub(super) fn flush_ns(&self) -> u64 {
        let flush = self.flush.min(Duration::from_secs(1));
        u64::try_from(flush.as_nanos()).unwrap_or(u64::MAX)
    }
}
