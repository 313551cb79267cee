//! The sampler and the WAV file with a font of one cosine, which `font/cosine.py` writes.
#![expect(clippy::expect_used, reason = "a test that cannot be set up fails")]

use std::path::Path;

use midi::sound::{Font, Sampler, SoundError, WavFile};
use midi::{Message, Note, Output as _, Velocity};

const FONT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/font/cosine.sf2");

const RATE: u32 = 48_000;

fn font() -> Font {
    Font::find(Some(Path::new(FONT))).expect("our own font")
}

fn note(key: u8) -> Note {
    Note::from_key(key).expect("a key")
}

fn on(key: u8, velocity: u8) -> Message {
    Message::NoteOn { note: note(key), velocity: Velocity::nearest(f64::from(velocity)) }
}

fn off(key: u8) -> Message {
    Message::NoteOff { note: note(key), velocity: Velocity::UNKNOWN }
}

/// Numbers of a linear congruence, 0 ..= `below - 1`.
struct Random(u64);

impl Random {
    fn next(&mut self, below: u64) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % below
    }
}

/// Renders `n` frames; returns the left ones.
fn rendered(sampler: &mut Sampler, n: usize) -> Vec<f32> {
    let (mut left, mut right) = (vec![0.0; n], vec![0.0; n]);
    sampler.render(&mut left, &mut right);
    left
}

#[test]
fn each_of_ten_thousand_strikes_begins_with_its_own_frame() {
    let mut sampler = Sampler::new(&font(), RATE, &[1; 88]).expect("a rate");
    let mut random = Random(1994);
    for strike in 0..10_000 {
        let pause = usize::try_from(1000 + random.next(200)).expect("small");
        // The note before has ended.
        let silence = rendered(&mut sampler, pause);
        assert!(silence[900..].iter().all(|it| *it == 0.0), "strike {strike}");
        let key = u8::try_from(random.next(88)).expect("a key");
        sampler.play(on(key, 100));
        let sound = rendered(&mut sampler, 100);
        assert!(0.01 < sound[0].abs(), "strike {strike}, key {key}: {:?}", &sound[..4]);
        sampler.play(off(key));
    }
}

#[test]
fn a_wav_file_has_each_note_at_its_time_and_with_the_decay_of_the_font() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.wav");
    let mut wav = WavFile::new(&path, font(), [1; 88]);
    // Middle C at 0.25 s for a second, then silence, then a repetition.
    for (at, message) in [(1.25, off(39)), (0.25, on(39, 127)), (1.5, on(39, 127)), (1.6, off(39))]
    {
        wav.send(at, message).expect("a finite time");
    }
    wav.finish().expect("a file");
    let mut reader = hound::WavReader::open(&path).expect("a WAV file");
    assert_eq!((reader.spec().channels, reader.spec().sample_rate), (2, RATE));
    let left: Vec<f64> =
        reader.samples::<i16>().step_by(2).map(|it| f64::from(it.expect("a sample"))).collect();
    let first = |from: usize| left[from..].iter().position(|it| *it != 0.0).map(|at| at + from);
    assert_eq!((first(0), first(62_000)), (Some(12_000), Some(72_000)));
    // 184 frames are a period; the envelope falls by 40 dB in a second.
    let level = |at: usize| {
        let power: f64 = left[at..at + 184 * 4].iter().map(|it| it * it).sum();
        10.0 * power.log10()
    };
    let fallen = level(12_000 + 2_000) - level(12_000 + 2_000 + 24_000);
    assert!((fallen - 20.0).abs() < 0.2, "{fallen} dB in half a second");
    let crossings = left[12_000..36_000].windows(2).filter(|it| it[0] < 0.0 && 0.0 <= it[1]);
    let pitch = crossings.count() as f64 / 0.5;
    assert!((pitch - 260.87).abs() < 2.5, "{pitch} Hz");
}

#[test]
fn a_chord_of_all_keys_is_heard_and_pedals_hold_it() {
    let mut sampler = Sampler::new(&font(), RATE, &[1; 88]).expect("a rate");
    let pedal = |value| Message::ControlChange { controller: midi::Controller::Sustain, value };
    sampler.play(pedal(127));
    for key in 0..88 {
        // Keys are struck at their own times, also within a tick.
        sampler.play(on(key, 20));
        rendered(&mut sampler, 3);
        sampler.play(off(key));
    }
    let held = rendered(&mut sampler, 9600);
    assert!(held[9000..].iter().any(|it| it.abs() > 0.01));
    sampler.play(pedal(0));
    let silent = rendered(&mut sampler, 960);
    assert!(silent[480..].iter().all(|it| it.abs() < 1e-6));
}

#[test]
fn damaged_fonts_are_refused_in_a_sentence() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("damaged.sf2");
    let good = std::fs::read(FONT).expect("our own font");
    let mut random = Random(7);
    for length in (0..good.len()).step_by(97) {
        let mut bad = good[..length].to_vec();
        for _ in 0..3 {
            let at = usize::try_from(random.next(1 + length as u64)).expect("small");
            if let Some(byte) = bad.get_mut(at) {
                *byte ^= 0xFF;
            }
        }
        std::fs::write(&path, bad).expect("a file");
        let error = Font::find(Some(&path)).expect_err("it is cut");
        assert!(matches!(error, SoundError::Font { .. }), "{error}");
        assert!(error.to_string().contains("name another with --font"));
    }
}
