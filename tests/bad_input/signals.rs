//! A run in real time that is stopped by a signal.

use std::fs;
use std::path::Path;
use std::process::Child;

use midly::{MidiMessage, Smf, TrackEventKind};
use rustix::process::{Pid, Signal, kill_process};

use crate::letoff::{end, folder, start};

const UNDER_WAY: u64 = 6000;

#[test]
fn told_to_terminate_it_ends_all_notes_and_reports() {
    check_stopped_by("terminated", Signal::TERM);
}

#[test]
fn interrupted_it_ends_all_notes_and_reports() {
    check_stopped_by("interrupted", Signal::INT);
}

#[track_caller]
fn check_stopped_by(name: &str, signal: Signal) {
    let folder = folder(name);
    let arguments =
        ["run", "bach", "--duration", "60", "--midi", "played.mid", "--json", "--quiet"];
    // A file of an earlier run must not pass for this one's.
    fs::write(folder.join("played.mid"), []).expect("an empty file");
    let mut child = start(&folder, &arguments);
    wait_until_under_way(&mut child);
    kill_process(Pid::from_child(&child), signal).expect("it is there");
    let said = end(child);
    assert_eq!((said.code, said.err.as_str()), (Some(0), ""), "{said:?}");
    let report = said.report();
    let ticks = report["ticks"].as_u64().expect("a count");
    assert!((UNDER_WAY / 2..60_000).contains(&ticks), "{ticks} ticks");
    let notes = check_notes_end(&folder.join("played.mid"));
    assert!(5 < notes, "{notes} notes");
    assert_eq!(report["strikes"].as_u64(), Some(notes), "{report}");
}

/// Polls until the tick's thread has slept `UNDER_WAY` times, once in each tick.
fn wait_until_under_way(child: &mut Child) {
    let tasks = format!("/proc/{}/task", child.id());
    while sleeps(Path::new(&tasks)).is_none_or(|sleeps| sleeps < UNDER_WAY) {
        let ended = child.try_wait().expect("it is ours");
        assert!(ended.is_none(), "it ended by itself: {ended:?}");
        std::thread::yield_now();
    }
}

fn sleeps(tasks: &Path) -> Option<u64> {
    let folders = fs::read_dir(tasks).ok()?.filter_map(Result::ok).map(|entry| entry.path());
    let is_tick = |folder: &std::path::PathBuf| {
        fs::read_to_string(folder.join("comm")).is_ok_and(|name| name.trim() == "letoff-tick")
    };
    let status = fs::read_to_string(folders.into_iter().find(is_tick)?.join("status")).ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("voluntary_ctxt_switches:"))?;
    line.trim().parse().ok()
}

/// Asserts that no note of the file keeps sounding; returns their number.
#[track_caller]
fn check_notes_end(path: &Path) -> u64 {
    let bytes = fs::read(path).expect("a MIDI file");
    let smf = Smf::parse(&bytes).expect("a good MIDI file");
    let (mut sounding, mut notes) = ([false; 128], 0);
    for event in smf.tracks.iter().flatten() {
        let TrackEventKind::Midi { message, .. } = event.kind else { continue };
        match message {
            MidiMessage::NoteOn { key, vel } if 0 < vel.as_int() => {
                assert!(!sounding[usize::from(key.as_int())], "{key} was struck while sounding");
                sounding[usize::from(key.as_int())] = true;
                notes += 1;
            }
            MidiMessage::NoteOn { key, .. } | MidiMessage::NoteOff { key, .. } => {
                sounding[usize::from(key.as_int())] = false;
            }
            MidiMessage::Controller { .. }
            | MidiMessage::Aftertouch { .. }
            | MidiMessage::ProgramChange { .. }
            | MidiMessage::ChannelAftertouch { .. }
            | MidiMessage::PitchBend { .. } => {}
        }
    }
    assert_eq!(sounding.iter().filter(|sounding| **sounding).count(), 0, "notes hang");
    notes
}
