//! The output equals the virtual pianist's piece, in whole runs in virtual time.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use engine::voice::VoiceBuilder;
use figures::rehearsal::{PlayedScore, perform};
use haptics::Gesture;
use host::RehearsalCache;
use host::control::RunHandle;
use host::report::RunReport;
use host::session::{FoundKeys, RunOptions, RunSession};
use midi::Velocity;
use midly::num::{u4, u7, u15, u28};
use midly::{Format, Header, MetaMessage, MidiMessage, Smf, Timing, TrackEvent, TrackEventKind};
use pianist::{Pianist, Score, ScoreNote, Technique};
use scene::Scene;

use crate::stage::{scene, try_scene};

/// Accuracy promised for 99 % of the notes: of time (ms), and of velocity.
const ONSET_MS: f64 = 1.0;
const VELOCITY: f64 = 2.0;

/// Energy from integration errors, as a share of the fingers' supply. The audit sums the supply by
/// quadrature over the pieces of a 1 ms tick, with an error of a thousandth of the flow at worst.
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
    let presets =
        "grand upright viennese harpsichord organ clavichord celesta rhodes hammond synth";
    for preset in presets.split(' ') {
        check_hard(preset);
    }
}

/// Asserts that the playable part of the hard passages is played by `preset`, that the rest is
/// named, and that no note continues.
#[track_caller]
fn check_hard(preset: &str) {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let [piece, output] =
        ["hard", "hard-played"].map(|it| folder.join(format!("{it}-{preset}.mid")));
    // Some actions play only every second of the repetitions at 12/s.
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

/// Returns repetitions at 12/s, a trill at 14/s, notes as soft as possible, and a key that is
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

/// Rehearses and plays notes of C4 on the default grand: onset, length (s), velocity, and release
/// velocity.
fn on_the_grand(notes: &[(f64, f64, u8, Option<u8>)]) -> PlayedScore {
    let scene = scene("default", &[]);
    let builder = VoiceBuilder::new(&scene).expect("a builder");
    let technique = Technique { hold: Gesture::hold_of(scene.rig.dip), ..Technique::default() };
    let pianist = Pianist { technique, ..Pianist::default() };
    let notes = notes.iter().map(|&(onset, length, velocity, release)| ScoreNote {
        key: 39,
        onset,
        end: onset + length,
        velocity,
        release: release.and_then(Velocity::new),
    });
    let score = Score { notes: notes.collect(), ..Score::default() };
    perform(&builder, &pianist, &score).expect("a performance")
}

#[test]
fn legato_on_one_key_leaves_the_same_gap_after_notes_of_any_length() {
    let played = on_the_grand(&[
        (0.0, 4.0, 50, None),
        (4.0, 2.0, 50, None),
        (6.0, 1.0, 50, None),
        (7.0, 0.5, 50, None),
    ]);
    let cuts: Vec<f64> = played.performance.cuts.iter().map(|cut| cut.by).collect();
    let (least, most) = (cuts[0].min(cuts[1]).min(cuts[2]), cuts[0].max(cuts[1]).max(cuts[2]));
    assert!(cuts.len() == 3 && most < 0.15 && most - least < 5e-3, "{cuts:?}");
    let found = &played.assessment;
    assert_eq!((found.missed, found.extra), (0, 0), "{found}");
    assert!(found.onset_error_ms.max < 2.0 && found.velocity_error.max <= 1.0, "{found}");
    assert!((found.end_error_ms.max - 1e3 * most).abs() < 1.0, "{found} {cuts:?}");
}

#[test]
fn a_long_note_keeps_its_length_before_one_that_cannot_be_met() {
    let played = on_the_grand(&[(0.0, 2.0, 64, None), (2.05, 0.5, 127, None)]);
    assert!(played.assessment.end_error_ms.max < 100.0, "{}", played.assessment);
    assert_eq!(played.performance.shortfalls.len(), 1, "{:?}", played.performance.shortfalls);
}

#[test]
fn a_key_is_repeated_softly_nine_times_a_second() {
    let velocities =
        [27, 13, 47, 35, 30, 22, 30, 25, 18, 28, 16, 49, 47, 46, 45, 33, 46, 25, 36, 41];
    let onsets = (0..).map(|n| 0.114 * f64::from(n));
    let notes = onsets.zip(velocities).map(|(onset, velocity)| (onset, 0.09, velocity, None));
    let found = on_the_grand(&notes.collect::<Vec<_>>()).assessment;
    assert!(found.missed <= 1 && found.extra == 0, "{found}");
    assert!(found.velocity_error.max <= 10.0 && found.onset_error_ms.max <= 30.0, "{found}");
}

#[test]
fn notes_end_when_and_as_fast_as_they_should() {
    // A slow release takes a third of a second, for which a short note has no time.
    let releases = [20, 35, 50, 60].into_iter().cycle();
    let notes = (0..16_u8).zip(releases).map(|(n, release)| {
        let (is_long, velocity) = (n % 4 < 2, 20 + 5 * n);
        let length = if is_long { 0.7 } else { 0.15 } + 0.02 * f64::from(n);
        (1.8 * f64::from(n), length, velocity, is_long.then_some(release + 15 * (n / 8)))
    });
    let played = on_the_grand(&notes.collect::<Vec<_>>());
    let found = &played.assessment;
    assert!(found.missed == 0 && found.end_error_ms.p99 <= 5.0, "{found}");
    let release = found.release_error.expect("release velocities");
    assert!(release.p99 <= 6.0, "{release:?}");
    assert!(played.performance.cuts.is_empty());
}

#[test]
fn a_rehearsal_takes_a_few_times_the_work_of_the_run() {
    // Every half second, mixed velocities and lengths, as all keys of a busy keyboard.
    let notes = (0..40_u8).map(|n| {
        let spread = f64::from(u32::from(n) * 37 % 40) / 40.0;
        let onset = 0.5 * f64::from(n) + 0.1 * spread;
        (onset, 0.15 + 0.2 * spread, 20 + (u32::from(n) * 29 % 80) as u8, None)
    });
    let played = on_the_grand(&notes.collect::<Vec<_>>());
    let [rehearsed, run] = played.evaluations;
    let ratio = rehearsed as f64 / run as f64;
    assert_eq!(played.assessment.missed, 0, "{}", played.assessment);
    assert!(ratio < 6.0, "{rehearsed} evaluations for {run}: {ratio}");
}

#[test]
fn a_rehearsal_is_found_by_the_next_run_with_the_same_bits_and_made_again_if_damaged() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("rehearsals");
    let _none = fs::remove_dir_all(&folder);
    let run = |program: &str, n_lanes| {
        let scene = scene("springs", &[("lanes", n_lanes)]);
        let options = RunOptions { duration: Some(5.0), virtual_time: true };
        let rehearsals = Some(RehearsalCache { folder: folder.clone(), program: program.into() });
        let handle = RunHandle::default().keeping_rehearsals(rehearsals);
        let found = FoundKeys::find(&scene, options).expect("keys");
        let session = RunSession::prepare_behind(Arc::new(handle), found, options, &|_| {});
        let session = session.expect("a session");
        let is_kept = session.is_rehearsal_kept();
        (is_kept, comparable(&session.run(&AtomicBool::new(false)).expect("a run")))
    };
    let (is_kept, first) = run("1", "1");
    assert!(!is_kept);
    assert_eq!(run("1", "2"), (true, first.clone()), "found, on 2 lanes");
    assert_eq!(run("2", "1"), (false, first.clone()), "another program");
    for file in fs::read_dir(&folder).expect("a folder") {
        let path = file.expect("a file").path();
        let mut bytes = fs::read(&path).expect("a rehearsal");
        let middle = bytes.len() / 2;
        bytes[middle] ^= 1;
        fs::write(&path, bytes).expect("a damaged file");
    }
    assert_eq!(run("1", "1"), (false, first.clone()), "damaged");
    assert_eq!(run("1", "1"), (true, first), "written again");
}

/// Returns the number of notes in a MIDI file, and of those without an end.
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
    // Some are late instead, by less than what is worse than a missing note.
    assert!((2..13).contains(&left_out.len()), "{notes:?}");
    assert!(notes.onset_error_ms.max < 33.0, "{notes:?}");
    assert!(left_out.iter().all(|it| it.key == "C4" && it.at_s < 3.0), "{left_out:?}");
    let said = report.to_string();
    assert!(left_out[0].why.starts_with("left out, since its key"), "{left_out:?}");
    let first = &notes.shortfalls[0];
    let first = format!("C4 at {:.3} s is {}", first.at_s, first.why);
    assert!(said.contains(&first), "{said}");
    assert!(said.contains("  result      poor: ") && said.contains("of the notes were missed"));
}

#[test]
fn a_play_list_is_played_again_and_again() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    let [one, two, output] = ["list-one", "list-two", "list-played"]
        .map(|it| folder.join(format!("{it}-{}.mid", std::process::id())));
    fs::write(&one, file(&[(60, 500, 900, 50), (64, 700, 900, 60)])).expect("a file");
    fs::write(&two, file(&[(60, 0, 300, 70)])).expect("a file");
    let list = format!("['{}', '{}']", one.display(), two.display());
    let output = output.to_str().expect("a path that is text");
    let changes = |n_lanes| {
        let list = list.as_str();
        let set = [("lanes", n_lanes), ("pianist.performance", list), ("midi.output", output)];
        scene("springs", &[&set[..], &[("pianist.repeat", "true")]].concat())
    };
    let played = |n_lanes| {
        let report = run(&changes(n_lanes), 22.5);
        (report, fs::read(output).expect("the MIDI file"))
    };
    let (report, bytes) = played("1");
    // A second before, two rests of two seconds: a pass of 10 s. The third is stopped at 2.5 s.
    check(&report, 8);
    let notes = report.notes.as_ref().expect("a pianist");
    assert_eq!((notes.pieces, notes.passes, notes.played), (2, 3, 8), "{notes:?}");
    let said = report.to_string();
    assert!(said.contains("pieces 2, passes 3; what follows is of one pass"), "{said}");
    let heard = pianist::read(&bytes).expect("what was played");
    let c4 = heard.notes.iter().filter(|note| note.key == 39).map(|note| note.onset);
    check_times(c4, &[1.5, 6.0, 11.5, 16.0, 21.5]);
    let pedals = heard.pedals.iter().map(|pedal| pedal.at).take_while(|at| *at < 20.0);
    check_times(pedals, &[3.0, 4.0, 8.0, 9.0, 13.0, 14.0, 18.0, 19.0]);
    let (again, again_bytes) = played("2");
    assert_eq!(comparable(&again), comparable(&report), "2 lanes");
    assert!(again_bytes == bytes, "the MIDI file differs on 2 lanes");
    let endless = RunOptions { duration: None, virtual_time: true };
    let refused = RunSession::prepare(&changes("1"), endless, &|_| {}).expect_err("no end");
    assert!(refused.to_string().contains("does not repeat"), "{refused}");
}

/// Asserts `times` (s) equal to `expected` within a tick.
#[track_caller]
fn check_times(times: impl Iterator<Item = f64>, expected: &[f64]) {
    let times: Vec<f64> = times.collect();
    let near = times.iter().zip(expected).all(|(time, wanted)| (time - wanted).abs() < 1e-3);
    assert!(near && times.len() == expected.len(), "{times:?}");
}

#[test]
fn a_play_list_that_is_cut_by_the_end_of_the_run_does_not_begin_again() {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("long.mid");
    fs::write(&path, file(&[(60, 500, 900, 50), (60, 20_000, 21_000, 50)])).expect("a file");
    let piece = path.to_str().expect("a path that is text");
    let set = [("pianist.performance", piece), ("pianist.repeat", "true")];
    let report = run(&scene("springs", &set), 12.0);
    let notes = report.notes.expect("a pianist");
    assert_eq!((notes.passes, notes.played, notes.struck, notes.extra), (1, 1, 1, 0), "{notes:?}");
}

/// Returns a file of `notes`, with the sustain pedal down from 2 s to 3 s.
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
        // At the usual tempo, 500 ticks a quarter are 1 ms each.
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

/// Asserts the promises on 30 s of scene `name`, with at least `least` notes, and the same bits
/// when played again and on another number of lanes.
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
    assert!(report.to_string().contains("  result      good: "), "{report}");
}

#[track_caller]
fn check_healthy(report: &RunReport) {
    let name = &report.scene;
    let totals = &report.totals;
    assert_eq!((totals.faults, totals.dropped, report.extent.skipped), (0, 0, 0), "{name}");
    assert_eq!((report.links.gaps, report.links.refused), (0, 0), "{name}");
    assert_eq!((report.midi.failed, report.deadline.missed), (0, 0), "{name}");
    let energy = report.energy_audit;
    let size = energy.supplied.abs() + energy.sampling.abs() + energy.jumps.abs();
    assert!(energy.residual.abs() < 1e-9 * (1.0 + size), "{name}: {energy:?}");
}

/// Records 30 s of scene `name` on `n_lanes`; returns the report and the MIDI file's bytes.
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

/// Returns a report without the number of lanes and the file's name.
fn comparable(report: &RunReport) -> serde_json::Value {
    let mut report = serde_json::to_value(report).expect("a report as JSON");
    report["lanes"].take();
    report["midi"]["output"].take();
    report
}
