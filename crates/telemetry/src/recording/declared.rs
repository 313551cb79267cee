//! Lengths that records declare, compared with the available bytes: the parser allocates the
//! declared length before it reads.

use mcap::records::{Record, op};
use mcap::{McapError, McapResult};

#[derive(Clone, Copy)]
enum DeclaredField {
    /// Numbers that declare no length, of this total size (B).
    Fixed(usize),
    /// A length, and so many bytes.
    Text,
    /// A length, and so many bytes of texts.
    Texts,
}

/// Parses the record of `opcode` in `body`; rejects one that declares more than `body` contains.
pub(super) fn parse_record(opcode: u8, body: &[u8]) -> McapResult<Record<'_>> {
    if fits(opcode, body) {
        mcap::parse_record(opcode, body)
    } else {
        Err(McapError::UnexpectedEof)
    }
}

/// Returns `true` if all that a record declares lies within `body`.
fn fits(opcode: u8, body: &[u8]) -> bool {
    let mut rest = body;
    fields(opcode).iter().all(|field| match field {
        DeclaredField::Fixed(length) => take(&mut rest, *length).is_some(),
        DeclaredField::Text => take_text(&mut rest).is_some(),
        DeclaredField::Texts => take_text(&mut rest).is_some_and(|mut texts| {
            while !texts.is_empty() {
                if take_text(&mut texts).is_none() {
                    return false;
                }
            }
            true
        }),
    })
}

const fn fields(opcode: u8) -> &'static [DeclaredField] {
    match opcode {
        op::HEADER => &[DeclaredField::Text, DeclaredField::Text],
        op::CHANNEL => &[
            DeclaredField::Fixed(4),
            DeclaredField::Text,
            DeclaredField::Text,
            DeclaredField::Texts,
        ],
        op::METADATA => &[DeclaredField::Text, DeclaredField::Texts],
        op::METADATA_INDEX => &[DeclaredField::Fixed(16), DeclaredField::Text],
        op::CHUNK_INDEX => &[
            DeclaredField::Fixed(32),
            DeclaredField::Text,
            DeclaredField::Fixed(8),
            DeclaredField::Text,
        ],
        _ => &[],
    }
}

fn take<'a>(rest: &mut &'a [u8], length: usize) -> Option<&'a [u8]> {
    let (taken, left) = rest.split_at_checked(length)?;
    *rest = left;
    Some(taken)
}

fn take_text<'a>(rest: &mut &'a [u8]) -> Option<&'a [u8]> {
    let length = <[u8; 4]>::try_from(take(rest, 4)?).ok()?;
    take(rest, usize::try_from(u32::from_le_bytes(length)).ok()?)
}

#[cfg(test)]
mod tests {
    use std::{collections::BTreeMap, io::Cursor};

    use mcap::records::Metadata;

    use super::*;

    fn records() -> Vec<(u8, Vec<u8>)> {
        let mut file = Cursor::new(Vec::new());
        let mut writer = mcap::WriteOptions::new().profile("letoff").create(&mut file).unwrap();
        let texts = BTreeMap::from([("run".to_owned(), "x".to_owned())]);
        let metadata = Metadata { name: "letoff".into(), metadata: texts.clone() };
        writer.write_metadata(&metadata).unwrap();
        let schema = writer.add_schema("schema", "protobuf", &[1, 2]).unwrap();
        let channel = writer.add_channel(schema, "topic", "protobuf", &texts).unwrap();
        let (sequence, log_time, publish_time) = (0, 1, 1);
        let header =
            mcap::records::MessageHeader { channel_id: channel, sequence, log_time, publish_time };
        writer.write_to_known_channel(&header, &[1, 2, 3]).unwrap();
        writer.finish().unwrap();
        drop(writer);
        let bytes = file.into_inner();
        let mut reader = mcap::sans_io::LinearReader::new();
        reader.insert(bytes.len()).copy_from_slice(&bytes);
        reader.notify_read(bytes.len());
        let mut all = Vec::new();
        while let Some(event) = reader.next_event() {
            let Ok(mcap::sans_io::LinearReadEvent::Record { opcode, data }) = event else { break };
            all.push((opcode, data.to_vec()));
        }
        all
    }

    #[test]
    fn a_length_beyond_its_record_is_refused_wherever_it_stands() {
        for (opcode, body) in records().iter().filter(|it| !fields(it.0).is_empty()) {
            let mut refused = 0;
            for at in 0..body.len().saturating_sub(3) {
                let mut damaged = body.clone();
                damaged[at..at + 4].copy_from_slice(&0xffff_0002_u32.to_le_bytes());
                refused += usize::from(!fits(*opcode, &damaged));
            }
            let texts =
                fields(*opcode).iter().filter(|it| !matches!(it, DeclaredField::Fixed(_))).count();
            assert!(texts <= refused, "{opcode}: {refused}");
        }
    }
}
