//! Errors of recordings, each a sentence.

use std::{io, path::PathBuf};

use documents::shown;

use super::format::{FORMAT, LARGEST_CHUNK, LARGEST_RATIO, PROFILE};
use super::missing::MissingPiece;
use crate::topic;

/// Reason why a message is not recorded, or a recording not written.
#[derive(Debug, thiserror::Error)]
pub enum RecordError {
    #[error("{} is there already: choose another name, or move it away", shown(.0))]
    Exists(PathBuf),
    #[error("{} cannot be made: {cause}", shown(.path))]
    Create { path: PathBuf, cause: io::Error },
    #[error("{} cannot be written any further, and ends here: {cause}", shown(.path))]
    Write { path: PathBuf, cause: String },
    #[error("{} cannot be removed to make room, and the recording ends here: {cause}", shown(.path))]
    Remove { path: PathBuf, cause: io::Error },
    #[error(
        "only {} MiB are free where {} lies, less than the {} MiB that are to stay: \
         the recording ends here, and what is recorded is complete",
        .free >> 20, shown(.path), .lowest >> 20
    )]
    LowDisk { path: PathBuf, free: u64, lowest: u64 },
    #[error(
        "{} is not begun: only {} MiB are free there, less than the {} MiB that are to stay; \
         free some, name a file on another disk, or allow less with --min-free",
        shown(.path), .free >> 20, .lowest >> 20
    )]
    NoRoom { path: PathBuf, free: u64, lowest: u64 },
    /// The message is of a key beyond the 88.
    #[error("a message is of key {key}, and there are keys 0 to 87: it is not recorded")]
    NoSuchKey { key: u32 },
    #[error("the recording has ended already: begin another one")]
    Ended,
}

/// Reason why a file is not opened.
#[derive(Debug, thiserror::Error)]
pub enum OpenError {
    #[error("{} cannot be read: {cause}", shown(.path))]
    Io { path: PathBuf, cause: io::Error },
    #[error("{} is no recording: it does not begin as an MCAP file does", shown(.0))]
    NotMcap(PathBuf),
    #[error("{} is an MCAP file, but no recording of {PROFILE}'s: it does not say so", shown(.0))]
    NotOurs(PathBuf),
    #[error(
        "{} is of format {found}, and this {PROFILE} reads {FORMAT}: \
         use the {PROFILE} that recorded it", shown(.path)
    )]
    Version { path: PathBuf, found: String },
    #[error("{} breaks off before anything was recorded: there is nothing to read", shown(.0))]
    Empty(PathBuf),
}

/// Reason why a piece of a recording is not read; later ones may be readable.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    #[error(transparent)]
    Missing(#[from] MissingPiece),
    #[error("{}: {cause}", shown(.path))]
    Message { path: PathBuf, cause: topic::TopicDecodeError },
}

/// Reason why a recording is not exported to tables.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    #[error("{} is there already: choose another folder, or move it away", shown(.0))]
    Exists(PathBuf),
    #[error("{} cannot be written: {cause}", shown(.path))]
    Write { path: PathBuf, cause: String },
    /// Without a catalogue nothing has a name or a time.
    #[error("{} has no catalogue, which says how long a tick is: it cannot be made into tables", shown(.0))]
    NoCatalogue(PathBuf),
    #[error(transparent)]
    Read(#[from] ReadError),
}

pub(super) fn cause(error: &mcap::McapError) -> String {
    if let mcap::McapError::Io(error) = error {
        error.to_string()
    } else if let mcap::McapError::ChunkTooLarge(length) = error {
        let most = LARGEST_CHUNK >> 20;
        format!(
            "a chunk of {length} bytes is larger than {most} MiB or {LARGEST_RATIO} times its record"
        )
    } else {
        error.to_string()
    }
}
