//! The reduced grand's modes: where their guards stand, and where they lead.
#![expect(clippy::expect_used, reason = "a test fails aloud")]

use hand_written::ReducedGrand;
use hand_written::reduced_grand::Mode;
use models::{Described as _, Playable as _};
use pode::{GuardId, Guarded as _, Resets as _};

use crate::grand::{BUTTON, STRING, TRIP, agree, carried, lever};
use crate::stroke::{preset, still};

#[test]
fn guards_on_the_key_stand_where_the_table_says() {
    let model: ReducedGrand = preset("default", 0, &[]);
    for (mode, name, place, sign) in [
        (Mode::Acc, "button", BUTTON, -1.0),
        (Mode::Fla, "button", BUTTON, -1.0),
        (Mode::Lo, "button-off", BUTTON, 1.0),
        (Mode::Fll, "button-off", BUTTON, 1.0),
        (Mode::Lo, "trip", TRIP, -1.0),
        (Mode::Fll, "trip", TRIP, -1.0),
        (Mode::Stu, "trip", TRIP, -1.0),
        (Mode::Flt, "reset", 0.007, 1.0),
        (Mode::Stt, "reset", 0.007, 1.0),
        (Mode::RepL, "reset", 0.007, 1.0),
        (Mode::Rep0, "jack-out", 0.007, -1.0),
        (Mode::RepH, "check-far", 0.0085, 1.0),
        (Mode::RepL, "check-near", 0.0085, -1.0),
        (Mode::Chk, "check-off", 0.0078, 1.0),
    ] {
        for y in [0.0, 0.0075, 0.01] {
            let value = guard_value(&model, mode, name, [y, 0.03, 0.1, 0.0]);
            agree(name, value, sign * (y - place), 1e-15);
        }
    }
}

#[test]
fn guards_on_the_head_stand_where_the_table_says() {
    let model: ReducedGrand = preset("default", 0, &[]);
    let p = model.values();
    let at = |mode, y| carried(p, mode, y).unwrap_or(0.0);
    for y in [0.003, 0.0084, 0.0098] {
        for (mode, name, height, sign) in [
            (Mode::Fla, "land", at(Mode::Acc, y), 1.0),
            (Mode::Fll, "land", at(Mode::Lo, y), 1.0),
            (Mode::Fla, "string-on", STRING, -1.0),
            (Mode::Flt, "string-on", STRING, -1.0),
            (Mode::Stu, "string-off", STRING, 1.0),
            (Mode::Flt, "rep-on", lever(p, y), 1.0),
            (Mode::RepH, "rep-off", lever(p, y), -1.0),
            (Mode::Rep0, "rep-off", lever(p, y), -1.0),
            (Mode::RepH, "check", at(Mode::Chk, y), 1.0),
            (Mode::Rep0, "jack-in", at(Mode::Acc, y), -1.0),
        ] {
            let value = guard_value(&model, mode, name, [y, 0.03, 0.1, 0.0]);
            agree(name, value, sign * (0.03 - height), 1e-14);
        }
    }
}

/// The guard called `name` of `mode` at `x`.
#[track_caller]
fn guard_value(model: &ReducedGrand, mode: Mode, name: &str, x: [f64; 4]) -> f64 {
    let found = model.guards(mode).iter().find(|it| it.name == name);
    let guard = found.expect(name);
    model.guard(mode, guard.id, &x, &still(0.0)).value
}

/// Where the guard called `name` leads from `from`, with the key at `y` and the head at `z`.
#[track_caller]
fn leads(from: &str, name: &str, (y, z): (f64, f64)) -> &'static str {
    let model: ReducedGrand = preset("default", 0, &[]);
    let mode = model.modes().find(|it| it.1 == from).map(|it| it.0);
    let mode = mode.expect(from);
    let guard = model.guards(mode).iter().find(|it| it.name == name);
    let guard = guard.expect(name);
    let next = model.reset(mode, guard.id, &[y, z, 0.1, 0.1], &still(0.0)).mode;
    model.modes().find(|it| it.0 == next).map_or("", |it| it.1)
}

#[test]
fn every_guard_leads_where_the_table_says() {
    let (up, down) = ((0.005, 0.03), (0.0095, 0.03));
    for (from, guard, place, to) in [
        ("ACC", "lift-off", up, "FLA"),
        ("ACC", "button", up, "LO"),
        ("LO", "lift-off", up, "FLL"),
        ("LO", "button-off", up, "ACC"),
        ("LO", "trip", up, "FLT"),
        ("FLA", "land", up, "ACC"),
        ("FLA", "button", up, "FLL"),
        ("FLA", "string-on", up, "STU"),
        ("FLL", "land", down, "LO"),
        ("FLL", "button-off", up, "FLA"),
        ("FLL", "trip", up, "FLT"),
        ("FLL", "string-on", up, "STU"),
        ("FLT", "string-on", up, "STT"),
        ("FLT", "rep-on", down, "REPH"),
        ("FLT", "rep-on", up, "REPL"),
        ("FLT", "reset", (0.007, 0.036), "FLA"),
        ("FLT", "reset", (0.007, 0.034), "REP0"),
        ("STU", "string-off", up, "FLA"),
        ("STU", "string-off", down, "FLL"),
        ("STU", "trip", up, "STT"),
        ("STT", "string-off", up, "FLT"),
        ("STT", "reset", up, "STU"),
        ("REPH", "rep-off", down, "FLT"),
        ("REPH", "check", down, "CHK"),
        ("REPH", "check-far", down, "REPL"),
        ("REPL", "rep-off", up, "FLT"),
        ("REPL", "check-near", up, "REPH"),
        ("REPL", "reset", (0.007, 0.036), "FLA"),
        ("REPL", "reset", (0.007, 0.034), "REP0"),
        ("REP0", "rep-off", up, "FLA"),
        ("REP0", "jack-in", up, "FLA"),
        ("REP0", "jack-out", up, "REPL"),
        ("CHK", "check-off", up, "REPL"),
    ] {
        assert_eq!(leads(from, guard, place), to, "{guard} of {from}");
    }
}

#[test]
fn the_table_has_every_guard_of_every_mode() {
    let model: ReducedGrand = preset("default", 0, &[]);
    let count: usize = model.modes().map(|it| model.guards(it.0).len()).sum();
    // One row more for each of the four that have a choice.
    assert_eq!(count + 4, 33, "guards without a row in the test above");
}

#[test]
fn only_the_string_sounds() {
    let model: ReducedGrand = preset("default", 0, &[]);
    let speed = |id| model.sounding(GuardId(id), &[0.0, 0.0, 0.1, 2.5]).map(|it| it.speed);
    let heard: Vec<_> = (0..16).filter_map(|id| speed(id).map(|it| (id, it))).collect();
    assert_eq!(heard, [(5, 2.5)]);
}
