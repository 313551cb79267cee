//! The reduced grand's modes: positions and targets of their guards.

use pode::{Guarded as _, Resets as _};

use super::{BUTTON, STRING, TRIP, agree, carried, lever};
use crate::kane::runnable::{GRAND, Runnable, guard, mode, mode_name, modes};
use crate::kane::stroke::still;

#[test]
fn guards_on_the_key_stand_where_the_table_says() {
    let model = GRAND.model::<4>("default", 0, &[]);
    for (mode, name, place, sign) in [
        ("ACC", "button", BUTTON, -1.0),
        ("FLA", "button", BUTTON, -1.0),
        ("LO", "button-off", BUTTON, 1.0),
        ("FLL", "button-off", BUTTON, 1.0),
        ("LO", "trip", TRIP, -1.0),
        ("FLL", "trip", TRIP, -1.0),
        ("STU", "trip", TRIP, -1.0),
        ("FLT", "reset", 0.007, 1.0),
        ("STT", "reset", 0.007, 1.0),
        ("REPL", "reset", 0.007, 1.0),
        ("REP0", "jack-out", 0.007, -1.0),
        ("REPH", "check-far", 0.0085, 1.0),
        ("REPL", "check-near", 0.0085, -1.0),
        ("CHK", "check-off", 0.0078, 1.0),
    ] {
        for y in [0.0, 0.0075, 0.01] {
            let value = guard_value(&model, mode, name, [y, 0.03, 0.1, 0.0]);
            agree(name, value, sign * (y - place), 1e-15);
        }
    }
}

#[test]
fn guards_on_the_head_stand_where_the_table_says() {
    let model = GRAND.model::<4>("default", 0, &[]);
    let at = |mode, y| carried(&model, mode, y).unwrap_or(0.0);
    for y in [0.003, 0.0084, 0.0098] {
        for (mode, name, height, sign) in [
            ("FLA", "land", at("ACC", y), 1.0),
            ("FLL", "land", at("LO", y), 1.0),
            ("FLA", "string-on", STRING, -1.0),
            ("FLT", "string-on", STRING, -1.0),
            ("STU", "string-off", STRING, 1.0),
            ("FLT", "rep-on", lever(&model, y), 1.0),
            ("REPH", "rep-off", lever(&model, y), -1.0),
            ("REP0", "rep-off", lever(&model, y), -1.0),
            ("REPH", "check", at("CHK", y), 1.0),
            ("REP0", "jack-in", at("ACC", y), -1.0),
        ] {
            let value = guard_value(&model, mode, name, [y, 0.03, 0.1, 0.0]);
            agree(name, value, sign * (0.03 - height), 1e-14);
        }
    }
}

#[track_caller]
fn guard_value(model: &Runnable<4>, of: &str, name: &str, x: [f64; 4]) -> f64 {
    let mode = mode(model, of);
    model.guard(mode, guard(model, mode, name), &x, &still(0.0)).value
}

/// Returns the target of the guard `name` in `from`, with the key at `y` and the head at `z`.
#[track_caller]
fn leads(from: &str, name: &str, (y, z): (f64, f64)) -> &'static str {
    let model = GRAND.model::<4>("default", 0, &[]);
    let mode = mode(&model, from);
    let id = guard(&model, mode, name);
    mode_name(&model, model.reset(mode, id, &[y, z, 0.1, 0.1], &still(0.0)).mode)
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
    let model = GRAND.model::<4>("default", 0, &[]);
    let count: usize = modes(&model).map(|(mode, _)| model.guards(mode).len()).sum();
    // One row more for each of the four with a choice.
    assert_eq!(count + 4, 33, "guards without a row in the test above");
}
