//! Voices of a model that was read from a file, beside those of the same model of the program.

// Its mistakes are those of the crate `diagnostics`.
#[path = "../../descriptions/tests/ball/mod.rs"]
mod ball;

use std::fs;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use descriptions::{install, register_model};
use equations::table::{Arguments, FunctionId, Functions, ModelTable, NamedQuantity};
use models::catalogue;
use scene::{FileKind, KeyVoice, Scene, check_file, written};
use scheduler::motion::KeySample;
use scheduler::observation::VoiceObservation;
use scheduler::values::ModelValues;
use scheduler::voice::VoiceOutput;

use crate::builder::VoiceBuilder;
use ball::{Ball, BallReader, START, TABLE, quantity};

/// A scene beside the description of its model.
fn scene(folder: &std::path::Path) -> Scene {
    install(&BallReader);
    fs::write(folder.join("my-ball.toml"), "[modes]\n[rest]\n").unwrap();
    let path = folder.join("scene.toml");
    fs::write(&path, "[[keys]]\nrange = \"A0..C8\"\nmodel = \"my-ball.toml\"\n").unwrap();
    Scene::load(&path.to_string_lossy(), &[]).unwrap_or_else(|wrong| panic!("{wrong}"))
}

#[test]
fn a_scene_names_a_description_by_its_path_and_is_written_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene(folder.path());
    let voices = || scene.keys.iter().flatten();
    let model = voices().next().unwrap().model;
    assert_eq!((model.name, voices().count()), ("described-ball", 88));
    assert!(voices().all(|voice| voice.model.is(model)));
    let again =
        Scene::from_text("again", written(&scene)).unwrap_or_else(|wrong| panic!("{wrong}"));
    assert!(again.keys.iter().flatten().all(|voice| voice.model.is(model)));
    let kind = check_file(&folder.path().join("my-ball.toml"));
    assert_eq!(kind, Ok(FileKind::Model));
}

#[test]
fn a_mistake_in_a_description_is_told_with_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let _scene = scene(folder.path());
    fs::write(folder.path().join("my-ball.toml"), "nothing").unwrap();
    let wrong = Scene::load(&folder.path().join("scene.toml").to_string_lossy(), &[]).unwrap_err();
    assert!(wrong.to_string().contains("my-ball.toml:1:1: this is no ball"), "{wrong}");
}

#[test]
fn a_voice_of_a_described_model_plays_as_that_of_the_written_one() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene(folder.path());
    let builder = VoiceBuilder::new(&scene).unwrap();
    let described = scene.keys[0].as_ref().unwrap();
    // 1 kg, from 1 m, on a floor that goes with the key.
    let model = catalogue::built_in("bouncing-ball").unwrap();
    let written = KeyVoice { model, values: vec![9.81, 0.8, 1.0, 1.0, 1.0] };
    let mut voices = [described, &written].map(|it| builder.voice(it, Arc::default()).unwrap());
    let [mut seen, mut felt] = [[0.0; 2]; 2];
    let mut most: f64 = 0.0;
    for voice in &mut voices {
        voice.reset(&KeySample::fresh(0.0));
    }
    for tick in 0..600_u64 {
        // Moved all the time, so that no voice rests.
        let sample = KeySample::fresh(1e-3 * (0.01 * tick as f64).sin());
        for (index, voice) in voices.iter_mut().enumerate() {
            let mut turn = VoiceOutput::default();
            voice.tick(tick, &sample, &mut turn);
            assert_eq!(turn.fault, None, "tick {tick}");
            let mut observed = VoiceObservation::default();
            voice.observe(&mut observed);
            (seen[index], felt[index]) = (observed.snapshot.state[0], turn.force);
            assert_eq!(observed.snapshot.structure(), 0, "in flight");
        }
        assert!((seen[0] - seen[1]).abs() < 1e-12, "tick {tick}: {seen:?}");
        assert!((felt[0] - felt[1]).abs() < 1e-9, "tick {tick}: {felt:?}");
        most = most.max(felt[0].abs());
    }
    assert!(most > 1.0, "the impact was felt: {most} N");
}

#[test]
fn values_of_another_version_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let first = scene(folder.path());
    let builder = VoiceBuilder::new(&first).unwrap();
    let old = first.keys[0].as_ref().unwrap();
    let mut voice = builder.voice(old, Arc::default()).unwrap();
    fs::write(folder.path().join("my-ball.toml"), "[modes]\n[rest]\n# new\n").unwrap();
    let path = folder.path().join("scene.toml");
    let second = Scene::load(&path.to_string_lossy(), &[]).unwrap();
    let new = second.keys[0].as_ref().unwrap();
    assert_eq!(old.model.name, new.model.name);
    let values = |of: &KeyVoice| ModelValues::new(of.model.name, 1, &of.values).unwrap();
    assert!(!voice.retune(&values(new)), "a newer version may have other parameters");
    assert!(voice.retune(&values(old)));
}

#[test]
fn a_voice_of_another_version_goes_on_where_the_old_one_is() {
    let folder = tempfile::tempdir().unwrap();
    let first = scene(folder.path());
    fs::write(folder.path().join("my-ball.toml"), "[modes]\n[rest]\n# another\n").unwrap();
    let path = folder.path().join("scene.toml");
    let second = Scene::load(&path.to_string_lossy(), &[]).unwrap();
    let [old, new] = [&first, &second].map(|scene| scene.keys[0].as_ref().unwrap());
    assert!(!old.model.is(new.model));
    let builder = VoiceBuilder::new(&first).unwrap();
    let mut voices = [old, old].map(|it| builder.voice(it, Arc::default()).unwrap());
    let mut seen = [[0.0; 2]; 2];
    for voice in &mut voices {
        voice.reset(&KeySample::fresh(0.0));
    }
    for tick in 0..600_u64 {
        if tick == 217 {
            let mut next = builder.voice(new, Arc::default()).unwrap();
            assert!(next.take_over(voices[1].as_ref()));
            voices[1] = next;
        }
        let sample = KeySample::fresh(1e-3 * (0.01 * tick as f64).sin());
        for (voice, seen) in voices.iter_mut().zip(&mut seen) {
            let mut turn = VoiceOutput::default();
            voice.tick(tick, &sample, &mut turn);
            assert_eq!(turn.fault, None, "tick {tick}");
            let mut observed = VoiceObservation::default();
            voice.observe(&mut observed);
            *seen = [observed.snapshot.state[0], observed.snapshot.input[1]];
        }
        // The ball's height, and how fast the key is known to move.
        let near = |index: usize| (seen[0][index] - seen[1][index]).abs() < 1e-12;
        assert!(near(0) && near(1), "tick {tick}: {seen:?}");
    }
    let other = KeyVoice { model: catalogue::built_in("spring-wall").unwrap(), values: vec![] };
    let mut other = builder.voice(&other, Arc::default()).unwrap();
    assert!(!other.take_over(voices[0].as_ref()), "another model has no such mode: it is reset");
}

/// A ball that can turn, and that counts how often its rest is worked out.
#[derive(Debug)]
struct TurningBall {
    rests: AtomicU32,
}

/// How far it has turned at rest (rad).
const TURNED: f64 = 0.5;

impl Functions for TurningBall {
    fn call(&self, function: FunctionId, arguments: &Arguments<'_>, out: &mut [f64]) {
        Ball.call(function, arguments, out);
        if let (START, [_height, turned, ..]) = (function, out) {
            self.rests.fetch_add(1, Ordering::Relaxed);
            *turned = TURNED;
        }
    }
}

#[test]
fn a_voice_that_takes_over_works_out_no_rest_and_keeps_that_of_entries_that_are_new() {
    static FUNCTIONS: TurningBall = TurningBall { rests: AtomicU32::new(0) };
    const STATES: &[NamedQuantity] =
        &[quantity("y", "m"), quantity("turned", "rad"), quantity("v", "m/s")];
    let folder = tempfile::tempdir().unwrap();
    let scene = scene(folder.path());
    let builder = VoiceBuilder::new(&scene).unwrap();
    let ball = scene.keys[0].as_ref().unwrap();
    let table = Box::leak(Box::new(ModelTable { states: STATES, ..TABLE }));
    let model = register_model(table, &FUNCTIONS, None).unwrap();
    let turning = KeyVoice { model, values: ball.values.clone() };
    let mut voice = builder.voice(ball, Arc::default()).unwrap();
    voice.reset(&KeySample::fresh(0.0));
    for tick in 0..100 {
        voice.tick(tick, &KeySample::fresh(0.0), &mut VoiceOutput::default());
    }
    let mut next = builder.voice(&turning, Arc::default()).unwrap();
    let rests = FUNCTIONS.rests.load(Ordering::Relaxed);
    assert!(0 < rests, "it was built at rest");
    assert!(next.take_over(voice.as_ref()));
    assert_eq!(FUNCTIONS.rests.load(Ordering::Relaxed), rests, "in the tick");
    let [before, after] = [voice.as_ref(), next.as_ref()].map(|voice| {
        let mut seen = VoiceObservation::default();
        voice.observe(&mut seen);
        seen.snapshot.state
    });
    let [y, v, ..] = before;
    assert!(y < 0.96 && v < -0.9, "{before:?}");
    assert_eq!(after[..3], [y, TURNED, v]);
}
