//! Declared lengths are compared with the available and the possible ones before they are used.

use std::fs;

use telemetry::recording::{Recording, recover};

use crate::common::{performance, recorded};

const CHUNK: u8 = 6;
/// Most data of a zstd block (B).
const BLOCK: u64 = 128 << 10;

/// Returns a zstd frame of `length` zeros, a multiple of [`BLOCK`], in four bytes for each block.
fn zeros(length: u64) -> Vec<u8> {
    let mut frame = vec![0x28, 0xb5, 0x2f, 0xfd, 0, 0x38];
    let n = length / BLOCK;
    for block in 1..=n {
        let header = (BLOCK << 3) | 2 | u64::from(block == n);
        frame.extend(&header.to_le_bytes()[..3]);
        frame.push(0);
    }
    frame
}

fn chunk(compression: &str, length: u64, data: &[u8]) -> Vec<u8> {
    let mut body = [0_u64.to_le_bytes(), 1_u64.to_le_bytes(), length.to_le_bytes()].concat();
    body.extend(0_u32.to_le_bytes());
    body.extend(u32::try_from(compression.len()).expect("a word").to_le_bytes());
    body.extend(compression.as_bytes());
    body.extend((data.len() as u64).to_le_bytes());
    body.extend(data);
    [&[CHUNK], (body.len() as u64).to_le_bytes().as_slice(), &body].concat()
}

#[test]
fn a_chunk_that_would_be_gigabytes_is_refused_before_it_is_decompressed() {
    let (folder, path) = recorded(&performance(100));
    let whole = fs::read(&path).expect("the file");
    let summary = mcap::Summary::read(&whole).expect("a summary").expect("there is one");
    let start = summary.chunk_indexes.first().expect("a chunk").chunk_start_offset;
    let start = &whole[..usize::try_from(start).expect("near the beginning")];
    for (compression, length) in [("zstd", 8 << 30), ("lz4", 8 << 30), ("zstd", 64 << 20)] {
        let bytes = [start, &chunk(compression, length, &zeros(length))].concat();
        assert!(bytes.len() < 400_000, "{}", bytes.len());
        fs::write(&path, bytes).expect("a file");
        let recording = Recording::open(&path).expect("its labels are whole");
        let told: Vec<_> = recording.messages().collect();
        let [Err(missing), ..] = told.as_slice() else { panic!("{told:?}") };
        let said = missing.to_string();
        assert!(said.contains(&format!("a chunk of {length} bytes is larger than")), "{said}");
        let new = folder.path().join(compression);
        let saved = recover(&path, &new).map(|it| it.messages);
        assert!(!matches!(saved, Ok(1..)), "{saved:?}");
    }
}
