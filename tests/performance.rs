//! What the virtual pianist plays is what comes out, whole runs in virtual time.
#![expect(clippy::expect_used, reason = "helpers of tests, outside #[test]")]

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use host::report::RunReport;
use host::session::{RunOptions, RunSession};
use midly::num::{u4, u7, u15, u28};
use midly::{Format, Header, MetaMessage, MidiMessage, Smf, Timing, TrackEvent, TrackEventKind};
use scene::Scene;

use crate::stage::{scene, try_scene};

/// Promised of 99 % of the notes: how far from their time (ms), and from their velocity.
const ONSET_MS: f64 = 1.0;
const VELOCITY: f64 = 2.0;

/// Energy that integration may make, as a share of what the fingers supply.
///
/// The audit sums the supply by quadrature over the pieces of a 1 ms tick, whose error is a
/// thousandth of what passes through at worst.
const UNEXPLAINED: f64 = 2e-3;

#[test]
fn the_default_scene_is_played_as_written() {
    check_played("springs", 50);
}

#[test]
fn the_bach_scene_is_played_as_written() {
    check_played("bach", 100);
}

#[test]
fn the_fast_scene_is_played_as_written() {
    check(&run(&scene("fast", &[]), 10.0), 10);
}

#[test]
fn every_embedded_scene_runs_without_a_fault() {
    for name in scene::scenes() {
        check_healthy(&run(&scene(name, &[]), 3.0));
    }
}

#[test]
fn every_instrument_runs_on_all_keys_without_a_fault() {
    let stable = [("tick_hz", "4000"), ("render.jerk_density", "10")];
    cli::read_descriptions();
    let mut refused = Vec::new();
    for instrument in scene::instruments() {
        let chosen = [("keys.instrument", instrument.name.as_str())];
        let load = |more: &[(&str, &str)]| try_scene("springs", &[&chosen, more].concat());
        match load(&[]).or_else(|_unstable| load(&stable)) {
            Ok(scene) => check_healthy(&run(&scene, 3.0)),
            Err(_offline) => refused.push(instrument.name),
        }
    }
    assert_eq!(refused, ["paper-rigid"]);
}

#[test]
fn hard_passages_are_played_on_every_preset() {
    cli::read_descriptions();
    let presets = [
        "grand",
        "upright",
        "viennese",
        "harpsichord",
        "organ",
        "clavichord",
        "celesta",
        "rhodes",
        "hammond",
        "synth",
    ];
    for preset in presets {
        check_hard(preset);
    }
}

/// Asserts that what `preset` can play of the hard passages is played, that the rest is named, and
/// that no note goes on.
#[track_caller]
fn check_hard(preset: &str) {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let [piece, output] =
        ["hard", "hard-played"].map(|it| folder.join(format!("{it}-{preset}.mid")));
    // Of repetitions at 12/s some actions play every second only.
    fs::write(&piece, file(&hard())).expect("a file");
    let text = |path: &PathBuf| path.to_str().expect("a path that is text").to_owned();
    let (piece, output) = (text(&piece), text(&output));
    let changes =
        [("keys.instrument", preset), ("pianist.performance", &piece), ("midi.output", &output)];
    let report = run(&scene("springs", &changes), 7.0);
    check_healthy(&report);
    let notes = report.notes.as_ref().expect("a pianist");
    let left_out = notes.shortfalls.iter().filter(|it| it.is_left_out).count();
    assert_eq!((notes.missed, notes.extra), (left_out, 0), "{preset}: {notes:?}");
    assert!(notes.played == hard().len() && left_out <= 12, "{preset}: {notes:?}");
    let bytes = fs::read(&output).expect("the MIDI file");
    let (ons, hanging) = sounded(&bytes);
    assert_eq!((ons, hanging), (notes.struck, 0), "{preset}: {notes:?}");
}

/// Repetitions at 12/s, a trill at 14/s, notes as soft as can be written, and a key that is
/// released for 25 ms only, all on two keys.
fn hard() -> Vec<HardNote> {
    let repeated = (0..8).map(|i| (60, 500 + 83 * i, 540 + 83 * i, 60));
    let trill = (0..16).map(|i| (60 + 2 * (i % 2), 1600 + 71 * u32::from(i), 70));
    let trill = trill.map(|(key, at, velocity)| (key, at, at + 64, velocity));
    let soft = (0..2).map(|i| (60 + 2 * i, 2900 + 120 * u32::from(i), 3500, 1));
    let half_released = (0..4).map(|i| (62, 4000 + 250 * i, 4225 + 250 * i, 50));
    repeated.chain(trill).chain(soft).chain(half_released).collect()
}

/// Key, onset and end (ms), velocity.
pub(crate) type HardNote = (u8, u32, u32, u8);

/// How many notes begin in a MIDI file, and how many of them do not end.
fn sounded(bytes: &[u8]) -> (usize, usize) {
    let (mut ons, mut on) = (0, BTreeSet::new());
    for event in Smf::parse(bytes).expect("a MIDI file").tracks.iter().flatten() {
        let TrackEventKind::Midi { message, .. } = event.kind else { continue };
        if let MidiMessage::NoteOn { key, .. } = message {
            ons += 1;
            on.insert(key);
        } else if let MidiMessage::NoteOff { key, .. } = message {
            on.remove(&key);
        }
    }
    (ons, on.len())
}

#[test]
fn what_the_keys_cannot_do_is_left_out_and_named() {
    // Twenty in a second, which no key can do, and one long after.
    let onsets: Vec<u32> = (0..16).map(|i| 50 * i).chain([4000]).collect();
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("repeated.mid");
    let notes: Vec<HardNote> = onsets.iter().map(|at| (60, *at, at + 40, 40)).collect();
    fs::write(&path, file(&notes)).expect("a file");
    let piece = path.to_str().expect("a path that is text");
    let report = run(&scene("springs", &[("pianist.performance", piece)]), 7.0);
    check_healthy(&report);
    let notes = report.notes.as_ref().expect("a pianist");
    let left_out: Vec<_> = notes.shortfalls.iter().filter(|it| it.is_left_out).collect();
    assert_eq!((notes.played, notes.extra), (onsets.len(), 0), "{notes:?}");
    assert_eq!((notes.missed, notes.struck), (left_out.len(), 17 - left_out.len()), "{notes:?}");
    assert!((4..13).contains(&left_out.len()), "{notes:?}");
    assert!(notes.onset_error_ms.max < ONSET_MS, "{notes:?}");
    assert!(left_out.iter().all(|it| it.key == "C4" && it.at_s < 3.0), "{left_out:?}");
    let said = report.to_string();
    let first = format!("C4 at {:.3} s is left out, since its key can", left_out[0].at_s);
    assert!(said.contains(&first), "{said}");
}

/// A file of `notes`, with the sustain pedal down from 2 s to 3 s.
pub(crate) fn file(notes: &[HardNote]) -> Vec<u8> {
    let on =
        |key: u8, velocity: u8| MidiMessage::NoteOn { key: u7::new(key), vel: u7::new(velocity) };
    let pedal =
        |value: u8| MidiMessage::Controller { controller: u7::new(64), value: u7::new(value) };
    let mut events = vec![(2000, pedal(127)), (3000, pedal(0))];
    for &(key, from, to, velocity) in notes {
        events.extend([(from, on(key, velocity)), (to, on(key, 0))]);
    }
    events.sort_by_key(|(at, _message)| *at);
    let mut track = Vec::new();
    let mut now = 0;
    for (at, message) in events {
        // At the usual tempo, 500 ticks a quarter are a thousandth of a second each.
        let kind = TrackEventKind::Midi { channel: u4::new(0), message };
        track.push(TrackEvent { delta: u28::new(at - now), kind });
        now = at;
    }
    let kind = TrackEventKind::Meta(MetaMessage::EndOfTrack);
    track.push(TrackEvent { delta: u28::new(0), kind });
    let header = Header::new(Format::SingleTrack, Timing::Metrical(u15::new(500)));
    let mut bytes = Vec::new();
    Smf { header, tracks: vec![track] }.write_std(&mut bytes).expect("a file");
    bytes
}

/// Asserts what is promised of 30 s of scene `name`, with `least` notes, and that it is the
/// same to the last bit when it is played again and on another number of lanes.
#[track_caller]
fn check_played(name: &str, least: usize) {
    let (report, midi) = recorded(name, "1");
    check(&report, least);
    assert!(least * 6 < midi.len(), "{} bytes of MIDI", midi.len());
    for n_lanes in ["1", "2"] {
        let (again, again_midi) = recorded(name, n_lanes);
        assert_eq!(comparable(&again), comparable(&report), "{n_lanes} lanes");
        assert!(again_midi == midi, "the MIDI file differs on {n_lanes} lanes");
    }
}

#[track_caller]
fn check(report: &RunReport, least: usize) {
    check_healthy(report);
    let notes = report.notes.as_ref().expect("a pianist");
    assert!(least <= notes.played, "{notes:?}");
    assert_eq!((notes.struck, notes.missed, notes.extra), (notes.played, 0, 0), "{notes:?}");
    assert!(notes.onset_error_ms.p99 < ONSET_MS, "{notes:?}");
    assert!(notes.velocity_error.p99 <= VELOCITY, "{notes:?}");
    let energy = report.energy_audit;
    assert!(0.0 < energy.supplied && 0.0 < energy.dissipated, "{energy:?}");
    assert!(energy.integration.abs() < UNEXPLAINED * energy.supplied, "{energy:?}");
}

#[track_caller]
fn check_healthy(report: &RunReport) {
    let name = &report.scene;
    assert_eq!((report.faults, report.dropped, report.skipped), (0, 0, 0), "{name}");
    assert_eq!((report.links.gaps, report.links.refused), (0, 0), "{name}");
    assert_eq!((report.midi.failed, report.deadline.missed), (0, 0), "{name}");
    let energy = report.energy_audit;
    let size = energy.supplied.abs() + energy.sampling.abs() + energy.jumps.abs();
    assert!(energy.residual.abs() < 1e-9 * (1.0 + size), "{name}: {energy:?}");
}

/// 30 s of scene `name` on `n_lanes`, and the bytes of the MIDI file that was written.
fn recorded(name: &str, n_lanes: &str) -> (RunReport, Vec<u8>) {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let path = folder.join(format!("{name}-{}.mid", std::process::id()));
    let output = path.to_str().expect("a path that is text");
    let report = run(&scene(name, &[("lanes", n_lanes), ("midi.output", output)]), 30.0);
    let bytes = fs::read(&path).expect("the MIDI file");
    fs::remove_file(&path).expect("it can go");
    (report, bytes)
}

fn run(scene: &Scene, seconds: f64) -> RunReport {
    let options = RunOptions { duration: Some(seconds), virtual_time: true };
    let session = RunSession::prepare(scene, options, &|_| {}).expect("a session");
    session.run(&AtomicBool::new(false)).expect("a run")
}

/// A report without what may differ: how many lanes there were, and what the file is called.
fn comparable(report: &RunReport) -> serde_json::Value {
    let mut report = serde_json::to_value(report).expect("a report as JSON");
    report["lanes"].take();
    report["midi"]["output"].take();
    report
}
