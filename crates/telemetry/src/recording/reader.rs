use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::path::{Path, PathBuf};

use documents::shown;
use mcap::records::MessageHeader;

use super::error::{OpenError, ReadError};
use super::format::{first_path, part_path};
use super::{
    chunk::Inside, file_bytes::FileBytes, index::ChunkPosition, missing::MissingPiece,
    part_file::PartFile, raw_message::RawMessage, walk::Walk,
};
use crate::{Catalogue, KEYS, Topic, Update, Voice};

/// A recording of one or several files. Opening it reads only the positions of its chunks; a file
/// whose host died has no summary and is read through once.
#[derive(Debug)]
pub struct Recording {
    parts: Vec<PartFile>,
    tear: Option<Tear>,
}

/// Break or gap in a recording.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Tear {
    pub path: PathBuf,
    /// Offset up to which it could be read (B).
    pub at: u64,
    pub(super) what: String,
    /// Data that is readable all the same, and the remedy.
    advice: String,
}

impl fmt::Display for Tear {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.what, self.advice)
    }
}

impl Recording {
    /// Opens the recording that begins with the file `path`, and the files that continue it.
    pub fn open(path: impl AsRef<Path>) -> Result<Self, OpenError> {
        let mut recording = Self::open_file(path.as_ref())?;
        while let Some(next) = recording.next_path(1).filter(|next| next.exists()) {
            match PartFile::open(&next) {
                Ok(part) if recording.goes_on_in(&part) => recording.add(part),
                Ok(_) => return Ok(recording),
                Err(error) => {
                    recording.note_loss(next, &error.to_string());
                    return Ok(recording);
                }
            }
        }
        if let Some(later) = recording.next_path(2).filter(|later| later.exists()) {
            let text = format!("the file before {} is missing", shown(&later));
            recording.note_loss(later, &text);
        }
        Ok(recording)
    }

    /// Like [`Self::open`], but for the one file `path`, whatever recording it belongs to.
    pub fn open_file(path: &Path) -> Result<Self, OpenError> {
        let mut recording = Self { parts: Vec::new(), tear: None };
        recording.add(PartFile::open(path)?);
        Ok(recording)
    }

    /// Like [`Self::open`], but for an embedded recording of one file, under the name `path`.
    pub fn from_bytes(path: impl AsRef<Path>, bytes: &'static [u8]) -> Result<Self, OpenError> {
        let mut recording = Self { parts: Vec::new(), tear: None };
        recording.add(PartFile::of(path.as_ref(), FileBytes::of(bytes))?);
        Ok(recording)
    }

    /// Returns the break or gap in the recording; `None` if it is complete.
    pub const fn tear(&self) -> Option<&Tear> {
        self.tear.as_ref()
    }

    /// Returns the name of the run: see `Catalogue.run`.
    pub fn run(&self) -> &str {
        self.parts.first().map_or("", |part| &part.labels.run)
    }

    pub fn files(&self) -> impl Iterator<Item = &Path> {
        self.parts.iter().map(|part| part.path.as_path())
    }

    /// Returns the times of the first and the last message (ns since 1970); `None` if it is empty.
    pub fn span(&self) -> Option<(u64, u64)> {
        let positions =
            || self.positions().map(|(_, position)| position).filter(|it| it.may_have(|_| true));
        Some((positions().map(|it| it.first).min()?, positions().map(|it| it.last).max()?))
    }

    pub fn bytes_read(&self) -> u64 {
        self.parts.iter().map(PartFile::bytes_read).sum()
    }

    /// Returns messages of these topics from `from` on and before `to` (ns since 1970) in the order
    /// of writing, each with its time. Only chunks that may have such messages are read, one at a
    /// time. After an error the iterator continues behind the damage.
    pub fn read(&self, from: u64, to: u64, topics: &BTreeSet<Topic>) -> Messages<'_> {
        // Nothing is before the beginning of time.
        let last = to.checked_sub(1);
        let topics = if last.is_some() { topics.clone() } else { BTreeSet::new() };
        Messages { recording: self, walk: Walk::new(from, last.unwrap_or(0), topics) }
    }

    pub fn messages(&self) -> Messages<'_> {
        Messages { recording: self, walk: Walk::new(0, u64::MAX, Topic::all().collect()) }
    }

    /// Returns the catalogue; `None` if it was not recorded, an error if all copies are damaged.
    pub fn catalogue(&self) -> Result<Option<Catalogue>, ReadError> {
        let mut wrong = None;
        for message in self.read(0, u64::MAX, &BTreeSet::from([Topic::Catalogue])) {
            match message {
                Ok((_, Update::Catalogue(catalogue))) => return Ok(Some(catalogue)),
                Ok(_) => {}
                // It is repeated further on.
                Err(error) => wrong = wrong.or(Some(error)),
            }
        }
        wrong.map_or(Ok(None), Err)
    }

    /// Returns the voices at `at` in the order of keys, each with its time (both ns since 1970); an
    /// error if all are damaged.
    pub fn voices_at(&self, at: u64) -> Result<Vec<(u64, Voice)>, ReadError> {
        let (mut voices, mut wrong) = (BTreeMap::new(), None);
        let mut last_part = None;
        for (part, position) in self.positions().rev() {
            // A file begins with the voices of all keys.
            let is_complete = last_part.is_some_and(|last: &Path| last != part.path);
            if voices.len() == KEYS || (is_complete && !voices.is_empty()) {
                break;
            }
            last_part = Some(part.path.as_path());
            if at < position.first || !position.may_have(|topic| topic == Topic::Voices) {
                continue;
            }
            match voices_in(part, position, at) {
                Ok(found) => found.into_iter().for_each(|(key, voice)| {
                    voices.entry(key).or_insert(voice);
                }),
                Err(error) => wrong = wrong.or(Some(error)),
            }
        }
        if voices.is_empty() && wrong.is_some() {
            // Lost voices are repeated further on.
            let later = self.positions().filter(|(_, position)| at < position.last);
            voices = later
                .filter(|(_, position)| position.may_have(|topic| topic == Topic::Voices))
                .filter_map(|(part, position)| voices_in(part, position, at).ok())
                .find(|found| !found.is_empty())
                .unwrap_or_default();
        }
        match wrong {
            Some(error) if voices.is_empty() => Err(error),
            Some(_) | None => Ok(voices.into_values().collect()),
        }
    }

    /// Returns the last message of `topic` before `at` (ns since 1970); damage is skipped.
    pub(super) fn last_before(&self, topic: Topic, at: u64) -> Option<RawMessage> {
        let positions = self.positions().rev().filter(|(_, position)| position.first < at);
        let mut positions = positions.filter(|(_, position)| position.may_have(|it| it == topic));
        positions.find_map(|(part, position)| {
            let (mut chunk, mut last) = (part.chunk(position).ok()?, None);
            let is_it =
                |header: &MessageHeader| header.log_time < at && part.topic(header) == Some(topic);
            while let Some(Ok(inside)) = chunk.next(is_it) {
                last = match inside {
                    Inside::Message(header, bytes) => part.raw(&header, bytes),
                    Inside::Channel(..) => last,
                };
            }
            last
        })
    }

    pub(super) fn parts(&self) -> &[PartFile] {
        &self.parts
    }

    pub(super) fn path(&self) -> &Path {
        self.parts.first().map_or(Path::new(""), |part| &part.path)
    }

    fn positions(&self) -> impl DoubleEndedIterator<Item = (&PartFile, &ChunkPosition)> {
        self.parts.iter().flat_map(|part| part.index.positions.iter().map(move |it| (part, it)))
    }

    fn add(&mut self, mut part: PartFile) {
        if self.tear.is_none() {
            self.tear = tear(&part);
        }
        if let Some(before) = self.parts.last_mut() {
            before.note_next(part.began);
        }
        part.began = self.parts.first().map_or(part.began, |first| first.began);
        self.parts.push(part);
    }

    fn note_loss(&mut self, next: PathBuf, why: &str) {
        let (what, advice) = (why.to_owned(), "; what was recorded before it is there".to_owned());
        self.tear.get_or_insert(Tear { path: next, at: 0, what, advice });
    }

    fn next_path(&self, after: u32) -> Option<PathBuf> {
        let (first, last) = (self.parts.first()?, self.parts.last()?);
        let first = first_path(&first.path, first.labels.part);
        Some(part_path(&first, last.labels.part.checked_add(after)?))
    }

    fn goes_on_in(&self, next: &PartFile) -> bool {
        self.parts.last().is_some_and(|last| {
            last.labels.run == next.labels.run
                && last.labels.part.checked_add(1) == Some(next.labels.part)
        })
    }
}

/// Iterator over messages of a recording.
pub struct Messages<'a> {
    recording: &'a Recording,
    walk: Walk,
}

impl Messages<'_> {
    pub(super) fn next_raw(&mut self) -> Option<Result<RawMessage, MissingPiece>> {
        self.walk.next(&self.recording.parts)
    }
}

impl Iterator for Messages<'_> {
    type Item = Result<(u64, Update), ReadError>;

    fn next(&mut self) -> Option<Self::Item> {
        let raw = self.next_raw()?;
        Some(update(raw, self.recording))
    }
}

impl fmt::Debug for Messages<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Messages").field("recording", &self.recording).finish_non_exhaustive()
    }
}

/// Decodes a message of `recording`; returns it with the time at which it was made (ns since 1970).
pub(super) fn update(
    raw: Result<RawMessage, MissingPiece>,
    recording: &Recording,
) -> Result<(u64, Update), ReadError> {
    let raw = raw?;
    let path = || recording.path().to_owned();
    let update = raw.update().map_err(|cause| ReadError::Message { path: path(), cause })?;
    Ok((raw.made, update))
}

/// Returns the last voices of keys in a chunk up to `at`, each with its time (ns since 1970).
fn voices_in(
    part: &PartFile,
    position: &ChunkPosition,
    at: u64,
) -> Result<BTreeMap<u32, (u64, Voice)>, ReadError> {
    let mut voices = BTreeMap::new();
    let mut chunk = part.chunk(position)?;
    while let Some(inside) =
        chunk.next(|header| header.publish_time <= at && part.topic(header) == Some(Topic::Voices))
    {
        let inside = inside.map_err(|error| part.is_damaged(position, &error))?;
        let Inside::Message(header, bytes) = inside else { continue };
        let voice = Update::decode(Topic::Voices, &bytes);
        let voice = voice.map_err(|cause| ReadError::Message { path: part.path.clone(), cause })?;
        if let Update::Voice(voice) = voice {
            voices.insert(voice.key, (header.publish_time, voice));
        }
    }
    Ok(voices)
}

fn tear(part: &PartFile) -> Option<Tear> {
    let path = shown(&part.path);
    let damaged = match part.index.without_summary.map_or(0, |scan| scan.damaged) {
        0 => String::new(),
        1 => ", but for one damaged piece".to_owned(),
        several => format!(", but for {several} damaged pieces"),
    };
    let (what, at) = match part.index.without_summary {
        Some(scan) if scan.has_end => {
            (format!("{path} has a damaged index, and was read through without it"), scan.up_to)
        }
        Some(scan) => {
            let wrong = part.breaks_off().map_or_else(String::new, |it| it.wrong);
            (format!("{path} {wrong}"), scan.up_to)
        }
        None if part.has_damaged_start => (format!("{path} has a damaged beginning"), 0),
        None => return None,
    };
    let there = if at == 0 { "everything else" } else { "everything before" };
    let advice = format!(
        ": {there} is there{damaged}, and `letoff recover {path}` makes a complete file of it"
    );
    Some(Tear { path: part.path.clone(), at, what, advice })
}
