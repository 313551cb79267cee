//! Every file in configs/ is valid, and embedded in the program.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use pianist::PassedOverCounts;
use scene::{FileKind, check_file};

#[test]
fn every_scene_loads_and_is_embedded() {
    check_shelf("scenes", FileKind::Scene, &scene::scenes().map(String::from).collect());
}

#[test]
fn every_scene_has_a_voice_on_each_key() {
    for name in scene::scenes() {
        let scene =
            scene::Scene::load(&scene::Library::default(), name, &[]).expect("a good scene");
        assert_eq!(scene.name, name);
        assert!(scene.keys.iter().all(Option::is_some), "{name} has silent keys");
    }
}

#[test]
fn every_description_is_a_model_that_its_name_finds() {
    let known: BTreeSet<_> = mechanism::model_names().map(String::from).collect();
    for name in names(&files("models", "toml")) {
        assert!(known.contains(&name), "{name} is not part of the program");
        let model = scene::Library::default().find(&name, Path::new(""));
        assert_eq!(model.expect("a good description").name, name);
    }
}

#[test]
fn every_instrument_loads_and_is_embedded() {
    let names = scene::instruments().into_iter().map(|instrument| instrument.name);
    check_shelf("instruments", FileKind::Instrument, &names.collect());
}

#[test]
fn every_performance_is_read_without_leaving_a_note_out_and_is_embedded() {
    let paths = files("performances", "mid");
    assert_eq!(names(&paths), scene::performances().map(String::from).collect());
    for path in paths {
        let score = pianist::read(&fs::read(&path).expect("a file"));
        let score = score.unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        assert!(20 < score.notes.len(), "{}", path.display());
        assert_eq!(score.passed_over, PassedOverCounts::default(), "{}", path.display());
    }
}

#[test]
fn no_file_in_configs_is_of_an_unknown_kind() {
    let known = ["README.md", "instruments", "models", "performances", "scenes", "service"]
        .map(String::from);
    let folders = fs::read_dir(configs()).expect("configs/").filter_map(Result::ok);
    let found: BTreeSet<_> =
        folders.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    assert_eq!(found, known.into());
    for folder in ["scenes", "instruments"] {
        let all = fs::read_dir(configs().join(folder)).expect("a folder").count();
        assert_eq!(files(folder, "toml").len(), all, "{folder} holds something else");
    }
}

#[track_caller]
fn check_shelf(folder: &str, kind: FileKind, embedded: &BTreeSet<String>) {
    let paths = files(folder, "toml");
    for path in &paths {
        assert_eq!(check_file(&scene::Library::default(), path), Ok(kind), "{}", path.display());
    }
    assert_eq!(&names(&paths), embedded);
}

fn files(folder: &str, ending: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(configs().join(folder)).expect("a folder of configs/");
    let paths = entries.filter_map(Result::ok).map(|entry| entry.path());
    paths.filter(|path| path.extension().is_some_and(|found| found == ending)).collect()
}

fn names(paths: &[PathBuf]) -> BTreeSet<String> {
    let stem = |path: &PathBuf| path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
    paths.iter().filter_map(stem).collect()
}

fn configs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("configs")
}
