//! Unwritable places, and missing ports.

use std::fs::File;
use std::os::unix::fs::symlink;
use std::path::Path;

use crate::letoff::{check, folder, run, run_into};

const SHORT: [&str; 5] = ["run", "--virtual-time", "--duration", "3", "--json"];

#[test]
fn a_full_disk_costs_the_midi_file_and_not_the_report() {
    let folder = folder("full");
    let linked = symlink("/dev/full", folder.join("full.mid"));
    assert!(linked.is_ok() || folder.join("full.mid").is_symlink(), "{linked:?}");
    let arguments = [&SHORT[..], &["--midi", "full.mid"]].concat();
    let said =
        check(&folder, &arguments, 1, &["full.mid", "No space", "messages are lost with this run"]);
    let report = said.report();
    assert_eq!(report["ticks"], 3000);
    assert!(report["notes"]["struck"].as_u64() > Some(0), "{report}");
    assert!(report["midi"]["failed"].as_u64() > Some(0), "{report}");
}

#[test]
fn a_folder_that_is_not_there_costs_the_midi_file_and_not_the_report() {
    let folder = folder("nowhere");
    let arguments = [&SHORT[..], &["--midi", "nowhere/played.mid"]].concat();
    let said = run(&folder, &arguments);
    assert!(matches!(said.code, Some(1 | 2)), "{said:?}");
    assert_eq!(said.lines().len(), 1, "{said:?}");
    assert!(said.err.contains("nowhere/played.mid"), "{said:?}");
}

#[test]
fn a_port_that_is_not_there_is_named() {
    let folder = folder("port");
    let arguments = [&SHORT[..], &["--midi", "a port that nobody has"]].concat();
    if Path::new("/dev/snd/seq").exists() {
        check(&folder, &arguments, 2, &["a port that nobody has"]);
    } else {
        // A machine without MIDI is no error: the run continues, and prints the remedy.
        let said = run(&folder, &arguments);
        assert_eq!((said.code, said.err.as_str()), (Some(0), ""), "{said:?}");
        let midi = &said.report()["midi"];
        assert_eq!(midi["output"], "port \"a port that nobody has\"");
        assert!(midi["trouble"].as_str().is_some_and(|text| text.contains("no MIDI")), "{midi}");
    }
}

#[test]
fn a_report_that_nobody_can_take_is_a_failure() {
    let folder = folder("unheard");
    let full = File::options().write(true).open("/dev/full").expect("Linux");
    let said = run_into(full, &folder, &SHORT);
    assert_eq!((said.code, said.lines().len()), (Some(1), 1), "{said:?}");
    assert!(said.err.contains("No space"), "{said:?}");
}

#[test]
fn a_reader_that_has_left_has_read_enough() {
    let (reader, pipe) = std::io::pipe().expect("a pipe");
    drop(reader);
    let said = run_into(pipe, &folder("left"), &["instruments"]);
    assert_eq!((said.code, said.err.as_str()), (Some(0), ""), "{said:?}");
}
