//! `letoff record`, `letoff replay` and `letoff dash`, as they are typed.

#![expect(clippy::expect_used, reason = "helpers of tests")]

use std::path::{Path, PathBuf};
use std::process::Command;

/// A folder of this test's own.
fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("letoff-typed-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// What a command said: its exit code, output and complaints.
fn letoff(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_letoff"));
    command.args(arguments).current_dir(folder);
    // Nobody else's host, window or home.
    command.env("LETOFF_SOCKET", folder.join("socket")).env("PATH", folder).env("HOME", folder);
    let output = command.stdin(std::process::Stdio::null()).output().expect("a process");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

/// A recording of three seconds, in which the piece begins.
fn recorded(folder: &Path) {
    let arguments = ["record", "a.mcap", "--virtual-time", "--duration", "3"];
    let (code, _out, err) = letoff(folder, &arguments);
    assert_eq!(code, Some(0), "{err}");
}

#[test]
fn a_run_is_recorded_replayed_and_exported() {
    let folder = folder("whole");
    recorded(&folder);
    let (code, out, err) = letoff(&folder, &["replay", "a.mcap"]);
    assert_eq!(code, Some(0), "{err}");
    assert!(out.contains("the same to the last bit"), "{out}");
    let (code, out, _err) = letoff(&folder, &["replay", "a.mcap", "--json"]);
    assert_eq!(code, Some(0));
    assert!(out.contains("\"different\": 0") && out.contains("\"ticks\": 3000"), "{out}");
    let (code, _out, err) = letoff(&folder, &["replay", "a.mcap", "--export", "csv"]);
    assert_eq!(code, Some(0), "{err}");
    let events = std::fs::read_to_string(folder.join("csv/events.csv")).expect("events");
    assert!(events.contains("strike"), "{events}");
}

#[test]
fn a_recording_is_not_written_over() {
    let folder = folder("twice");
    recorded(&folder);
    let before = std::fs::read(folder.join("a.mcap")).expect("a recording");
    let (code, _out, err) = letoff(&folder, &["record", "a.mcap", "--duration", "1"]);
    assert_eq!((code, err.contains("a.mcap")), (Some(2), true), "{err}");
    assert_eq!(std::fs::read(folder.join("a.mcap")).expect("a recording"), before);
}

#[test]
fn what_is_no_recording_is_refused_in_a_sentence() {
    let folder = folder("bad");
    std::fs::write(folder.join("text.mcap"), "once upon a time").expect("a file");
    for file in ["text.mcap", "nothing.mcap"] {
        let (code, out, err) = letoff(&folder, &["replay", file]);
        assert_eq!((code, out.as_str()), (Some(2), ""), "{err}");
        assert!(err.contains(file) && err.lines().count() == 1, "{err}");
    }
}

#[test]
fn a_recording_that_was_cut_is_replayed_up_to_the_tear() {
    let folder = folder("cut");
    recorded(&folder);
    let whole = std::fs::read(folder.join("a.mcap")).expect("a recording");
    std::fs::write(folder.join("cut.mcap"), &whole[..whole.len() / 2]).expect("a part of it");
    let (_code, out, err) = letoff(&folder, &["replay", "cut.mcap", "--json"]);
    assert!(err.contains("cut.mcap"), "{err}");
    assert!(out.contains("\"ticks\": "), "{out}");
}

#[test]
fn without_a_window_or_a_host_dash_says_what_to_do() {
    let folder = folder("dash");
    let (code, _out, err) = letoff(&folder, &["dash"]);
    assert_eq!(code, Some(1));
    let is_said = err.contains("cargo build") || err.contains("letoff run");
    assert!(is_said && err.lines().count() == 1, "{err}");
}
