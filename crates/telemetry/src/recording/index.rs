//! Where the chunks of a file are: from its summary, or, if it has none, by reading it all.

use std::collections::{BTreeMap, BTreeSet};
use std::io;

use mcap::records::{ChunkIndex, Footer, Record, op};
use mcap::sans_io::{LinearReadEvent, LinearReader, LinearReaderOptions};
use mcap::{MAGIC, McapResult};

use super::chunk::{Chunk, Inside};
use super::format::{self, LARGEST_CHUNK};
use super::part_file::Bytes;
use crate::Topic;

/// Opcode and length of a record [B].
const RECORD: u64 = 9;
/// Footer and magic, at the end of a complete file [B].
const FOOTER: u64 = RECORD + 20 + 8;
/// The record that ends the data, just before the summary [B].
const DATA_END: u64 = RECORD + 4;

/// Where a chunk is, and what is in it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Place {
    /// Where it begins, and how long it is, with opcode and length [B].
    pub(super) offset: u64,
    pub(super) length: u64,
    /// Times of its first and last message [ns since 1970].
    pub(super) first: u64,
    pub(super) last: u64,
    /// What its messages are, if that is known without looking.
    pub(super) topics: Option<Vec<Topic>>,
}

impl Place {
    /// Whether it may have messages of one of these topics.
    pub(super) fn may_have(&self, wanted: impl Fn(Topic) -> bool) -> bool {
        self.topics.as_ref().is_none_or(|topics| topics.iter().any(|topic| wanted(*topic)))
    }
}

/// Where the chunks of a file are.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Index {
    /// In the order of the file.
    pub(super) places: Vec<Place>,
    /// Topics by their numbers.
    pub(super) topics: BTreeMap<u16, Topic>,
    /// If there was no summary: how it looked without.
    pub(super) without_summary: Option<Scan>,
}

/// How a file looked that was read without its summary.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Scan {
    /// Up to where there are whole records [B].
    pub(super) up_to: u64,
    /// Whether the data had an end, so that nothing but the summary is missing.
    pub(super) has_end: bool,
    /// Chunks that are there, but damaged.
    pub(super) damaged: u32,
}

impl Index {
    /// The index of a file, which the scan, if it takes one, begins at `start` [B].
    pub(super) fn of(file: &Bytes, start: u64) -> io::Result<Self> {
        match summary(file)? {
            Some(index) => Ok(index),
            None => scan(file, start),
        }
    }

    fn name(&mut self, channel: u16, name: &str) {
        match Topic::named(name) {
            Some(topic) => self.topics.insert(channel, topic),
            // Somebody else's: not to be taken for ours of the same number.
            None => self.topics.remove(&channel),
        };
    }

    fn add(&mut self, index: &ChunkIndex) {
        let channels = index.message_index_offsets.keys();
        let topics: Vec<_> = channels.filter_map(|id| self.topics.get(id).copied()).collect();
        self.places.push(Place {
            offset: index.chunk_start_offset,
            length: index.chunk_length,
            first: index.message_start_time,
            last: index.message_end_time,
            topics: (!index.message_index_offsets.is_empty()).then_some(topics),
        });
    }
}

/// The index as the summary has it; none if there is none that can be trusted.
fn summary(file: &Bytes) -> io::Result<Option<Index>> {
    let Some(start) = summary_start(file)? else { return Ok(None) };
    let bytes = file.read(start, file.size - start)?;
    // The checksum of the whole summary is looked at before any of it is used.
    let Ok(mut index) = read_summary(&bytes) else { return Ok(None) };
    index.places.sort_by_key(|place| place.offset);
    let is_inside = |place: &Place| {
        place.length > RECORD
            && place.offset.checked_add(place.length).is_some_and(|end| end <= file.size)
    };
    Ok(index.places.iter().all(is_inside).then_some(index))
}

/// Where the end of the data, and after it the summary, begins.
fn summary_start(file: &Bytes) -> io::Result<Option<u64>> {
    let Some(footer) = file.size.checked_sub(FOOTER) else { return Ok(None) };
    let tail = file.read(footer, FOOTER)?;
    let Some((&op::FOOTER, rest)) = tail.split_first() else { return Ok(None) };
    if !rest.ends_with(MAGIC) {
        return Ok(None);
    }
    let body = rest.get(8..28).unwrap_or_default();
    let Ok(Record::Footer(Footer { summary_start, .. })) = mcap::parse_record(op::FOOTER, body)
    else {
        return Ok(None);
    };
    Ok(summary_start.checked_sub(DATA_END).filter(|start| *start < footer))
}

fn read_summary(bytes: &[u8]) -> McapResult<Index> {
    let options = LinearReaderOptions::default()
        .with_skip_start_magic(true)
        .with_validate_summary_section_crc(true)
        .with_emit_chunks(true)
        .with_record_length_limit(bytes.len());
    let mut reader = LinearReader::new_with_options(options);
    reader.insert(bytes.len()).copy_from_slice(bytes);
    reader.notify_read(bytes.len());
    let mut index = Index { places: Vec::new(), topics: format::topics(), without_summary: None };
    let (mut chunks, mut expected) = (Vec::new(), None);
    while let Some(event) = reader.next_event() {
        let LinearReadEvent::Record { opcode, data } = event? else {
            return Err(mcap::McapError::UnexpectedEof);
        };
        // Only these are needed; the others are not even looked at.
        if ![op::CHANNEL, op::CHUNK_INDEX, op::STATISTICS].contains(&opcode) {
            continue;
        }
        let record = mcap::parse_record(opcode, data)?;
        if let Record::Channel(channel) = record {
            index.name(channel.id, &channel.topic);
        } else if let Record::ChunkIndex(chunk) = record {
            chunks.push(chunk);
        } else if let Record::Statistics(statistics) = record {
            expected = usize::try_from(statistics.chunk_count).ok();
        }
    }
    // Somebody may have left the places out, or some of them.
    if expected != Some(chunks.len()) {
        return Err(mcap::McapError::BadIndex);
    }
    for chunk in &chunks {
        index.add(chunk);
    }
    Ok(index)
}

/// The index of a file whose host died, or whose summary is damaged.
fn scan(file: &Bytes, start: u64) -> io::Result<Index> {
    let mut index = Index { places: Vec::new(), topics: format::topics(), without_summary: None };
    let mut scan = Scan { up_to: start, has_end: false, damaged: 0 };
    while let Some((opcode, length)) = record_at(file, scan.up_to)? {
        if opcode == op::DATA_END {
            scan.has_end = true;
            break;
        }
        if opcode == op::CHUNK {
            match look(file, scan.up_to, length, &mut index)? {
                Some(place) => index.places.push(place),
                None => scan.damaged += 1,
            }
        }
        scan.up_to += length;
    }
    index.without_summary = Some(scan);
    Ok(index)
}

/// Opcode and length of the record at `offset`, with opcode and length; none if it is cut.
fn record_at(file: &Bytes, offset: u64) -> io::Result<Option<(u8, u64)>> {
    let left = file.size.saturating_sub(offset);
    if left < RECORD {
        return Ok(None);
    }
    let head = file.read(offset, RECORD)?;
    let Some((&opcode, length)) = head.split_first() else { return Ok(None) };
    let Ok(length) = <[u8; 8]>::try_from(length) else { return Ok(None) };
    let length = u64::from_le_bytes(length).checked_add(RECORD);
    // No record is numbered 0: a hole in the file reads as one.
    Ok(length.filter(|length| opcode != 0 && *length <= left).map(|length| (opcode, length)))
}

/// What is in the chunk at `offset`; none if it is damaged.
fn look(file: &Bytes, offset: u64, length: u64, index: &mut Index) -> io::Result<Option<Place>> {
    if length > LARGEST_CHUNK as u64 {
        return Ok(None);
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
            Some(Err(_)) => return Ok(None),
            Some(Ok(Inside::Channel(id, name))) => index.name(id, &name),
            Some(Ok(Inside::Message(..))) => {}
        }
    }
    let topics = topics.iter().filter_map(|id| index.topics.get(id).copied()).collect();
    Ok(Some(Place { offset, length, first: first.min(last), last, topics: Some(topics) }))
}
