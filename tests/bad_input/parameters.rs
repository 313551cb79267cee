//! Impossible options and parameters, and parameters that no model survives.

use std::fs;
use std::sync::atomic::AtomicBool;

use host::session::{RunOptions, RunSession};
use scene::Scene;

use crate::letoff::{check, check_words, folder, run};
use crate::stage::scene;

#[track_caller]
fn check_set(set: &str, words: &[&str]) {
    let folder = folder("set");
    let said = check(&folder, &["run", "springs", "--virtual-time", "--set", set], 2, words);
    check_words(&said, &[&format!("--set {set}: ")]);
}

#[test]
fn a_parameter_out_of_its_range_is_refused_with_the_range() {
    check_set("tick_hz=50", &["out of range", "100 to 10000 Hz"]);
    check_set("keys.parameters.restitution=2", &["out of range", "0 to 1"]);
    check_set("keys.parameters.k2=nan", &["k2"]);
    check_set("keys.parameters.k2=1e999", &["k2"]);
}

#[test]
fn a_parameter_that_is_not_there_is_answered_with_the_nearest() {
    check_set("tick_hertz=1000", &["tick_hz"]);
    check_set("keys.parameters.k3=1", &["k2"]);
    check_set("keys.7.instrument=grand-springs", &["keys"]);
}

#[test]
fn a_name_of_8_kb_is_shortened() {
    let set = format!("{}=1", "x".repeat(8000));
    let arguments = ["run", "springs", "--virtual-time", "--set", &set];
    let said = check(&folder("long"), &arguments, 2, &["--set xxx", "x…: there is no key"]);
    assert!(said.err.len() < 500, "{said:?}");
}

#[test]
fn several_wrong_overrides_are_all_reported() {
    let folder = folder("several");
    let sets = ["--set", "tick_hz=0", "--set", "lanes=99", "--set", "nonsense=1"];
    let said = run(&folder, &[&["run", "springs"], &sets[..]].concat());
    assert_eq!((said.code, said.lines().len()), (Some(2), 3), "{said:?}");
    check_words(&said, &["tick_hz=0", "lanes=99", "nonsense=1"]);
}

#[test]
fn a_length_that_is_none_is_refused() {
    for length in ["0", "nan", "inf", "soon"] {
        check_usage(&["run", "--virtual-time", "--duration", length]);
    }
    let said = check_usage(&["run", "--virtual-time", "--duration", "-3"]);
    assert!(said.contains("give a number above 0"), "{said}");
}

#[test]
fn an_option_that_is_not_there_is_refused() {
    check_usage(&["run", "--tempo", "120"]);
    check_usage(&["run", "--set", "tick_hz"]);
    check_usage(&["play"]);
    check_usage(&[]);
}

#[track_caller]
fn check_usage(arguments: &[&str]) -> String {
    let said = run(&folder("usage"), arguments);
    assert_eq!((said.code, said.out.as_str()), (Some(2), ""), "{said:?}");
    assert!(!said.err.is_empty());
    said.err
}

#[test]
fn virtual_time_without_an_end_is_refused() {
    let folder = folder("endless");
    let arguments = ["run", "paper", "--virtual-time"];
    check(&folder, &arguments, 2, &["virtual time needs an end", "--duration"]);
}

/// The lowest key's damping needs arbitrarily short steps; all others are a grand's.
const DIVERGING: &str = r#"
[[keys]]
range = "A0"
model = "key-hammer-springs"
preset = "paper"
parameters = { b1 = 1e9 }

[[keys]]
range = "A#0..C8"
instrument = "grand-springs"

[pianist]
performance = "beethoven-ode-to-joy"
"#;

#[test]
fn a_model_that_diverges_is_refused_before_it_plays() {
    let folder = folder("diverging");
    fs::write(folder.join("diverging.toml"), DIVERGING).expect("a file");
    let words =
        ["A0 with key-hammer-springs fails while it is played", "choose another instrument"];
    check(&folder, &["run", "diverging.toml", "--virtual-time", "--duration", "1"], 2, &words);
}

#[test]
fn a_model_that_diverges_is_counted_and_the_others_play_on() {
    let played = |scene: &Scene| {
        let options = RunOptions { duration: Some(10.0), virtual_time: true };
        let session = RunSession::prepare(scene, options, &|_| {}).expect("a session");
        session.run(&AtomicBool::new(false)).expect("a run")
    };
    let report = played(
        &Scene::from_text(&scene::Library::default(), "diverging", DIVERGING.into())
            .expect("a good scene"),
    );
    let totals = &report.totals;
    assert_eq!((totals.faults, totals.muted.len()), (4, 1), "it keeps failing: {report}");
    // Every note is another key's; the diverging one's strikes do not count.
    let healthy = played(&scene("springs", &[]));
    let [notes, others] = [&report, &healthy].map(|it| it.notes.as_ref().expect("a pianist"));
    assert_eq!((notes.played, notes.missed), (others.played, others.missed));
    assert_eq!(notes.onset_error_ms.max.to_bits(), others.onset_error_ms.max.to_bits());
    assert!(10 < notes.played && report.extent.skipped == 0, "{notes:?}");
}
