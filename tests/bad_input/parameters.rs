//! Options and parameters that cannot be, or that no model survives.

use std::fs;

use crate::letoff::{check, check_words, folder, run};

/// Asserts how an override is refused.
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
    // The sign makes it no option.
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

/// Asserts that the command line is refused; returns why.
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

/// The lowest key's damping is such that no step is short enough; all others are a grand's.
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
fn a_model_that_diverges_is_counted_and_the_others_play_on() {
    let folder = folder("diverging");
    fs::write(folder.join("diverging.toml"), DIVERGING).expect("a file");
    let length = ["--virtual-time", "--duration", "10", "--json"];
    let said = run(&folder, &[&["run", "diverging.toml"], &length[..]].concat());
    assert_eq!(said.code, Some(1), "{said:?}");
    let report = said.report();
    assert!(report["faults"].as_u64() > Some(10), "{report}");
    assert_eq!(report["muted"], serde_json::json!([]), "it never came back: {report}");
    let sentence = format!("letoff: voices failed in {} turns", report["faults"]);
    assert!(said.err.starts_with(&sentence) && said.err.lines().count() == 1, "{said:?}");
    // Every note is another key's; what the diverging one struck, nobody asked for.
    let healthy = run(&folder, &[&["run", "springs"], &length[..]].concat()).report();
    for name in ["played", "missed", "onset_error_ms", "velocity_error"] {
        assert_eq!(report["notes"][name], healthy["notes"][name], "{name}");
    }
    assert!(report["notes"]["played"].as_u64() > Some(10), "{report}");
    assert_eq!(report["skipped"], 0);
}
