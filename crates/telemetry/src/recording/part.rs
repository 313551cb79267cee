//! One file that is being written.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::{fmt, sync::Arc};

use mcap::records::{MessageHeader, Metadata};
use mcap::{Compression, McapError, WriteOptions, Writer, write::NoSeek};

use super::error::{RecordError, cause};
use super::format::{self, CHUNK, LIBRARY, Labels, PROFILE};
use super::{latest::Latest, missing::MissingNote, raw_message::RawMessage};
use crate::{DESCRIPTORS, Topic};

/// Size of a message beside its bytes: its record and its place in the index (B).
const BESIDE_MESSAGE: u64 = 31 + 16;
/// Size of a topic beside its schema: its record, twice, and its index (B).
const BESIDE_TOPIC: u64 = 300;
/// Size of a chunk in the summary, and of each topic in it (B).
const CHUNK_INDEX: (u64, u64) = (120, 10);

/// Size of metadata in the summary (B).
const METADATA_INDEX: u64 = 40;

/// File that is being written. A chunk is built in memory and written whole, so the file of a dying
/// host ends between two chunks or within the last.
pub(super) struct RecordingPart {
    path: PathBuf,
    writer: Writer<NoSeek<CountingFile>>,
    written: Arc<AtomicU64>,
    topics: BTreeSet<Topic>,
    messages: u64,
    /// Size of the open chunk (B).
    pending: u64,
    /// Largest size of the summary (B).
    summary: u64,
}

impl RecordingPart {
    /// Creates the file; an existing one is not touched.
    pub(super) fn create(path: &Path, labels: &Labels) -> Result<Self, RecordError> {
        let file = File::options().write(true).create_new(true).open(path).map_err(|cause| {
            let path = path.to_owned();
            let is_there = cause.kind() == io::ErrorKind::AlreadyExists;
            if is_there { RecordError::Exists(path) } else { RecordError::Create { path, cause } }
        })?;
        let written = Arc::new(AtomicU64::new(0));
        let sink = CountingFile { file: BufWriter::new(file), written: Arc::clone(&written) };
        let begin = || -> Result<_, McapError> {
            let mut writer = options().create(NoSeek::new(sink))?;
            writer.write_metadata(&labels.metadata())?;
            writer.flush()?;
            Ok(writer)
        };
        let writer = begin().map_err(|error| {
            // The file is new, and would block a later attempt.
            let _left = fs::remove_file(path);
            failed(path, &error)
        })?;
        Ok(Self {
            writer,
            path: path.to_owned(),
            written,
            topics: BTreeSet::new(),
            messages: 0,
            pending: 0,
            summary: 1000,
        })
    }

    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    pub(super) const fn messages(&self) -> u64 {
        self.messages
    }

    pub(super) const fn is_pending(&self) -> bool {
        self.pending > 0
    }

    pub(super) const fn is_chunk_full(&self) -> bool {
        self.pending >= CHUNK
    }

    /// Returns the largest size of the complete file with `raw` in it (B).
    pub(super) fn size_with(&self, raw: &RawMessage) -> u64 {
        let more =
            size(raw) + if self.topics.contains(&raw.topic) { 0 } else { 2 * introduction() };
        let pending = self.pending + more;
        // Compression makes nothing larger by more than this.
        let compressed = pending + pending / 128 + 1024;
        self.written.load(Ordering::Relaxed) + compressed + self.summary + self.chunk_index()
    }

    pub(super) fn add(&mut self, raw: &RawMessage) -> Result<(), RecordError> {
        self.introduce(raw.topic).map_err(|error| failed(&self.path, &error))?;
        let header = MessageHeader {
            channel_id: format::channel(raw.topic),
            sequence: 0,
            log_time: raw.at,
            publish_time: raw.made,
        };
        let written = self.writer.write_to_known_channel(&header, &raw.bytes);
        written.map_err(|error| failed(&self.path, &error))?;
        self.messages += 1;
        self.pending += size(raw);
        Ok(())
    }

    /// Writes schema and channel of a topic before its first message.
    fn introduce(&mut self, topic: Topic) -> Result<(), McapError> {
        if !self.topics.insert(topic) {
            return Ok(());
        }
        let schema = format::schema(topic);
        self.writer.add_schema_with_id(schema, topic.schema(), "protobuf", DESCRIPTORS)?;
        let (channel, name) = (format::channel(topic), topic.to_string());
        let nothing = BTreeMap::new();
        self.writer.add_channel_with_id(channel, schema, &name, "protobuf", &nothing)?;
        self.pending += introduction();
        self.summary += introduction();
        Ok(())
    }

    pub(super) fn flush(&mut self) -> Result<(), RecordError> {
        if self.pending > 0 {
            self.summary += self.chunk_index();
        }
        self.pending = 0;
        self.writer.flush().map_err(|error| failed(&self.path, &error))
    }

    /// Records data that could not be read from the file that this one is recovered from.
    pub(super) fn note_missing(&mut self, note: &MissingNote) -> Result<(), RecordError> {
        self.write_metadata(&note.metadata())
    }

    fn write_metadata(&mut self, metadata: &Metadata) -> Result<(), RecordError> {
        self.flush()?;
        self.summary += METADATA_INDEX;
        let written = self.writer.write_metadata(metadata);
        written.map_err(|error| failed(&self.path, &error))
    }

    /// Repeats labels, catalogue and voices at `at` (ns since 1970).
    pub(super) fn repeat(
        &mut self,
        labels: &Labels,
        latest: &Latest,
        at: u64,
    ) -> Result<(), RecordError> {
        self.write_metadata(&labels.metadata())?;
        latest.repeated(at).try_for_each(|raw| self.add(&raw))
    }

    /// Repeats everything that is needed to understand the file, at its end.
    pub(super) fn write_trailer(
        &mut self,
        labels: &Labels,
        latest: &Latest,
        at: u64,
    ) -> Result<(), RecordError> {
        // Three labels and more, so that a damaged one is outvoted.
        self.repeat(labels, latest, at)?;
        self.write_metadata(&labels.metadata())
    }

    /// Completes the file and waits until it is on the disk; returns its size (B).
    pub(super) fn finish(self) -> Result<u64, RecordError> {
        let path = self.path.clone();
        let (size, file) = self.close()?;
        file.sync_all().map_err(|error| failed(&path, &McapError::Io(error)))?;
        Ok(size)
    }

    /// Completes the file without waiting for the disk; returns its size (B).
    pub(super) fn close(mut self) -> Result<(u64, File), RecordError> {
        self.writer.finish().map_err(|error| failed(&self.path, &error))?;
        let sink = self.writer.into_inner().into_inner();
        let file = sink.file.into_inner().map_err(io::IntoInnerError::into_error);
        let file = file.map_err(|error| failed(&self.path, &McapError::Io(error)))?;
        Ok((self.written.load(Ordering::Relaxed), file))
    }

    fn chunk_index(&self) -> u64 {
        CHUNK_INDEX.0 + CHUNK_INDEX.1 * u64::try_from(self.topics.len()).unwrap_or(u64::MAX)
    }
}

impl fmt::Debug for RecordingPart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Part").field("path", &self.path).finish_non_exhaustive()
    }
}

/// Returns options for lz4. For keys that all move, it takes two thirds of the time of zstd, and
/// its files are a twelfth larger. Public viewers read both.
fn options() -> WriteOptions {
    WriteOptions::new()
        .profile(PROFILE)
        .library(LIBRARY)
        .compression(Some(Compression::Lz4))
        .compression_level(1)
        .chunk_size(None)
        .disable_seeking(true)
}

/// Returns the uncompressed size of a message in the file (B).
const fn size(raw: &RawMessage) -> u64 {
    raw.bytes.len() as u64 + BESIDE_MESSAGE
}

/// Returns the size of a topic's schema and channel in a file (B).
const fn introduction() -> u64 {
    DESCRIPTORS.len() as u64 + BESIDE_TOPIC
}

fn failed(path: &Path, error: &McapError) -> RecordError {
    RecordError::Write { path: path.to_owned(), cause: cause(error) }
}

struct CountingFile {
    file: BufWriter<File>,
    written: Arc<AtomicU64>,
}

impl Write for CountingFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.file.write(bytes)?;
        self.written.fetch_add(u64::try_from(written).unwrap_or(u64::MAX), Ordering::Relaxed);
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}
