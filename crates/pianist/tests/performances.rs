//! The pieces in `configs/performances`: as written, as encoded, and as playable.

use std::io::Write as _;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::{fs, thread};

use pianist::{PassedOverCounts, Score, read};

const PIECES: [&str; 2] = ["bach-bwv-846", "beethoven-ode-to-joy"];

fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../configs/performances").join(name)
}

/// Returns the encoder's output or error for a written score; `None` without Python.
fn encode(text: &str) -> Option<Result<Vec<u8>, String>> {
    let mut encoder = Command::new("python3");
    encoder.arg(path("encode_score.py")).args(["/dev/stdin", "/dev/stdout"]);
    encoder.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let Ok(mut encoder) = encoder.spawn() else {
        let why = "SKIPPED: there is no python3: the written scores were not encoded";
        let _closed = writeln!(std::io::stderr(), "{why}");
        return None;
    };
    let (mut stdin, text) = (encoder.stdin.take().expect("piped"), text.to_owned());
    let writer = thread::spawn(move || stdin.write_all(text.as_bytes()));
    let output = encoder.wait_with_output().expect("an encoder that ends");
    writer.join().expect("no panic").expect("an encoder that reads");
    let report = || String::from_utf8_lossy(&output.stderr).into_owned();
    Some(if output.status.success() { Ok(output.stdout) } else { Err(report()) })
}

fn score(piece: &str) -> Score {
    read(&fs::read(path(&format!("{piece}.mid"))).expect("the encoded score")).expect("a score")
}

#[test]
fn every_midi_file_is_what_its_score_says() {
    for piece in PIECES {
        let text = fs::read_to_string(path(&format!("{piece}.score"))).expect("the written score");
        let Some(encoded) = encode(&text) else { return };
        let committed = fs::read(path(&format!("{piece}.mid"))).expect("the encoded score");
        assert!(
            encoded.expect("a score without mistakes") == committed,
            "{piece}.mid is out of date: python3 configs/performances/encode_score.py \
             configs/performances/{piece}.score"
        );
    }
}

#[test]
fn every_piece_is_long_enough_dynamic_and_playable() {
    for piece in PIECES {
        let score = score(piece);
        let velocities = score.notes.iter().map(|note| note.velocity);
        let softest = velocities.clone().min().expect("notes");
        let loudest = velocities.max().expect("notes");
        assert!(score.end() >= 60.0, "{piece} lasts {} s", score.end());
        assert!((28..=40).contains(&softest), "{piece}: softest {softest}");
        assert!((85..=106).contains(&loudest), "{piece}: loudest {loudest}");
        assert_eq!(score.passed_over, PassedOverCounts::default(), "{piece}");
        assert!(shortest_repetition(&score) >= 0.25, "{piece}");
    }
}

/// Returns the shortest time between two onsets of one key (s).
fn shortest_repetition(score: &Score) -> f64 {
    let onsets = |key| score.notes.iter().filter(move |n| n.key == key).map(|n| n.onset);
    let gaps = (0..88).flat_map(|key| onsets(key).skip(1).zip(onsets(key)).map(|(b, a)| b - a));
    gaps.fold(f64::INFINITY, f64::min)
}

#[test]
fn the_prelude_has_its_549_notes_and_changes_pedal_in_every_bar() {
    let score = score("bach-bwv-846");
    // 32 bars of 16, two of 16 and a chord of five.
    assert_eq!(score.notes.len(), 32 * 16 + 2 * 16 + 5);
    let pressed = score.pedals.iter().filter(|pedal| pedal.depth > 0.5).count();
    assert_eq!(pressed, 35);
    // The first half bar: C4 E4 G4 C5 E5 G4 C5 E5.
    let keys: Vec<_> = score.notes[..8].iter().map(|note| note.key + 21).collect();
    assert_eq!(keys, [60, 64, 67, 72, 76, 67, 72, 76]);
}

#[test]
fn a_mistake_in_a_score_is_reported_with_its_line() {
    let check = |text: &str, expected: &str| {
        let Some(encoded) = encode(text) else { return };
        let error = encoded.expect_err("must be refused");
        assert!(error.starts_with(&format!("/dev/stdin:{expected}")), "{error}");
    };
    let start = "meter 4/4\nvoice a 0\nbar 1\n";
    check("bar 1", "1: give the meter");
    check(&format!("{start}bar 3"), "4: this is bar 2, not 3");
    check(&format!("{start}a: C4/2\nbar 2"), "5: voice a does not fill bar 1");
    check(&format!("{start}a: H4/1"), "4: \"H4\" is not a pitch");
    check(&format!("{start}a: C4/3"), "4: \"3\" is not a length");
    check(&format!("{start}b: C4/1"), "4: no voice is called \"b\"");
    check(&format!("{start}allegro"), "4: \"allegro\" is none of");
}

#[test]
fn a_tie_makes_one_note_of_two() {
    let text = "meter 4/4\ntempo 60\nvoice a 0\ndynamic p\nbar 1\na: r/2. C4/4~\nbar 2\na: C4/1";
    let Some(encoded) = encode(text) else { return };
    let score = read(&encoded.expect("right")).expect("a score");
    assert_eq!(score.notes.len(), 1);
    assert_eq!((score.notes[0].onset, score.notes[0].end), (3.0, 8.0));
}
