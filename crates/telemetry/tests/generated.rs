//! The committed messages match their description.
//!
//! `UPDATE_MESSAGES=1 cargo test -p telemetry generated` regenerates them.

use std::fs;
use std::path::{Path, PathBuf};

use protox::prost::Message as _;

const FILES: [&str; 2] = ["letoff.telemetry.rs", "telemetry.binpb"];

/// Generates the messages' types and descriptors into `out`.
fn make(out: &Path) {
    let proto = Path::new(env!("CARGO_MANIFEST_DIR")).join("proto");
    let mut files = protox::compile(["letoff/telemetry.proto"], [proto]).expect("a description");
    let types = prost_build::Config::new().out_dir(out).compile_fds(files.clone());
    types.expect("types");
    // Every recording has the descriptors a dozen times: the comments are three quarters.
    for file in &mut files.file {
        file.source_code_info = None;
    }
    fs::write(out.join(FILES[1]), files.encode_to_vec()).expect("descriptors");
}

fn committed() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("proto/generated")
}

#[test]
fn the_committed_messages_are_those_of_the_description() {
    if std::env::var_os("UPDATE_MESSAGES").is_some() {
        make(&committed());
    }
    let folder = tempfile::tempdir().expect("a folder");
    make(folder.path());
    for name in FILES {
        let made = fs::read(folder.path().join(name)).expect("what was made");
        let ours = fs::read(committed().join(name)).expect("what is committed");
        assert!(made == ours, "{name} is old: UPDATE_MESSAGES=1 cargo test -p telemetry generated");
    }
}
