//! Contents of a chunk.

use mcap::records::{MessageHeader, Record};
use mcap::sans_io::{LinearReadEvent, LinearReader, LinearReaderOptions};
use mcap::{McapError, McapResult};

use super::format::{LARGEST_CHUNK, LARGEST_RATIO};
use super::{declared::parse_record, zstd::Zstd};

/// Records of one chunk, which is decompressed and checked before the first.
pub(super) struct Chunk {
    reader: LinearReader,
    is_at_end: bool,
    /// Declared uncompressed length, if it is too large (B).
    too_large: Option<u64>,
}

pub(super) enum Inside {
    Channel(u16, String),
    Message(MessageHeader, Vec<u8>),
}

impl Chunk {
    /// Opens the chunk `record`, which begins with its opcode and length.
    pub(super) fn new(record: &[u8]) -> Self {
        let options = LinearReaderOptions::default()
            .with_skip_start_magic(true)
            .with_skip_end_magic(true)
            .with_prevalidate_chunk_crcs(true)
            .with_record_length_limit(LARGEST_CHUNK);
        let mut reader = LinearReader::new_with_options(options);
        // Only a decompressor without a name is rejected.
        let _added = reader.add_decompressor(Zstd::default());
        reader.insert(record.len()).copy_from_slice(record);
        reader.notify_read(record.len());
        let most = (LARGEST_RATIO * record.len() as u64).min(LARGEST_CHUNK as u64);
        let too_large = uncompressed(record).filter(|length| *length > most);
        Self { reader, is_at_end: false, too_large }
    }

    /// Returns the next channel, or message whose header `wants` accepts; no more after an error.
    pub(super) fn next(
        &mut self,
        mut wants: impl FnMut(&MessageHeader) -> bool,
    ) -> Option<McapResult<Inside>> {
        // The reader decompresses as much as is declared, but no more.
        if let Some(length) = self.too_large {
            return Some(Err(McapError::ChunkTooLarge(length)));
        }
        loop {
            let inside = match self.reader.next_event()? {
                Err(error) => Some(Err(error)),
                Ok(LinearReadEvent::Record { opcode, data }) => {
                    inside(opcode, data, &mut wants).transpose()
                }
                // All of it was supplied: the record either ends here or is cut.
                Ok(LinearReadEvent::ReadRequest(_)) if self.is_at_end => {
                    Some(Err(McapError::UnexpectedEoc))
                }
                Ok(LinearReadEvent::ReadRequest(_)) => {
                    self.is_at_end = true;
                    self.reader.notify_read(0);
                    None
                }
            };
            if inside.is_some() {
                return inside;
            }
        }
    }
}

/// Returns the uncompressed length that the chunk `record` declares (B).
fn uncompressed(record: &[u8]) -> Option<u64> {
    /// Position behind opcode, length and two times.
    const PLACE: std::ops::Range<usize> = 25..33;
    Some(u64::from_le_bytes(record.get(PLACE)?.try_into().ok()?))
}

fn inside(
    opcode: u8,
    data: &[u8],
    wants: &mut impl FnMut(&MessageHeader) -> bool,
) -> McapResult<Option<Inside>> {
    use mcap::records::op;
    // The others contain nothing that is needed, and are not parsed.
    if opcode != op::CHANNEL && opcode != op::MESSAGE {
        return Ok(None);
    }
    let record = parse_record(opcode, data)?;
    if let Record::Channel(channel) = record {
        return Ok(Some(Inside::Channel(channel.id, channel.topic)));
    }
    if let Record::Message { header, data } = record
        && wants(&header)
    {
        return Ok(Some(Inside::Message(header, data.into_owned())));
    }
    Ok(None)
}
