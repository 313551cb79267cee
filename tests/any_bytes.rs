//! The host refuses or plays a file with any bytes, and never panics.

use std::fs;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use host::session::{RunOptions, RunSession};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::Index;
use scene::{Scene, check_file};

const BACH: &[u8] = include_bytes!("../configs/performances/bach-bwv-846.mid");
const MIXED: &[u8] = include_bytes!("../configs/scenes/mixed.toml");

fn damaged(bytes: &'static [u8]) -> impl Strategy<Value = Vec<u8>> {
    let places = vec((any::<Index>(), any::<u8>()), 0..4);
    (places, any::<Index>(), any::<bool>()).prop_map(move |(places, end, is_cut)| {
        let mut damaged = bytes.to_vec();
        for (place, byte) in places {
            damaged[place.index(bytes.len())] = byte;
        }
        damaged.truncate(if is_cut { end.index(bytes.len()) } else { bytes.len() });
        damaged
    })
}

fn with_file<T>(name: &str, bytes: &[u8], work: impl FnOnce(&str) -> T) -> T {
    let name = format!("{}-{name}", std::process::id());
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::write(&path, bytes).expect("a file");
    let done = work(path.to_str().expect("a path that is text"));
    fs::remove_file(&path).expect("it can go");
    done
}

fn play(scene: &Scene) {
    let options = RunOptions { duration: Some(2.0), virtual_time: true };
    if let Ok(session) = RunSession::prepare(scene, options, &|_| {}) {
        let report = session.run(&AtomicBool::new(false)).expect("a run that was prepared");
        assert_eq!(report.extent.voices, scene.keys.iter().flatten().count());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn any_bytes_as_a_scene(bytes in vec(any::<u8>(), 0..300)) {
        with_file("any.toml", &bytes, |path| {
            assert!(Scene::load(&scene::Library::default(), path, &[]).is_err(), "bytes by chance are no scene");
            assert!(check_file(&scene::Library::default(), path.as_ref()).is_err());
        });
    }

    #[test]
    fn a_damaged_scene_is_refused_or_played(bytes in damaged(MIXED)) {
        with_file("damaged.toml", &bytes, |path| {
            let scene = Scene::load(&scene::Library::default(), path, &[]);
            assert_eq!(scene.is_ok(), check_file(&scene::Library::default(), path.as_ref()).is_ok());
            if let Ok(scene) = scene {
                play(&scene);
            }
        });
    }

    #[test]
    fn any_bytes_as_a_performance(bytes in vec(any::<u8>(), 0..300)) {
        assert!(pianist::read(&bytes).is_err());
        let headed = [&BACH[..14], &bytes[..]].concat();
        with_file("any.mid", &headed, perform);
    }

    #[test]
    fn a_damaged_performance_is_refused_or_played(bytes in damaged(BACH)) {
        with_file("damaged.mid", &bytes, perform);
    }
}

fn perform(path: &str) {
    let overrides = [(String::from("pianist.performance"), String::from(path))];
    if let Ok(scene) = Scene::load(&scene::Library::default(), "springs", &overrides) {
        play(&scene);
    }
}
