//! `letoff lab soak`: the whole host under faults keeps its promises, and a seed its bits.

use crate::letoff::{Said, check, folder, run};

/// A trial of so many seconds of virtual time, whose every promise is kept.
#[track_caller]
fn tried(folder: &std::path::Path, seconds: &str, seed: &str) -> Said {
    let wanted = ["lab", "soak", "springs", "--duration", seconds, "--seed", seed, "--json"];
    let said = run(folder, &wanted);
    assert_eq!(said.code, Some(0), "{said:?}");
    said
}

#[test]
fn every_promise_is_kept_while_everything_goes_wrong() {
    let said = tried(&folder("soak"), "40", "3");
    let report = said.report();
    let verdicts = report["verdicts"].as_array().expect("verdicts");
    assert_eq!(verdicts.len(), 10);
    assert!(verdicts.iter().all(|it| it["is_kept"] == true), "{verdicts:?}");
    // Nothing is proved by what did not go wrong.
    let injected = &report["injected"];
    for (what, least) in [
        ("lost", 500),
        ("damaged", 100),
        ("late", 100),
        ("silent", 100),
        ("sensors", 10),
        ("voices", 30),
        ("values", 50),
        ("wrong_values", 10),
        ("ports", 2),
    ] {
        assert!(least <= injected[what].as_u64().expect("a count"), "{what}: {injected}");
    }
    assert!(1000 < report["notes"].as_u64().expect("a count"), "{report}");
}

#[test]
fn a_seed_gives_the_same_bits_and_another_one_others() {
    let folder = folder("soak-twice");
    let [once, again, other] = ["5", "5", "6"].map(|seed| tried(&folder, "10", seed).report());
    assert_eq!(once, again);
    assert_ne!(once["digest"], other["digest"]);
}

#[test]
fn a_trial_that_is_too_short_is_refused() {
    let wanted = ["lab", "soak", "--duration", "2"];
    check(&folder("soak-short"), &wanted, 2, &["--duration 2", "10 s or more"]);
}
