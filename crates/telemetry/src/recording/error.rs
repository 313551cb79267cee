//! What can go wrong with recordings, each in a sentence.

use std::io;
use std::path::PathBuf;

use super::format::{FORMAT, PROFILE};
use crate::topic;

/// Why something is not recorded.
#[derive(Debug, thiserror::Error)]
pub enum RecordError {
    #[error("{} is there already: choose another name, or move it away", .0.display())]
    Exists(PathBuf),
    /// A file could not be made.
    #[error("{} cannot be made: {cause}", .path.display())]
    Create { path: PathBuf, cause: io::Error },
    /// A file could not be written any further.
    #[error("{} cannot be written any further, and ends here: {cause}", .path.display())]
    Write { path: PathBuf, cause: String },
    /// An older file of the recording could not be removed.
    #[error("{} cannot be removed to make room, and the recording ends here: {cause}", .path.display())]
    Remove { path: PathBuf, cause: io::Error },
    /// The disk is all but full.
    #[error(
        "only {} MiB are free where {} lies, less than the {} MiB that are to stay: \
         the recording ends here, and what is recorded is complete",
        .free >> 20, .path.display(), .lowest >> 20
    )]
    LowDisk {
        path: PathBuf,
        /// What is free (B).
        free: u64,
        /// What is to stay free (B).
        lowest: u64,
    },
    /// A message of a key that there is none of.
    #[error("a message is of key {key}, and there are keys 0 to 87: it is not recorded")]
    NoSuchKey { key: u32 },
    /// It has ended already.
    #[error("the recording has ended already: begin another one")]
    Ended,
}

/// Why a file is not opened.
#[derive(Debug, thiserror::Error)]
pub enum OpenError {
    /// It could not be read.
    #[error("{} cannot be read: {cause}", .path.display())]
    Io { path: PathBuf, cause: io::Error },
    /// It is something else.
    #[error("{} is no recording: it does not begin as an MCAP file does", .0.display())]
    NotMcap(PathBuf),
    /// It is somebody else's.
    #[error("{} is an MCAP file, but no recording of {PROFILE}'s: it does not say so", .0.display())]
    NotOurs(PathBuf),
    /// It is of another version.
    #[error(
        "{} is of format {found}, and this {PROFILE} reads {FORMAT}: \
         use the {PROFILE} that recorded it", .path.display()
    )]
    Version { path: PathBuf, found: String },
    /// It breaks off before the first message.
    #[error("{} breaks off before anything was recorded: there is nothing to read", .0.display())]
    Empty(PathBuf),
}

/// Why a part of a recording is not read; what comes after it may well be.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// It could not be read.
    #[error("{} cannot be read any further: {cause}", .path.display())]
    Io { path: PathBuf, cause: io::Error },
    /// A chunk is damaged.
    #[error(
        "{} is damaged at byte {at} ({cause}): what it had from {from:.3} s to {to:.3} s is left \
         out, and `letoff recover {}` makes a complete file of the rest",
        .path.display(), .path.display()
    )]
    Damaged {
        path: PathBuf,
        /// Where (B).
        at: u64,
        cause: String,
        /// When the first message was made that is lost, since the recording's beginning \[s\].
        from: f64,
        /// When the last one was \[s\].
        to: f64,
        /// Whether there was nothing but the catalogue and voices, which are said again elsewhere.
        is_said_again: bool,
    },
    /// A message is none.
    #[error("{}: {cause}", .path.display())]
    Message { path: PathBuf, cause: topic::TopicDecodeError },
}

/// Why a recording is not made into tables.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    #[error("{} is there already: choose another folder, or move it away", .0.display())]
    Exists(PathBuf),
    /// A file could not be written.
    #[error("{} cannot be written: {cause}", .path.display())]
    Write { path: PathBuf, cause: String },
    /// Without a catalogue nothing has a name or a time.
    #[error("{} has no catalogue, which says how long a tick is: it cannot be made into tables", .0.display())]
    NoCatalogue(PathBuf),
    /// The recording could not be read.
    #[error(transparent)]
    Read(#[from] ReadError),
}

/// What an error of the format means; its own text hides the system's.
pub(super) fn cause(error: &mcap::McapError) -> String {
    if let mcap::McapError::Io(error) = error { error.to_string() } else { error.to_string() }
}
