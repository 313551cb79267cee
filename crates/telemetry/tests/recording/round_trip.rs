//! Messages are read as they were recorded.

use std::{collections::BTreeSet, fs, path::Path};

use telemetry::{Status, Topic, Update, recording::Recording};

use crate::common::{
    KEYS, at, catalogue, event, performance, read, record, record_as, recorded, settings,
    unrecorded, voice,
};

#[test]
fn every_topic_comes_back_in_order() {
    let (_folder, path) = unrecorded();
    let mut told = performance(5000);
    told.push((at(5000), Update::Status(Status { rehearsed: 3, ..Status::default() })));
    let topics: BTreeSet<_> = told.iter().filter_map(|(_, update)| update.topic()).collect();
    assert!(Topic::COMMON.iter().all(|topic| topics.contains(topic)), "the test tells all");
    let recorded = record_as(settings(&path), &told);
    assert_eq!(recorded.messages, told.len() as u64);
    assert_eq!(recorded.bytes, path.metadata().expect("the file").len());
    let recording = Recording::open(&path).expect("a recording");
    assert_eq!(recording.tear(), None);
    assert_eq!(recording.run(), "the run");
    assert_eq!(recording.span(), Some((at(0), at(5000))));
    assert_eq!(read(&recording), (told, vec![]));
}

/// The recorder's chunks in `zstd.mcap` were compressed by the C library.
#[test]
fn what_is_compressed_with_zstd_is_read_as_well() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/recording/zstd.mcap");
    let recording = Recording::open(&path).expect("a recording");
    assert_eq!(recording.tear(), None);
    assert_eq!(read(&recording), (performance(500), vec![]));
}

#[test]
fn damaged_zstd_loses_a_chunk_at_most() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/recording/zstd.mcap");
    let whole = fs::read(path).expect("the file");
    let folder = tempfile::tempdir().expect("a folder");
    for place in (2_000..whole.len() - 20_000).step_by(whole.len() / 16) {
        let path = folder.path().join(format!("{place}.mcap"));
        let mut damaged = whole.clone();
        damaged[place] ^= 0x55;
        fs::write(&path, damaged).expect("a file");
        let (found, wrong) = read(&Recording::open(&path).expect("a recording"));
        assert!(!wrong.is_empty() || found == performance(500), "{place}");
    }
}

#[test]
fn a_key_of_some_seconds_is_read_alone() {
    let (_folder, path) = unrecorded();
    let told = performance(20_000);
    record(&path, &told);
    let recording = Recording::open(&path).expect("a recording");
    let opened = recording.bytes_read();
    let (from, to) = (at(7000), at(9000));
    let topics = BTreeSet::from([Topic::Block(40), Topic::Events]);
    let read: Vec<_> = recording.read(from, to, &topics).map(|it| it.expect("read")).collect();
    let expected: Vec<_> = told
        .into_iter()
        .filter(|(at, _)| (from..to).contains(at))
        .filter(|(_, update)| update.topic().is_some_and(|topic| topics.contains(&topic)))
        .collect();
    assert_eq!(read, expected);
    // Two seconds of twenty, and the rest of their chunks.
    let size = path.metadata().expect("the file").len();
    assert!(recording.bytes_read() - opened < size / 5, "{} of {size}", recording.bytes_read());
    assert_eq!(recording.read(0, 0, &topics).count(), 0);
}

#[test]
fn opening_a_long_recording_reads_its_summary_only() {
    let (_folder, path) = recorded(&performance(100_000));
    let recording = Recording::open(&path).expect("a recording");
    let size = path.metadata().expect("the file").len();
    assert!(10_000_000 < size, "{size}");
    // Two hundred chunks with their positions, and the messages' schemas.
    assert!(recording.bytes_read() < 120_000, "{}", recording.bytes_read());
}

#[test]
fn voices_are_those_of_the_time() {
    let (_folder, path) = unrecorded();
    let mut told = performance(10_000);
    let half = told.iter().position(|(when, _)| at(5000) < *when).expect("a half");
    told.insert(half, (at(5000), voice(39, 100, "wall", "brick")));
    record(&path, &told);
    let recording = Recording::open(&path).expect("a recording");
    assert_eq!(recording.catalogue().expect("read").map(Update::Catalogue), Some(catalogue()));
    let instruments = |tick| -> Vec<_> {
        let voices = recording.voices_at(at(tick)).expect("read");
        voices.into_iter().map(|(at, voice)| (at, voice.key, voice.instrument)).collect()
    };
    let grand = |key| (at(0), key, "grand".to_owned());
    assert_eq!(instruments(4999), KEYS.map(grand));
    let brick = (at(5000), 39, "brick".to_owned());
    assert_eq!(instruments(5000), [grand(38), brick, grand(40)]);
    assert_eq!(recording.voices_at(at(0) - 1).expect("read"), []);
}

#[test]
fn an_empty_recording_is_one() {
    let (_folder, path) = recorded(&[]);
    let recording = Recording::open(&path).expect("a recording");
    assert_eq!((recording.span(), recording.catalogue().expect("read")), (None, None));
    assert_eq!(recording.tear(), None);
    assert_eq!(read(&recording), (vec![], vec![]));
}

#[test]
fn messages_at_the_ends_of_time_are_kept() {
    let (_folder, path) = unrecorded();
    let strike = |tick| event(telemetry::event::Kind::Strike, tick, 0.0, 1);
    let told = vec![(u64::MAX, strike(1)), (0, strike(2))];
    record(&path, &told);
    assert_eq!(read(&Recording::open(&path).expect("a recording")), (told, vec![]));
}
