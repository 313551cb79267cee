//! Voices of a model that was read from a file.

use std::fs;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};

use instruments::equations::table::{Arguments, FunctionId, Functions};
use instruments::{LoadedModel, SharedFunctions};
use mechanism::{derive, description};
use scene::{FileKind, KeyVoice, Library, Scene, check_file, written};
use scheduler::motion::KeySample;
use scheduler::observation::{ModelSnapshot, VoiceObservation};
use scheduler::values::ModelValues;
use scheduler::voice::{Voice, VoiceOutput};

use crate::voice::builder::VoiceBuilder;

/// Writes the ball's description to `folder`, followed by `changed`.
fn write_ball(folder: &Path, changed: &str) {
    let text = description("bouncing-ball").unwrap();
    fs::write(folder.join("my-ball.toml"), format!("{text}{changed}")).unwrap();
}

fn scene(library: &Library, folder: &Path) -> Scene {
    write_ball(folder, "");
    let path = folder.join("scene.toml");
    fs::write(&path, "[[keys]]\nrange = \"A0..C8\"\nmodel = \"my-ball.toml\"\n").unwrap();
    load(library, folder)
}

fn load(library: &Library, folder: &Path) -> Scene {
    let path = folder.join("scene.toml");
    Scene::load(library, &path.to_string_lossy(), &[]).unwrap_or_else(|wrong| panic!("{wrong}"))
}

fn snapshot(voice: &dyn Voice) -> ModelSnapshot {
    let mut observed = VoiceObservation::default();
    voice.observe(&mut observed);
    observed.snapshot
}

#[test]
fn a_scene_names_a_description_by_its_path_and_is_written_with_it() {
    let (library, folder) = (Library::default(), tempfile::tempdir().unwrap());
    let scene = scene(&library, folder.path());
    let voices = || scene.keys.iter().flatten();
    let model = &voices().next().unwrap().model;
    assert_eq!((model.name, voices().count()), ("bouncing-ball", 88));
    assert!(voices().all(|voice| voice.model.is(model)));
    let again = Scene::from_text(&library, "again", written(&scene));
    let again = again.unwrap_or_else(|wrong| panic!("{wrong}"));
    assert!(again.keys.iter().flatten().all(|voice| voice.model.is(model)));
    let kind = check_file(&library, &folder.path().join("my-ball.toml"));
    assert_eq!(kind, Ok(FileKind::Model));
}

#[test]
fn values_of_another_version_are_refused() {
    let (library, folder) = (Library::default(), tempfile::tempdir().unwrap());
    let first = scene(&library, folder.path());
    let builder = VoiceBuilder::new(&first).unwrap();
    let old = first.keys[0].as_ref().unwrap();
    let mut voice = builder.voice(old, Arc::default()).unwrap();
    write_ball(folder.path(), "# new\n");
    let second = load(&library, folder.path());
    let new = second.keys[0].as_ref().unwrap();
    assert_eq!(old.model.name, new.model.name);
    let values = |of: &KeyVoice| ModelValues::new(of.model.id(), 1, &of.values).unwrap();
    assert!(!voice.retune(&values(new)), "a newer version may have other parameters");
    assert!(voice.retune(&values(old)));
}

#[test]
fn a_voice_of_another_version_continues_where_the_old_one_is() {
    let (library, folder) = (Library::default(), tempfile::tempdir().unwrap());
    let first = scene(&library, folder.path());
    write_ball(folder.path(), "# another\n");
    let second = load(&library, folder.path());
    let [old, new] = [&first, &second].map(|scene| scene.keys[0].as_ref().unwrap());
    assert!(!old.model.is(&new.model));
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
        // Moved all the time, so that no voice rests.
        let sample = KeySample::fresh(1e-3 * (0.01 * tick as f64).sin());
        for (voice, seen) in voices.iter_mut().zip(&mut seen) {
            let mut output = VoiceOutput::default();
            voice.tick(tick, &sample, &mut output);
            assert_eq!(output.fault, None, "tick {tick}");
            let snapshot = snapshot(voice.as_ref());
            *seen = [snapshot.state[0], snapshot.input[1]];
        }
        // The ball's height, and the estimated key speed.
        let near = |index: usize| (seen[0][index] - seen[1][index]).abs() < 1e-12;
        assert!(near(0) && near(1), "tick {tick}: {seen:?}");
    }
    let wall = library.find("spring-wall", Path::new("")).unwrap();
    let other = KeyVoice { model: wall, values: vec![], file: None };
    let mut other = builder.voice(&other, Arc::default()).unwrap();
    assert!(!other.take_over(voices[0].as_ref()), "another model has no such mode: it is reset");
}

struct CountedRest {
    functions: SharedFunctions,
    rest: FunctionId,
    count: AtomicU32,
}

impl Functions for CountedRest {
    fn call(&self, function: FunctionId, arguments: &Arguments<'_>, out: &mut [f64]) {
        if function == self.rest {
            self.count.fetch_add(1, Ordering::Relaxed);
        }
        self.functions.call(function, arguments, out);
    }
}

#[test]
fn a_voice_that_takes_over_computes_no_rest_and_keeps_that_of_new_entries() {
    let (library, folder) = (Library::default(), tempfile::tempdir().unwrap());
    let scene = scene(&library, folder.path());
    // A ball that can turn and is turned by half a radian at rest.
    let text = description("bouncing-ball").unwrap();
    let text = text.replace(
        "\n[speeds]",
        "turned = { unit = \"rad\", range = [\"-9 rad\", \"9 rad\"] }\n\n[speeds]",
    );
    let text = text.replace(
        "\n[rates]",
        "w = { unit = \"rad/s\", range = [\"-9 rad/s\", \"9 rad/s\"] }\n\n[rates]\nturned = \"w\"",
    );
    let text = text
        .replace("origin = [\"0 m\", \"y\"] }", "origin = [\"0 m\", \"y\"], turn = \"turned\" }");
    let text = text.replace("mass = \"mass\" }", "mass = \"mass\", inertia = \"1 kg*m^2\" }");
    let text = text.replace("y = \"s + y0\"", "y = \"s + y0\"\nturned = \"0.5 rad\"");
    let path = folder.path().join("turning.toml");
    fs::write(&path, text).unwrap();
    let derived =
        derive(&path.to_string_lossy()).unwrap_or_else(|why| panic!("{}", why.rendered()));
    let (table, functions) = (derived.program.table, derived.program.functions);
    let (functions, rest) = (Arc::new(functions), table.rest.state);
    let counted = Arc::new(CountedRest { functions, rest, count: AtomicU32::new(0) });
    let shared: SharedFunctions = Arc::<CountedRest>::clone(&counted);
    let model = Arc::new(LoadedModel::new(table, shared, None).unwrap());
    let builder = VoiceBuilder::new(&scene).unwrap();
    let ball = scene.keys[0].as_ref().unwrap();
    let turning = KeyVoice { model, values: ball.values.clone(), file: None };
    let mut voice = builder.voice(ball, Arc::default()).unwrap();
    voice.reset(&KeySample::fresh(0.0));
    for tick in 0..100 {
        voice.tick(tick, &KeySample::fresh(0.0), &mut VoiceOutput::default());
    }
    let mut next = builder.voice(&turning, Arc::default()).unwrap();
    let rests = counted.count.load(Ordering::Relaxed);
    assert!(0 < rests, "it was built at rest");
    assert!(next.take_over(voice.as_ref()));
    assert_eq!(counted.count.load(Ordering::Relaxed), rests, "in the tick");
    let [before, after] = [voice.as_ref(), next.as_ref()].map(|voice| snapshot(voice).state);
    let [y, v, ..] = before;
    assert!(y < 0.96 && v < -0.9, "{before:?}");
    assert_eq!(after[..4], [y, 0.5, v, 0.0]);
}
