//! MIDI files as scores: times, overlaps and invalid files.

use midi::{Pedal, PedalMove};
use midly::num::{u4, u7, u15, u24, u28};
use midly::{
    Format, Fps, Header, MetaMessage, MidiMessage, Smf, Timing, TrackEvent, TrackEventKind,
};
use pianist::PassedOver::{Overlapping, SkippedBytes};
use pianist::{Score, ScoreError, ScoreNote, read};
use proptest::prelude::*;

fn event(delta: u32, channel: u8, message: MidiMessage) -> TrackEvent<'static> {
    let kind = TrackEventKind::Midi { channel: u4::new(channel), message };
    TrackEvent { delta: u28::new(delta), kind }
}

fn on(delta: u32, number: u8, velocity: u8) -> TrackEvent<'static> {
    event(delta, 0, MidiMessage::NoteOn { key: u7::new(number), vel: u7::new(velocity) })
}

fn off(delta: u32, number: u8) -> TrackEvent<'static> {
    event(delta, 0, MidiMessage::NoteOff { key: u7::new(number), vel: u7::new(64) })
}

fn tempo(delta: u32, us: u32) -> TrackEvent<'static> {
    let kind = TrackEventKind::Meta(MetaMessage::Tempo(u24::new(us)));
    TrackEvent { delta: u28::new(delta), kind }
}

fn file(timing: Timing, tracks: &[Vec<TrackEvent<'static>>]) -> Vec<u8> {
    let mut smf = Smf::new(Header::new(Format::Parallel, timing));
    for track in tracks {
        let mut track = track.clone();
        let kind = TrackEventKind::Meta(MetaMessage::EndOfTrack);
        track.push(TrackEvent { delta: u28::new(0), kind });
        smf.tracks.push(track);
    }
    let mut bytes = Vec::new();
    smf.write_std(&mut bytes).expect("memory");
    bytes
}

const PPQ_100: Timing = Timing::Metrical(u15::new(100));

fn score(track: &[TrackEvent<'static>]) -> Score {
    read(&file(PPQ_100, &[track.to_vec()])).expect("a score")
}

fn note(key: u8, onset: f64, end: f64, velocity: u8) -> ScoreNote {
    ScoreNote { key, onset, end, velocity, release: None }
}

#[test]
fn what_follows_the_last_track_and_is_no_chunk_is_passed_over() {
    let whole = file(PPQ_100, &[vec![on(0, 60, 70), off(100, 60)]]);
    for trailing in [&b"12345678"[..], b"\n", b"MTrk\xff\xff\xff\xff and less than that", &[0; 64]]
    {
        let more = [&whole, trailing].concat();
        let (more, whole) = (read(&more).expect("a score"), read(&whole).expect("a score"));
        assert_eq!(more.notes, whole.notes, "{trailing:?}");
        // Zeros are empty chunks of an unknown kind.
        let skipped = if trailing == [0; 64] { 0 } else { trailing.len() };
        assert_eq!(more.passed_over.of(SkippedBytes) as usize, skipped, "{trailing:?}");
    }
}

#[test]
fn smpte_time_ignores_tempo() {
    let timing = Timing::Timecode(Fps::Fps25, 40);
    let track = vec![tempo(0, 100), on(1500, 60, 70), off(500, 60)];
    let found = read(&file(timing, &[track])).expect("a score");
    assert_eq!(found.notes, [note(39, 1.5, 2.0, 70)]);
}

#[test]
fn of_notes_that_begin_together_the_loudest_stays() {
    let found = score(&[on(0, 60, 70), on(0, 60, 80), off(100, 60), off(100, 60)]);
    assert_eq!(found.notes, [note(39, 0.0, 1.0, 80)]);
    assert_eq!(found.passed_over.of(Overlapping), 1);
}

#[test]
fn a_release_velocity_is_kept_unless_it_says_that_it_is_unknown() {
    let off = |velocity| {
        let message = MidiMessage::NoteOff { key: u7::new(60), vel: u7::new(velocity) };
        score(&[on(0, 60, 70), event(100, 0, message)]).notes[0].release
    };
    assert_eq!(off(100), midi::Velocity::new(100));
    assert_eq!((off(64), off(0)), (None, None));
}

#[test]
fn pedal_moves_are_kept() {
    let pedal = |controller, value| MidiMessage::Controller {
        controller: u7::new(controller),
        value: u7::new(value),
    };
    let found = score(&[
        event(0, 0, pedal(64, 127)),
        on(0, 60, 70),
        event(20, 0, pedal(67, 127)),
        event(20, 0, pedal(65, 127)),
        event(20, 0, pedal(66, 0)),
        event(40, 0, pedal(64, 0)),
    ]);
    let moved: Vec<_> = found.pedals.iter().map(|it| (it.pedal, it.at, it.depth)).collect();
    let expected = [
        (Pedal::Sustain, 0.0, 1.0),
        (Pedal::UnaCorda, 0.1, 1.0),
        (Pedal::Sostenuto, 0.3, 0.0),
        (Pedal::Sustain, 0.5, 0.0),
    ];
    for (moved, expected) in moved.iter().zip(expected) {
        assert_eq!((moved.0, moved.2), (expected.0, expected.2));
        assert!((moved.1 - expected.1).abs() < 1e-9, "{moved:?}");
    }
    assert_eq!(moved.len(), expected.len(), "portamento is no pedal");
}

#[test]
fn a_piece_follows_after_a_rest_with_its_pedals_up() {
    let down = MidiMessage::Controller { controller: u7::new(64), value: u7::new(127) };
    let one = score(&[on(0, 60, 70), event(10, 0, down), off(20, 60)]);
    let pedals = |it: &Score| it.pedals.iter().map(|it| it.depth).collect::<Vec<_>>();
    let lifted = one.clone().with_pedals_lifted();
    assert_eq!((pedals(&one), pedals(&lifted)), (vec![1.0], vec![1.0, 0.0]));
    assert_eq!(lifted.clone().with_pedals_lifted(), lifted);
    let later = one.end() + 2.0;
    let both = lifted.followed_by(one.clone(), 2.0);
    assert_eq!((both.notes.len(), pedals(&both)), (2, vec![1.0, 0.0, 1.0]));
    assert_eq!((both.notes[1].onset, both.notes[1].end), (later, later + one.notes[0].end));
    assert_eq!(both.pedals[2].at.to_bits(), (later + one.pedals[0].at).to_bits());
}

#[track_caller]
fn check_refused(bytes: &[u8], sentence: &str) {
    let error = read(bytes).expect_err("must be refused").to_string();
    assert!(error.contains(sentence), "{error}");
}

#[test]
fn what_is_no_score_is_refused_in_one_sentence() {
    let whole = file(PPQ_100, &[vec![on(0, 60, 70), off(100, 60)]]);
    check_refused(b"", "the file is empty");
    check_refused(b"RIFF....WAVE", "not a MIDI file");
    check_refused(b"MTrk\0\0\0\0", "not a MIDI file");
    check_refused(b"MThd", "not a MIDI file");
    check_refused(&whole[..10], "not a MIDI file");
    check_refused(&whole[..14], "truncated: of 1 tracks only 0 are there");
    check_refused(
        &whole[..whole.len() - 8],
        "track 1 of the MIDI file cannot be read from byte 26",
    );
    check_refused(&file(Timing::Metrical(u15::new(0)), &[vec![on(0, 60, 70)]]), "no length");
    check_refused(
        &file(PPQ_100, &[vec![on(0, 10, 70)]]),
        "no notes to play on the 88 keys, and 1 notes off",
    );
    check_refused(&file(PPQ_100, &[]), "no notes to play on the 88 keys, and nothing besides");
    let mut patterns = whole;
    patterns[9] = 2;
    check_refused(&patterns, "holds 1 independent patterns (format 2): choose one, as --track 1");
}

#[test]
fn a_file_inside_riff_is_read() {
    let whole = file(PPQ_100, &[vec![on(0, 60, 70), off(100, 60)]]);
    let length = |bytes: usize| u32::try_from(bytes).expect("small").to_le_bytes();
    let inside = [b"RMIDdata".as_slice(), &length(whole.len()), &whole].concat();
    let riff = [b"RIFF".as_slice(), &length(inside.len()), &inside].concat();
    assert_eq!(read(&riff), read(&whole));
}

/// Returns bytes that begin like a MIDI file and continue at random.
fn almost_midi() -> impl Strategy<Value = Vec<u8>> {
    (any::<[u8; 6]>(), 0_u8..80, proptest::collection::vec(any::<u8>(), 0..80)).prop_map(
        |(header, length, body)| {
            let track = [b"MTrk\0\0\0".as_slice(), &[length], &body].concat();
            [b"MThd\0\0\0\x06".as_slice(), &header, &track].concat()
        },
    )
}

/// Checks the guarantees of every score.
fn check_sound(score: &Score) {
    for note in &score.notes {
        assert!(note.key < 88 && (1..=127).contains(&note.velocity), "{note:?}");
        assert!(note.onset.is_finite() && note.onset <= note.end && note.end.is_finite());
    }
    assert!(score.notes.is_sorted_by_key(|note| (note.onset, note.key)));
    let sound = |it: &PedalMove| it.at.is_finite() && (0.0..=1.0).contains(&it.depth);
    assert!(score.pedals.iter().all(sound));
}

proptest! {
    #[test]
    fn no_bytes_make_it_panic(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
        prop_assert!(read(&bytes).is_err() || bytes.starts_with(b"MThd"));
    }

    #[test]
    fn almost_midi_is_read_or_refused(bytes in almost_midi()) {
        if let Ok(score) = read(&bytes) {
            check_sound(&score);
        }
    }

    #[test]
    fn a_damaged_file_is_read_or_refused(at in 0_usize..60, value in any::<u8>(), cut in 0_usize..60) {
        let track = vec![tempo(0, 400_000), on(0, 60, 70), on(50, 60, 80), off(100, 60)];
        let mut bytes = file(PPQ_100, &[track.clone(), track]);
        let at = at % bytes.len();
        bytes[at] = value;
        match read(&bytes[..bytes.len() - cut % 40]) {
            Ok(score) => check_sound(&score),
            Err(error) => prop_assert_ne!(error, ScoreError::Empty),
        }
    }
}
