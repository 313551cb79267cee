//! Positions of a file's chunks: from its summary, or by reading the whole file.

use std::collections::{BTreeMap, BTreeSet};
use std::io;

use mcap::records::{ChunkIndex, Footer, Metadata, MetadataIndex, Record, op};
use mcap::sans_io::{LinearReadEvent, LinearReader, LinearReaderOptions};
use mcap::{MAGIC, McapError, McapResult};

use super::chunk::{Chunk, Inside};
use super::format::{self, LARGEST_CHUNK, Labels, PROFILE};
use super::missing::{self, Defect, MissingNote};
use super::{declared::parse_record, error::cause, file_bytes::FileBytes};
use crate::Topic;

/// Opcode and length of a record (B).
const RECORD: u64 = 9;
/// Footer and magic, at the end of a complete file (B).
const FOOTER: u64 = RECORD + 20 + 8;
/// The record that ends the data, just before the summary (B).
const DATA_END: u64 = RECORD + 4;

/// Cause for a piece without a chunk, or with only the beginning of one.
const NO_CHUNK: &str = "there is no whole chunk";

/// Copies of the labels read besides the first: a majority of three outvotes a damaged one.
const COPIES: usize = 2;
/// Largest metadata record (B).
const LONGEST_METADATA: u64 = 4096;

/// Position of a chunk in a file, with its times and topics.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct ChunkPosition {
    /// Offset and length of the whole record (B).
    pub(super) offset: u64,
    pub(super) length: u64,
    /// Times of its first and last message (ns since 1970).
    pub(super) first: u64,
    pub(super) last: u64,
    /// Topics of its messages, if the index names them.
    pub(super) topics: Option<Vec<Topic>>,
    /// Defect, if the chunk is known to be unreadable.
    pub(super) defect: Option<Defect>,
}

impl ChunkPosition {
    /// Returns `true` if it may have messages of a wanted topic.
    pub(super) fn may_have(&self, wanted: impl Fn(Topic) -> bool) -> bool {
        self.topics.as_ref().is_none_or(|topics| topics.iter().any(|topic| wanted(*topic)))
    }
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Index {
    pub(super) positions: Vec<ChunkPosition>,
    pub(super) topics: BTreeMap<u16, Topic>,
    /// `true` if the file itself names a topic of Letoff's.
    pub(super) names_ours: bool,
    pub(super) labels: Vec<Labels>,
    /// Damage of the file from which this one was recovered, if that broke off.
    pub(super) breaks_off: Option<String>,
    /// Result of scanning the file, if there was no summary.
    pub(super) without_summary: Option<IndexScan>,
}

/// Result of scanning a file without its summary.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct IndexScan {
    /// End of the last whole record (B).
    pub(super) up_to: u64,
    /// `true` if the data had an end, so that only the summary is missing.
    pub(super) has_end: bool,
    pub(super) damaged: u32,
}

impl Index {
    fn empty() -> Self {
        Self {
            positions: Vec::new(),
            topics: format::topics(),
            names_ours: false,
            labels: Vec::new(),
            breaks_off: None,
            without_summary: None,
        }
    }

    fn name(&mut self, channel: u16, name: &str) {
        let topic = Topic::named(name);
        self.names_ours |= topic.is_some();
        match topic {
            Some(topic) => self.topics.insert(channel, topic),
            // Another program's topic must not be taken for Letoff's with the same number.
            None => self.topics.remove(&channel),
        };
    }

    fn add(&mut self, index: &ChunkIndex) {
        let channels = index.message_index_offsets.keys();
        let topics: Vec<_> = channels.filter_map(|id| self.topics.get(id).copied()).collect();
        self.positions.push(ChunkPosition {
            offset: index.chunk_start_offset,
            length: index.chunk_length,
            first: index.message_start_time,
            last: index.message_end_time,
            topics: (!index.message_index_offsets.is_empty()).then_some(topics),
            defect: None,
        });
    }

    fn tell(&mut self, offset: u64, record: &[u8]) {
        let Some(metadata) = metadata_in(record) else { return };
        self.labels.extend(Labels::of(&metadata));
        let Some(note) = MissingNote::of(&metadata) else { return };
        let Some((first, last)) = note.span else {
            self.breaks_off = Some(note.wrong);
            return;
        };
        self.positions.push(ChunkPosition {
            offset,
            length: record.len() as u64,
            first,
            last,
            topics: note.topics,
            defect: Some(Defect::left_out(note.wrong)),
        });
    }
}

/// Reads the index from the summary; `None` if there is no intact one.
pub(super) fn summary(file: &FileBytes) -> io::Result<Option<Index>> {
    let Some(start) = summary_start(file)? else { return Ok(None) };
    let bytes = file.read(start, file.size - start)?;
    // The checksum of the whole summary is checked before any of it is used.
    let Ok((mut index, metadata)) = read_summary(&bytes) else { return Ok(None) };
    let labels = metadata.iter().rev().filter(|at| at.name == PROFILE).take(COPIES);
    for at in labels.chain(metadata.iter().filter(|at| at.name == missing::NAME)) {
        let is_inside = at.offset.checked_add(at.length).is_some_and(|end| end <= file.size);
        if is_inside && at.length <= LONGEST_METADATA {
            index.tell(at.offset, &file.read(at.offset, at.length)?);
        }
    }
    index.positions.sort_by_key(|position| position.offset);
    let is_inside = |position: &ChunkPosition| {
        position.length > RECORD
            && position.offset.checked_add(position.length).is_some_and(|end| end <= file.size)
    };
    Ok(index.positions.iter().all(is_inside).then_some(index))
}

fn metadata_in(record: &[u8]) -> Option<Metadata> {
    let body = record.strip_prefix(&[op::METADATA])?.get(8..)?;
    match parse_record(op::METADATA, body) {
        Ok(Record::Metadata(metadata)) => Some(metadata),
        Ok(_) | Err(_) => None,
    }
}

fn summary_start(file: &FileBytes) -> io::Result<Option<u64>> {
    let Some(footer) = file.size.checked_sub(FOOTER) else { return Ok(None) };
    let tail = file.read(footer, FOOTER)?;
    let Some((&op::FOOTER, rest)) = tail.split_first() else { return Ok(None) };
    if !rest.ends_with(MAGIC) {
        return Ok(None);
    }
    let body = rest.get(8..28).unwrap_or_default();
    let Ok(Record::Footer(Footer { summary_start, .. })) = parse_record(op::FOOTER, body) else {
        return Ok(None);
    };
    Ok(summary_start.checked_sub(DATA_END).filter(|start| *start < footer))
}

fn read_summary(bytes: &[u8]) -> McapResult<(Index, Vec<MetadataIndex>)> {
    let options = LinearReaderOptions::default()
        .with_skip_start_magic(true)
        .with_validate_summary_section_crc(true)
        .with_emit_chunks(true)
        .with_record_length_limit(bytes.len());
    let mut reader = LinearReader::new_with_options(options);
    reader.insert(bytes.len()).copy_from_slice(bytes);
    reader.notify_read(bytes.len());
    let mut index = Index::empty();
    let (mut chunks, mut metadata, mut expected) = (Vec::new(), Vec::new(), None);
    while let Some(event) = reader.next_event() {
        let LinearReadEvent::Record { opcode, data } = event? else {
            return Err(McapError::UnexpectedEof);
        };
        let needed = [op::CHANNEL, op::CHUNK_INDEX, op::METADATA_INDEX, op::STATISTICS];
        if !needed.contains(&opcode) {
            continue;
        }
        let record = parse_record(opcode, data)?;
        if let Record::Channel(channel) = record {
            index.name(channel.id, &channel.topic);
        } else if let Record::ChunkIndex(chunk) = record {
            chunks.push(chunk);
        } else if let Record::MetadataIndex(at) = record {
            metadata.push(at);
        } else if let Record::Statistics(statistics) = record {
            expected = usize::try_from(statistics.chunk_count).ok();
        }
    }
    // A writer may have omitted the positions, or some of them.
    if expected != Some(chunks.len()) {
        return Err(McapError::BadIndex);
    }
    for chunk in &chunks {
        index.add(chunk);
    }
    Ok((index, metadata))
}

/// Reads the file from byte `start` on; after damaged lengths continues at the next intact chunk.
pub(super) fn scan(file: &FileBytes, start: u64) -> io::Result<Index> {
    let mut index = Index::empty();
    let mut scan = IndexScan { up_to: start, has_end: false, damaged: 0 };
    loop {
        let Some((opcode, length)) = record_at(file, scan.up_to)? else {
            let Some(next) = next_chunk(file, scan.up_to)? else { break };
            index.positions.push(damaged(scan.up_to, next - scan.up_to, NO_CHUNK));
            scan.damaged += 1;
            scan.up_to = next;
            continue;
        };
        if opcode == op::DATA_END {
            scan.has_end = true;
            break;
        }
        if opcode == op::METADATA && length <= LONGEST_METADATA {
            index.tell(scan.up_to, &file.read(scan.up_to, length)?);
            index.labels.drain(..index.labels.len().saturating_sub(COPIES));
        }
        let mut length = length;
        if opcode == op::CHUNK {
            let position = match scan_chunk(file, scan.up_to, length, &mut index)? {
                Ok(position) => position,
                Err(cause) => {
                    length = length_of_damaged(file, scan.up_to, length)?;
                    scan.damaged += 1;
                    damaged(scan.up_to, length, &cause)
                }
            };
            index.positions.push(position);
        }
        scan.up_to += length;
    }
    date_damaged(&mut index.positions);
    index.without_summary = Some(scan);
    Ok(index)
}

/// Returns the length of the damaged chunk at `offset`, whose own `length` may be damaged, too.
fn length_of_damaged(file: &FileBytes, offset: u64, length: u64) -> io::Result<u64> {
    if record_at(file, offset + length)?.is_some() {
        return Ok(length);
    }
    let next = next_chunk(file, offset + 1)?;
    Ok(next.map_or(length, |next| next - offset))
}

fn damaged(offset: u64, length: u64, cause: &str) -> ChunkPosition {
    let defect = Some(Defect::damage(offset, cause));
    ChunkPosition { offset, length, first: 0, last: u64::MAX, topics: None, defect }
}

fn date_damaged(positions: &mut [ChunkPosition]) {
    let known =
        |position: &&ChunkPosition| position.defect.as_ref().is_none_or(|it| it.is_left_out);
    for i in 0..positions.len() {
        if !known(&&positions[i]) {
            let before = positions[..i].iter().rev().find(known).map(|position| position.last);
            let after = positions[i..].iter().find(known).map(|position| position.first);
            let first = before.or(after).unwrap_or(0);
            (positions[i].first, positions[i].last) = (first, after.unwrap_or(first).max(first));
        }
    }
}

/// Size of the piece that is searched at once (B).
const WINDOW: u64 = 1 << 20;

/// Returns the offset of the next intact chunk from byte `from` on.
fn next_chunk(file: &FileBytes, from: u64) -> io::Result<Option<u64>> {
    let mut at = from;
    while at + RECORD < file.size {
        let window = file.read(at, WINDOW.min(file.size - at))?;
        let starts = window.windows(9).enumerate().filter(|(_, head)| head[0] == op::CHUNK);
        for (i, head) in starts {
            let offset = at + i as u64;
            let length = <[u8; 8]>::try_from(&head[1..]).map_or(u64::MAX, u64::from_le_bytes);
            let fits = length < LARGEST_CHUNK as u64 && length + RECORD <= file.size - offset;
            if fits && scan_chunk(file, offset, length + RECORD, &mut Index::empty())?.is_ok() {
                return Ok(Some(offset));
            }
        }
        // The last bytes of this window may begin a chunk that continues in the next.
        at += (window.len() as u64).saturating_sub(RECORD - 1).max(1);
    }
    Ok(None)
}

fn record_at(file: &FileBytes, offset: u64) -> io::Result<Option<(u8, u64)>> {
    let left = file.size.saturating_sub(offset);
    if left < RECORD {
        return Ok(None);
    }
    let head = file.read(offset, RECORD)?;
    let Some((&opcode, length)) = head.split_first() else { return Ok(None) };
    let Ok(length) = <[u8; 8]>::try_from(length) else { return Ok(None) };
    let length = u64::from_le_bytes(length).checked_add(RECORD);
    // No record has number 0, as a hole in the file reads, nor one beyond the last.
    let is_one = (op::HEADER..=op::DATA_END).contains(&opcode);
    Ok(length.filter(|length| is_one && *length <= left).map(|length| (opcode, length)))
}

/// Reads times and topics of the chunk at `offset`, or the cause of its damage.
fn scan_chunk(
    file: &FileBytes,
    offset: u64,
    length: u64,
    index: &mut Index,
) -> io::Result<Result<ChunkPosition, String>> {
    if length > LARGEST_CHUNK as u64 {
        return Ok(Err(NO_CHUNK.to_owned()));
    }
    let mut chunk = Chunk::new(&file.read(offset, length)?);
    let (mut first, mut last, mut topics) = (u64::MAX, 0, BTreeSet::new());
    loop {
        let inside = chunk.next(|message| {
            (first, last) = (first.min(message.log_time), last.max(message.log_time));
            topics.insert(message.channel_id);
            false
        });
        match inside {
            None => break,
            Some(Err(error @ McapError::ChunkTooLarge(_))) => return Ok(Err(cause(&error))),
            Some(Err(_)) => return Ok(Err(NO_CHUNK.to_owned())),
            Some(Ok(Inside::Channel(id, name))) => index.name(id, &name),
            Some(Ok(Inside::Message(..))) => {}
        }
    }
    let topics = topics.iter().filter_map(|id| index.topics.get(id).copied()).collect();
    let (first, topics) = (first.min(last), Some(topics));
    Ok(Ok(ChunkPosition { offset, length, first, last, topics, defect: None }))
}
