//! Files that are no recordings are rejected with a sentence.

use std::fs;

use mcap::records::Metadata;
use telemetry::recording::Recording;

use crate::common::{performance, record, unrecorded};

fn mcap(profile: &str, entries: &[(&str, &str)]) -> Vec<u8> {
    let mut file = std::io::Cursor::new(Vec::new());
    let options = mcap::WriteOptions::new().profile(profile);
    let mut writer = options.create(&mut file).expect("a writer");
    let metadata = entries.iter().map(|(name, value)| ((*name).into(), (*value).into())).collect();
    writer.write_metadata(&Metadata { name: "letoff".into(), metadata }).expect("metadata");
    writer.finish().expect("complete");
    drop(writer);
    file.into_inner()
}

#[test]
fn each_is_refused_in_a_sentence_of_its_own() {
    let folder = tempfile::tempdir().expect("a folder");
    let ours = [("format", "1.7"), ("part", "1"), ("run", "x")];
    let theirs = [("format", "2.0"), ("part", "1"), ("run", "x")];
    let cases = [
        ("empty", vec![], "is no recording: it does not begin as an MCAP file does"),
        ("notes", b"a b c".to_vec(), "is no recording: it does not begin as an MCAP file does"),
        ("midi", b"MThd\0\0\0\x06\0\x01".to_vec(), "is no recording: it does not begin as"),
        ("robot", mcap("ros2", &ours), "is an MCAP file, but no recording of letoff's"),
        ("nameless", mcap("letoff", &[("run", "x")]), "is an MCAP file, but no recording of"),
        ("later", mcap("letoff", &theirs), "is of format 2.0, and this letoff reads 1.0: use"),
        ("magic", mcap("letoff", &ours)[..5].to_vec(), "breaks off before anything was recorded"),
        ("header", mcap("letoff", &ours)[..40].to_vec(), "breaks off before anything was"),
    ];
    for (name, bytes, expected) in cases {
        let path = folder.path().join(name);
        fs::write(&path, bytes).expect("a file");
        let error = Recording::open(&path).expect_err(name).to_string();
        assert!(error.starts_with(&format!("{} {expected}", path.display())), "{error}");
        assert!(!error.contains('\n'), "{error}");
    }
    // A minor change of the format keeps it readable.
    let path = folder.path().join("newer");
    fs::write(&path, mcap("letoff", &ours)).expect("a file");
    assert!(Recording::open(&path).is_ok());
    let error = Recording::open(folder.path().join("missing")).expect_err("none").to_string();
    assert!(error.contains("missing cannot be read: No such file"), "{error}");
}

#[test]
fn a_file_that_another_tool_numbered_anew_is_read_by_names() {
    let (_folder, path) = unrecorded();
    let told = performance(100);
    record(&path, &told);
    let renumbered = renumber(&fs::read(&path).expect("the file"));
    fs::write(&path, renumbered).expect("a file");
    let recording = Recording::open(&path).expect("a recording");
    assert_eq!(crate::common::read(&recording), (told, vec![]));
}

#[test]
fn an_older_file_that_says_once_what_it_is_is_read_without_that() {
    let (_folder, path) = unrecorded();
    let told = performance(100);
    record(&path, &told);
    let older = renumber(&fs::read(&path).expect("the file"));
    let summary = mcap::Summary::read(&older).expect("a summary").expect("there is one");
    let chunk = summary.chunk_indexes.first().expect("a chunk").chunk_start_offset;
    let mut refused = 0;
    for hit in 0..usize::try_from(chunk).expect("near the beginning") {
        let mut bytes = older.clone();
        bytes[hit] ^= 4;
        fs::write(&path, bytes).expect("a file");
        match Recording::open(&path) {
            Ok(recording) => {
                assert_eq!(crate::common::read(&recording), (told.clone(), vec![]), "{hit}");
            }
            // The one digit that would mark a later format.
            Err(error) => {
                assert!(error.to_string().contains(" is of format "), "{hit}: {error}");
                refused += 1;
            }
        }
    }
    assert!(refused <= 1, "{refused}");
}

fn renumber(bytes: &[u8]) -> Vec<u8> {
    let mut file = std::io::Cursor::new(Vec::new());
    let options = mcap::WriteOptions::new().profile("letoff");
    let mut writer = options.create(&mut file).expect("a writer");
    let entries = [("format", "1.0"), ("part", "1"), ("run", "x")];
    let metadata = entries.iter().map(|(name, value)| ((*name).into(), (*value).into())).collect();
    writer.write_metadata(&Metadata { name: "letoff".into(), metadata }).expect("metadata");
    for message in mcap::MessageStream::new(bytes).expect("messages") {
        let message = message.expect("a message");
        if message.publish_time != message.log_time {
            continue;
        }
        let nothing = std::collections::BTreeMap::new();
        let channel = writer.add_channel(0, &message.channel.topic, "protobuf", &nothing);
        let header = mcap::records::MessageHeader {
            channel_id: channel.expect("a channel"),
            sequence: 0,
            log_time: message.log_time,
            publish_time: message.publish_time,
        };
        writer.write_to_known_channel(&header, &message.data).expect("written");
    }
    writer.finish().expect("complete");
    drop(writer);
    file.into_inner()
}
