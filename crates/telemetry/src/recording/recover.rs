//! Recovery of a complete file from one that breaks off.

use std::fs;
use std::path::{Path, PathBuf};

use documents::shown;

use super::error::{OpenError, RecordError};
use super::{
    latest::Latest, missing::MissingNote, part::RecordingPart, part_file::PartFile,
    raw_message::RawMessage, reader::Recording,
};

/// Result of recovering a file.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Recovered {
    /// Number of messages in the new file.
    pub messages: u64,
    /// Times of the first and the last of them (ns since 1970), if any.
    pub span: Option<(u64, u64)>,
    /// Size of the incomplete record at the old file's end (B).
    pub cut: u64,
    /// Number of damaged pieces of the old file, up to a second each.
    pub damaged: u64,
    /// Damage of the old file, a sentence each; empty if it was complete.
    pub wrong: Vec<String>,
}

/// Reason why a file is not recovered.
#[derive(Debug, thiserror::Error)]
pub enum RecoverError {
    #[error(transparent)]
    Open(#[from] OpenError),
    #[error("{} has nothing in it that could be saved: no file is made of it", shown(.0))]
    Nothing(PathBuf),
    #[error(transparent)]
    Record(#[from] RecordError),
}

/// Writes the readable messages of the file `path` to the new file `to`, which is then complete.
/// The old file is not touched; an incomplete new file is removed.
pub fn recover(path: &Path, to: &Path) -> Result<Recovered, RecoverError> {
    let old = Recording::open_file(path)?;
    let part = old.parts().first().ok_or_else(|| OpenError::Empty(path.to_owned()))?;
    let new = RecordingPart::create(to, &part.labels)?;
    let saved = save(&old, new, part).map_err(RecoverError::from).and_then(|saved| {
        if saved.span.is_some() { Ok(saved) } else { Err(RecoverError::Nothing(path.to_owned())) }
    });
    if saved.is_err() {
        // The file is new; if it cannot be removed it is empty or breaks off.
        let _left = fs::remove_file(to);
    }
    saved
}

fn before_reading(part: &PartFile) -> Recovered {
    let Some(scan) = part.index.without_summary else { return Recovered::default() };
    // Behind the end of the data there was nothing but the index.
    let cut = if scan.has_end { 0 } else { part.size().saturating_sub(scan.up_to) };
    Recovered { cut, ..Recovered::default() }
}

fn save(
    old: &Recording,
    mut new: RecordingPart,
    part: &PartFile,
) -> Result<Recovered, RecordError> {
    let (mut saved, mut latest, mut last) = (before_reading(part), Latest::default(), 0);
    saved.wrong.extend(old.tear().map(|tear| tear.what.clone()));
    let mut messages = old.messages();
    while let Some(raw) = messages.next_raw() {
        match raw {
            Ok(raw) => {
                add(&mut new, &raw)?;
                latest.note(&raw);
                last = raw.at;
                saved.note(raw.at);
            }
            Err(piece) => {
                new.note_missing(&MissingNote::new(&piece))?;
                // An earlier loss of another file is no loss of this one.
                saved.damaged += u64::from(!piece.defect.is_left_out);
                saved.wrong.push(piece.what());
            }
        }
    }
    if let Some(defect) = part.breaks_off() {
        let wrong = defect.recovered_from(&part.path);
        new.note_missing(&MissingNote { wrong, span: None, topics: None })?;
    }
    saved.messages = new.messages();
    // Its time distinguishes this repetition from that at the old file's end: it is later.
    new.write_trailer(&part.labels, &latest, last.saturating_add(1))?;
    new.finish()?;
    Ok(saved)
}

impl Recovered {
    fn note(&mut self, at: u64) {
        let (first, last) = self.span.unwrap_or((at, at));
        self.span = Some((first.min(at), last.max(at)));
    }
}

fn add(part: &mut RecordingPart, raw: &RawMessage) -> Result<(), RecordError> {
    part.add(raw)?;
    if part.is_chunk_full() { part.flush() } else { Ok(()) }
}
