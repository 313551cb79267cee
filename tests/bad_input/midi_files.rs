//! Performances that are not MIDI files, or cut ones.

use std::fs;
use std::path::PathBuf;

use crate::letoff::{check, check_words, folder, run};

fn with(name: &str, bytes: &[u8]) -> PathBuf {
    let folder = folder(name);
    fs::write(folder.join(name), bytes).expect("a file");
    folder
}

#[track_caller]
fn check_refused(name: &str, bytes: &[u8], reason: &str) {
    let folder = with(name, bytes);
    let arguments = ["run", "--virtual-time", "--duration", "2", "--performance", name];
    check(&folder, &arguments, 2, &[name, "cannot be played", reason]);
}

fn bach() -> &'static [u8] {
    include_bytes!("../../configs/performances/bach-bwv-846.mid")
}

#[test]
fn a_file_that_is_something_else_is_refused() {
    check_refused("text.mid", b"once upon a time, there was no MIDI", "not a MIDI file");
}

#[test]
fn a_truncated_file_is_refused_with_what_is_missing() {
    check_refused("cut.mid", &bach()[..1000], "track 1 of the MIDI file cannot be read from byte");
}

#[test]
fn a_check_of_a_scene_reads_its_performance_and_says_where_it_is_named() {
    let folder = with("junk.mid", b"once upon a time");
    let scene = "keys = [{ range = \"C4\", instrument = \"grand-springs\" }]\n\
                 pianist.performance = \"junk.mid\"\n";
    fs::write(folder.join("scene.toml"), scene).expect("a file");
    let said = run(&folder, &["check", "scene.toml"]);
    assert_eq!(said.code, Some(2), "{said:?}");
    check_words(&said, &["scene.toml:2:23: ", "junk.mid cannot be played", "not a MIDI file"]);
}

#[test]
fn a_missing_file_is_named_with_the_folder_it_is_not_in() {
    let folder = folder("missing-performance");
    let arguments = ["run", "--virtual-time", "--performance", "missing.mid"];
    check(&folder, &arguments, 2, &["there is no file \"missing.mid\"", "correct the path"]);
}

#[test]
fn a_performance_that_is_not_there_is_answered_with_those_that_are() {
    let folder = folder("unknown-performance");
    let arguments = ["run", "--virtual-time", "--performance", "bach"];
    check(&folder, &arguments, 2, &["bach-bwv-846", "beethoven-ode-to-joy"]);
}
