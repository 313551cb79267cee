//! Makes a complete file of one that breaks off.

use std::path::Path;

use super::error::{OpenError, RecordError};
use super::part::Part;
use super::raw::Raw;
use super::reader::Recording;
use super::settings::Compression;

/// What came of a file that was recovered.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Recovered {
    /// Messages in the new file.
    pub messages: u64,
    /// What was wrong with the old one, a sentence each; nothing if it was complete.
    pub wrong: Vec<String>,
}

/// Why a file is not recovered.
#[derive(Debug, thiserror::Error)]
pub enum RecoverError {
    /// It is not opened.
    #[error(transparent)]
    Open(#[from] OpenError),
    /// The new file is not written.
    #[error(transparent)]
    Record(#[from] RecordError),
}

/// Writes what can be read of the file `path` to the new file `to`, which is then complete.
///
/// The old file is not touched.
///
/// # Errors
/// If `path` is no recording, or `to` is there already or cannot be written.
pub fn recover(path: &Path, to: &Path) -> Result<Recovered, RecoverError> {
    let old = Recording::open_file(path)?;
    let labels = &old.parts().first().ok_or_else(|| OpenError::Empty(path.to_owned()))?.labels;
    let mut new = Part::create(to, labels, Compression::default())?;
    let mut wrong: Vec<_> = old.tear().map(ToString::to_string).into_iter().collect();
    let mut messages = old.messages();
    while let Some(raw) = messages.next_raw() {
        match raw {
            Ok(raw) => add(&mut new, &raw)?,
            Err(error) => wrong.push(error.to_string()),
        }
    }
    let messages = new.messages();
    new.finish()?;
    Ok(Recovered { messages, wrong })
}

fn add(part: &mut Part, raw: &Raw) -> Result<(), RecordError> {
    part.add(raw)?;
    if part.is_chunk_full() { part.flush() } else { Ok(()) }
}
