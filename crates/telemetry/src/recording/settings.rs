use std::{path::PathBuf, time::Duration};

/// Settings of a recording.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct RecordingSettings {
    /// The first file; the others are called `<name>-0002.mcap` and so on beside it.
    pub path: PathBuf,
    pub run: String,
    pub limits: RecordingLimits,
    /// Longest time for which a message waits in memory; at most a second.
    pub flush: Duration,
}

/// Limits of a recording's files.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct RecordingLimits {
    /// Largest size of a file (B); at least [`RecordingLimits::LEAST_FILE`].
    pub largest_file: u64,
    /// Longest time covered by one file; if `None`, only its size ends it.
    pub longest_file: Option<Duration>,
    /// Largest total size of the recording's files (B). The oldest file is removed before this is
    /// exceeded, so a run of days keeps its last hours; the open file always stays.
    pub largest_total: u64,
    /// Free space of the disk (B) below which the recording ends, complete.
    pub lowest_free: u64,
}

impl RecordingLimits {
    /// Least limit of a file's size (B): in a smaller one schemas would be most of it.
    pub const LEAST_FILE: u64 = 1 << 20;

    /// Returns the effective limit of a file (B), such that there is room for two.
    pub(super) fn file_limit(&self) -> u64 {
        self.largest_file.min(self.largest_total / 2).max(Self::LEAST_FILE)
    }

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
    pub fn new(path: impl Into<PathBuf>, run: impl Into<String>) -> Self {
        Self {
            path: path.into(),
            run: run.into(),
            limits: RecordingLimits::default(),
            flush: Duration::from_millis(500),
        }
    }

    pub(super) fn flush_ns(&self) -> u64 {
        let flush = self.flush.min(Duration::from_secs(1));
        u64::try_from(flush.as_nanos()).unwrap_or(u64::MAX)
    }
}
