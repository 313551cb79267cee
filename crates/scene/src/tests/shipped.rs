//! The files of configs/.

use descriptions::Library;
use std::fs;
use std::path::{Path, PathBuf};

use super::super::embedded::INSTRUMENTS;
use super::super::*;

fn configs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../configs")
}

#[track_caller]
fn check_embedded(folder: &str, ending: &str, mut known: Vec<&str>) {
    let paths = fs::read_dir(configs().join(folder)).unwrap().map(|entry| entry.unwrap().path());
    let mut there: Vec<String> = paths
        .filter(|path| path.extension().is_some_and(|found| found == ending))
        .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
        .collect();
    there.sort();
    known.sort_unstable();
    assert_eq!(there, known, "{folder}");
}

#[test]
fn every_file_is_part_of_the_program() {
    check_embedded("scenes", "toml", scenes().collect());
    check_embedded("instruments", "toml", INSTRUMENTS.names().collect());
    check_embedded("performances", "mid", performances().collect());
}

#[test]
fn the_paper_s_scene_writes_out_the_defaults() {
    let paper = Scene::load(&Library::default(), "paper", &[]).unwrap();
    let default = Render::default();
    assert_eq!(Render { event_tolerance: default.event_tolerance, ..paper.render }, default);
    // The file rounds 2⁻⁴⁰ to two digits.
    assert!((paper.render.event_tolerance / default.event_tolerance - 1.0).abs() < 0.005);
}
