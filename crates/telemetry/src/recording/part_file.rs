//! One file that is being read.

use std::fmt;
use std::fs::File;
use std::io::{self, Read as _, Seek as _, SeekFrom};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};

use mcap::records::{MessageHeader, Record, op};
use mcap::sans_io::{LinearReadEvent, LinearReader, LinearReaderOptions};
use mcap::{MAGIC, McapResult};

use super::chunk::Chunk;
use super::error::{OpenError, ReadError, cause};
use super::format::{LARGEST_CHUNK, Labels, PROFILE};
use super::index::{Index, Place};
use super::raw::Raw;
use crate::Topic;

/// Header and metadata of ours lie in so much of a file's beginning [B].
const HEAD: u64 = 4096;

/// A file's bytes, of which only those are read that are asked for.
#[derive(Debug)]
pub(super) struct Bytes {
    file: Mutex<File>,
    pub(super) size: u64,
    read: AtomicU64,
}

impl Bytes {
    fn open(path: &Path) -> io::Result<Self> {
        let file = File::open(path)?;
        let size = file.metadata()?.len();
        Ok(Self { file: Mutex::new(file), size, read: AtomicU64::new(0) })
    }

    /// `length` bytes from `offset` on.
    pub(super) fn read(&self, offset: u64, length: u64) -> io::Result<Vec<u8>> {
        let mut bytes = vec![0; usize::try_from(length).map_err(io::Error::other)?];
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        file.seek(SeekFrom::Start(offset))?;
        file.read_exact(&mut bytes)?;
        self.read.fetch_add(length, Ordering::Relaxed);
        Ok(bytes)
    }
}

/// One file of a recording.
pub(super) struct PartFile {
    pub(super) path: PathBuf,
    pub(super) labels: Labels,
    pub(super) index: Index,
    bytes: Bytes,
}

impl PartFile {
    pub(super) fn open(path: &Path) -> Result<Self, OpenError> {
        let io = |cause| OpenError::Io { path: path.to_owned(), cause };
        let bytes = Bytes::open(path).map_err(io)?;
        let head = bytes.read(0, bytes.size.min(HEAD)).map_err(io)?;
        let (labels, length) = labels(path, &head)?;
        if !labels.is_ours() {
            return Err(OpenError::Version { path: path.to_owned(), found: labels.format });
        }
        let index = Index::of(&bytes, length).map_err(io)?;
        Ok(Self { path: path.to_owned(), labels, index, bytes })
    }

    /// How much of it was read so far [B].
    pub(super) fn bytes_read(&self) -> u64 {
        self.bytes.read.load(Ordering::Relaxed)
    }

    pub(super) const fn size(&self) -> u64 {
        self.bytes.size
    }

    /// The chunk at `place`.
    pub(super) fn chunk(&self, place: &Place) -> Result<Chunk, ReadError> {
        if place.length > LARGEST_CHUNK as u64 {
            return Err(self.damaged(place, "a length that cannot be"));
        }
        let bytes = self.bytes.read(place.offset, place.length);
        let bytes = bytes.map_err(|cause| ReadError::Io { path: self.path.clone(), cause })?;
        if bytes.first() != Some(&op::CHUNK) {
            return Err(self.damaged(place, "something else than a chunk"));
        }
        Ok(Chunk::new(&bytes))
    }

    pub(super) fn damaged(&self, place: &Place, cause: &str) -> ReadError {
        ReadError::Damaged { path: self.path.clone(), at: place.offset, cause: cause.to_owned() }
    }

    pub(super) fn is_damaged(&self, place: &Place, error: &mcap::McapError) -> ReadError {
        self.damaged(place, &cause(error))
    }

    /// What `header` says the message is of, if it is one of ours.
    pub(super) fn topic(&self, header: &MessageHeader) -> Option<Topic> {
        self.index.topics.get(&header.channel_id).copied()
    }

    pub(super) fn raw(&self, header: &MessageHeader, bytes: Vec<u8>) -> Option<Raw> {
        let topic = self.topic(header)?;
        Some(Raw { at: header.log_time, made: header.publish_time, topic, bytes })
    }
}

impl fmt::Debug for PartFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PartFile").field("path", &self.path).finish_non_exhaustive()
    }
}

/// What a file says of itself at its beginning, and how long that is [B].
fn labels(path: &Path, head: &[u8]) -> Result<(Labels, u64), OpenError> {
    let Some(rest) = head.strip_prefix(MAGIC) else {
        return Err(match MAGIC.strip_prefix(head) {
            Some(_) if !head.is_empty() => OpenError::Empty(path.to_owned()),
            Some(_) | None => OpenError::NotMcap(path.to_owned()),
        });
    };
    let is_whole = (head.len() as u64) < HEAD;
    match read_labels(rest) {
        Ok(Head::Ours(labels, length)) => Ok((labels, MAGIC.len() as u64 + length)),
        Ok(Head::Cut) if is_whole => Err(OpenError::Empty(path.to_owned())),
        Ok(Head::Cut | Head::Foreign) | Err(_) => Err(OpenError::NotOurs(path.to_owned())),
    }
}

/// How a file begins.
enum Head {
    Ours(Labels, u64),
    Foreign,
    Cut,
}

fn read_labels(head: &[u8]) -> McapResult<Head> {
    let options = LinearReaderOptions::default()
        .with_skip_start_magic(true)
        .with_skip_end_magic(true)
        .with_emit_chunks(true)
        .with_record_length_limit(LARGEST_CHUNK);
    let mut reader = LinearReader::new_with_options(options);
    reader.insert(head.len()).copy_from_slice(head);
    reader.notify_read(head.len());
    let mut length = 0;
    while let Some(event) = reader.next_event() {
        let LinearReadEvent::Record { opcode, data } = event? else { return Ok(Head::Cut) };
        length += 9 + data.len() as u64;
        if opcode != op::HEADER && opcode != op::METADATA {
            return Ok(Head::Foreign);
        }
        let record = mcap::parse_record(opcode, data)?;
        if let Record::Header(header) = &record
            && header.profile != PROFILE
        {
            return Ok(Head::Foreign);
        }
        if let Record::Metadata(metadata) = &record
            && let Some(labels) = Labels::of(metadata)
        {
            return Ok(Head::Ours(labels, length));
        }
    }
    Ok(Head::Cut)
}
