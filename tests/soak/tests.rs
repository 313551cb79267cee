//! `cargo xtask soak`: the whole host under faults keeps its promises, and a seed its bits.

#![expect(clippy::expect_used, reason = "helpers of tests fail aloud")]

use std::process::{Command, Output};

fn run(arguments: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_soak"));
    command.args(arguments.split(' ')).output().expect("the program runs")
}

#[track_caller]
fn tried(seconds: u32, seed: u32) -> String {
    let output = run(&format!("springs --duration {seconds} --seed {seed}"));
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn every_promise_is_kept_while_everything_goes_wrong() {
    let report = tried(40, 3);
    assert_eq!(report.matches("\n  kept    ").count(), 10, "{report}");
    // Faults that did not occur prove nothing.
    for (what, least) in [
        (" notes;", 1000),
        (" lost,", 500),
        (" damaged,", 100),
        (" late,", 100),
        (" met a silent line", 100),
        (" sensors said NaN,", 10),
        (" voices got impossible values,", 30),
        (" values were set,", 50),
        (" of them wrong", 10),
        (" times the MIDI port vanished,", 2),
    ] {
        let number = report.split(what).next().and_then(|before| before.rsplit(' ').next());
        let number = number.and_then(|it| it.parse::<u64>().ok());
        assert!(Some(least) <= number, "{number:?}{what} {report}");
    }
}

#[test]
fn a_seed_gives_the_same_bits_and_another_one_others() {
    let [once, again, other] = [5, 5, 6].map(|seed| tried(10, seed));
    assert_eq!(once, again);
    let digest = |report: &str| report.split("digest ").nth(1).map(|it| it[..16].to_owned());
    assert_ne!(digest(&once), digest(&other));
}

#[test]
fn a_trial_that_is_too_short_is_refused() {
    assert_eq!(run("--duration 2").status.code(), Some(2));
}
