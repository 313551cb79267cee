//! One file that is being read.

use std::fmt;
use std::path::{Path, PathBuf};

use mcap::records::{MessageHeader, Record, op};
use mcap::sans_io::{LinearReadEvent, LinearReader, LinearReaderOptions};
use mcap::{MAGIC, McapResult};

use super::chunk::{Chunk, Inside};
use super::error::{OpenError, cause};
use super::format::{LARGEST_CHUNK, Labels, PROFILE};
use super::index::{self, ChunkPosition, Index};
use super::missing::{Defect, MissingPiece};
use super::{declared::parse_record, file_bytes::FileBytes, raw_message::RawMessage};
use crate::{Topic, Update};

/// Size of the beginning that contains header and metadata (B).
const HEAD: u64 = 4096;

pub(super) struct PartFile {
    pub(super) path: PathBuf,
    pub(super) labels: Labels,
    pub(super) index: Index,
    /// `true` if its beginning is damaged, and its labels were found elsewhere.
    pub(super) has_damaged_start: bool,
    /// Time of the recording's beginning (ns since 1970).
    pub(super) began: u64,
    bytes: FileBytes,
}

impl PartFile {
    pub(super) fn open(path: &Path) -> Result<Self, OpenError> {
        let bytes = FileBytes::open(path);
        Self::of(path, bytes.map_err(|cause| OpenError::Io { path: path.to_owned(), cause })?)
    }

    pub(super) fn of(path: &Path, bytes: FileBytes) -> Result<Self, OpenError> {
        let io = |cause| OpenError::Io { path: path.to_owned(), cause };
        let head = FileStart::of(&bytes.read(0, bytes.size.min(HEAD)).map_err(io)?);
        let index = match (index::summary(&bytes).map_err(io)?, &head) {
            (Some(index), _) => index,
            (None, FileStart::NotMcap) => return Err(OpenError::NotMcap(path.to_owned())),
            (None, FileStart::Ours(_, length)) => index::scan(&bytes, *length).map_err(io)?,
            (None, FileStart::Cut | FileStart::Foreign) => {
                index::scan(&bytes, MAGIC.len() as u64).map_err(io)?
            }
        };
        let mut part = Self {
            path: path.to_owned(),
            labels: Labels::new("", part_number(path)),
            has_damaged_start: !matches!(head, FileStart::Ours(..)),
            began: index.positions.first().map_or(0, |position| position.first),
            index,
            bytes,
        };
        part.labels = part.labels(head)?;
        if !part.labels.is_ours() {
            let found = part.labels.format;
            return Err(OpenError::Version { path: part.path, found });
        }
        Ok(part)
    }

    fn labels(&self, head: FileStart) -> Result<Labels, OpenError> {
        let (first, is_cut) = match head {
            FileStart::Ours(labels, _) => (Some(labels), false),
            FileStart::Cut => (None, true),
            FileStart::Foreign | FileStart::NotMcap => (None, false),
        };
        // Without a readable profile, the file is ours if its topics are.
        if first.is_none() && !self.index.names_ours {
            let is_empty = is_cut && self.bytes.size < HEAD;
            let path = self.path.clone();
            return Err(if is_empty { OpenError::Empty(path) } else { OpenError::NotOurs(path) });
        }
        let copies: Vec<&Labels> = first.iter().chain(&self.index.labels).collect();
        let votes = |it: &Labels| copies.iter().filter(|copy| **copy == it).count();
        // With equal votes a readable copy wins, then the first.
        let best = copies.iter().rev().max_by_key(|it| (votes(it), it.is_ours()));
        Ok(best.map_or_else(|| self.labels_by_catalogue(), |it| (*it).clone()))
    }

    fn labels_by_catalogue(&self) -> Labels {
        let mut labels = self.labels.clone();
        let has_catalogue = |it: &&ChunkPosition| it.may_have(|it| it == Topic::Catalogue);
        let mut positions = self.index.positions.iter().filter(has_catalogue);
        if let Some(run) = positions.find_map(|position| self.run_in(position)) {
            labels.run = run;
        }
        labels
    }

    /// Returns the run that a catalogue in the chunk at `position` names, if one is readable.
    fn run_in(&self, position: &ChunkPosition) -> Option<String> {
        let mut chunk = self.chunk(position).ok()?;
        let is_it = |header: &MessageHeader| self.topic(header) == Some(Topic::Catalogue);
        // The chunk bounds the loop.
        loop {
            let Inside::Message(_, bytes) = chunk.next(is_it)?.ok()? else { continue };
            if let Ok(Update::Catalogue(found)) = Update::decode(Topic::Catalogue, &bytes) {
                return Some(found.run);
            }
        }
    }

    pub(super) fn bytes_read(&self) -> u64 {
        self.bytes.bytes_read()
    }

    pub(super) const fn size(&self) -> u64 {
        self.bytes.size
    }

    pub(super) fn chunk(&self, position: &ChunkPosition) -> Result<Chunk, MissingPiece> {
        if let Some(defect) = &position.defect {
            return Err(self.missing(position, defect.clone()));
        }
        if position.length > LARGEST_CHUNK as u64 {
            return Err(self.damaged(position, "there is no whole chunk"));
        }
        let bytes = self.bytes.read(position.offset, position.length);
        let bytes = bytes.map_err(|cause| {
            let wrong = format!("cannot be read at byte {} ({cause})", position.offset);
            self.missing(position, Defect::here(wrong))
        })?;
        if bytes.first() != Some(&op::CHUNK) {
            return Err(self.damaged(position, "there is something else than a chunk"));
        }
        Ok(Chunk::new(&bytes))
    }

    fn damaged(&self, position: &ChunkPosition, cause: &str) -> MissingPiece {
        self.missing(position, Defect::damage(position.offset, cause))
    }

    fn missing(&self, position: &ChunkPosition, defect: Defect) -> MissingPiece {
        MissingPiece {
            path: self.path.clone(),
            defect,
            span: (position.first, position.last),
            began: self.began,
            topics: position.topics.clone(),
        }
    }

    pub(super) fn breaks_off(&self) -> Option<Defect> {
        let scan = self.index.without_summary.filter(|scan| !scan.has_end);
        let at = scan.map(|scan| {
            let (up_to, size) = (scan.up_to, self.size());
            let why = "because its host died or the file was cut";
            Defect::here(format!("breaks off at byte {up_to} of {size}, {why}"))
        });
        at.or_else(|| self.index.breaks_off.clone().map(Defect::left_out))
    }

    /// Records that the recording continues at `next` (ns since 1970) in another file: if this one
    /// breaks off, the data between are missing.
    pub(super) fn note_next(&mut self, next: u64) {
        let Some(defect) = self.breaks_off() else { return };
        let offset = self.index.without_summary.map_or(self.size(), |scan| scan.up_to);
        let first = self.index.positions.last().map_or(next, |last| last.last);
        self.index.positions.push(ChunkPosition {
            offset,
            length: self.size() - offset,
            first: first.min(next),
            last: next,
            topics: None,
            defect: Some(defect),
        });
    }

    pub(super) fn is_damaged(
        &self,
        position: &ChunkPosition,
        error: &mcap::McapError,
    ) -> MissingPiece {
        self.damaged(position, &cause(error))
    }

    /// Returns the topic of a message, if it is one of Letoff's.
    pub(super) fn topic(&self, header: &MessageHeader) -> Option<Topic> {
        self.index.topics.get(&header.channel_id).copied()
    }

    pub(super) fn raw(&self, header: &MessageHeader, bytes: Vec<u8>) -> Option<RawMessage> {
        let topic = self.topic(header)?;
        Some(RawMessage { at: header.log_time, made: header.publish_time, topic, bytes })
    }
}

impl fmt::Debug for PartFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PartFile").field("path", &self.path).finish_non_exhaustive()
    }
}

enum FileStart {
    Ours(Labels, u64),
    Foreign,
    /// The file is cut off before its labels.
    Cut,
    NotMcap,
}

impl FileStart {
    fn of(head: &[u8]) -> Self {
        let Some(rest) = head.strip_prefix(MAGIC) else {
            let is_cut = !head.is_empty() && MAGIC.starts_with(head);
            return if is_cut { Self::Cut } else { Self::NotMcap };
        };
        read_head(rest).unwrap_or(Self::Foreign)
    }
}

fn part_number(path: &Path) -> u32 {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let number = stem.rsplit_once('-').filter(|(_, number)| number.len() == 4);
    number.and_then(|(_, number)| number.parse().ok()).map_or(1, |number: u32| number.max(1))
}

fn read_head(head: &[u8]) -> McapResult<FileStart> {
    let options = LinearReaderOptions::default()
        .with_skip_start_magic(true)
        .with_skip_end_magic(true)
        .with_emit_chunks(true)
        .with_record_length_limit(LARGEST_CHUNK);
    let mut reader = LinearReader::new_with_options(options);
    reader.insert(head.len()).copy_from_slice(head);
    reader.notify_read(head.len());
    let mut length = MAGIC.len() as u64;
    while let Some(event) = reader.next_event() {
        let LinearReadEvent::Record { opcode, data } = event? else { return Ok(FileStart::Cut) };
        length += 9 + data.len() as u64;
        if opcode != op::HEADER && opcode != op::METADATA {
            return Ok(FileStart::Foreign);
        }
        let record = parse_record(opcode, data)?;
        if let Record::Header(header) = &record
            && header.profile != PROFILE
        {
            return Ok(FileStart::Foreign);
        }
        if let Record::Metadata(metadata) = &record
            && let Some(labels) = Labels::of(metadata)
        {
            return Ok(FileStart::Ours(labels, length));
        }
    }
    Ok(FileStart::Cut)
}
