use std::{path::Path, sync::Arc};

use std::f64::consts::TAU;

use instruments::{LoadedModel, ModelEntry};
use mechanism::Library;

use super::data::StrokeRow;
use super::driven::DrivenStroke;
use super::{FitOutcome, FitSubject, FittedParameter, MeasuredStroke, fit, read_stroke};
use crate::random::SeededRandom;

const KEY: u8 = 39;

fn model(name: &str, preset: &str) -> (Arc<LoadedModel>, Vec<f64>) {
    let model = Library::default().find(name, Path::new("")).expect("a model");
    let preset = model.presets.iter().find(|it| it.name == preset).expect("a preset");
    let values = preset.values(KEY);
    (model, values)
}

fn place(model: &ModelEntry, name: &str) -> usize {
    model.parameters.iter().position(|it| it.name == name).expect("a parameter")
}

/// Strokes of a key with `changed` parameters: `count` of `depth` (m) and back in 0.4 s, a row each
/// 2 ms, and the same 1.5 times slower.
fn played(
    (model, values): (&LoadedModel, &[f64]),
    changed: &[(&str, f64)],
    depth: f64,
) -> Vec<MeasuredStroke> {
    let mut truth = values.to_vec();
    for (name, value) in changed {
        truth[place(model, name)] = *value;
    }
    let stroke = |duration: f64| {
        let row = |t: f64| StrokeRow {
            t,
            travel: depth * (0.5 * TAU * t / duration).sin().powi(4),
            force: 0.0,
        };
        let rows = (0..=200).map(|it| row(f64::from(it) / 200.0 * duration)).collect();
        let mut stroke = MeasuredStroke { name: "played".to_owned(), is_static: false, rows };
        let driven = DrivenStroke::new(&stroke, Some(0.01));
        let forces = driven.follow(model, &truth).expect("a stroke that it follows");
        stroke.rows.iter_mut().zip(forces).for_each(|(row, force)| row.force = force);
        stroke
    };
    vec![stroke(0.4), stroke(0.6)]
}

fn measured(
    strokes: &[MeasuredStroke],
    seed: u64,
    (force, travel): (f64, f64),
) -> Vec<MeasuredStroke> {
    let mut noise = SeededRandom::new(seed, 0);
    let mut strokes = strokes.to_vec();
    for row in strokes.iter_mut().flat_map(|it| &mut it.rows) {
        row.force += force * noise.gaussian();
        row.travel += travel * noise.gaussian();
    }
    strokes
}

fn fitted(
    (model, values): (&LoadedModel, &[f64]),
    names: &[&str],
    strokes: &[MeasuredStroke],
) -> FitOutcome {
    let fitted: Vec<_> = names.iter().map(|name| place(model, name)).collect();
    let subject =
        FitSubject { name: "test", model, values, fitted: &fitted, strokes, force_noise: None };
    fit(&subject, &|| ()).expect("a fit")
}

fn covers(it: &FittedParameter, truth: f64) -> bool {
    it.interval.is_some_and(|(low, high)| (low..=high).contains(&truth))
}

#[test]
fn intervals_hold_the_truth_as_often_as_they_say() {
    let (model, values) = model("key-hammer-springs", "playable");
    let truth = [("M2", 0.0100), ("JK", 2.3e-3), ("cK", -0.010)];
    let names = truth.map(|it| it.0);
    let strokes = played((&model, &values), &truth, 8e-3);
    let (mut held, mut all) = (0, 0);
    for seed in 0..6 {
        let found = fitted((&model, &values), &names, &measured(&strokes, seed, (0.01, 1e-6)));
        held += found.parameters.iter().zip(truth).filter(|(it, of)| covers(it, of.1)).count();
        all += truth.len();
        assert!(found.strokes.iter().all(|it| it.after < 0.013), "{:?}", found.strokes);
    }
    // Of 18 with 95 % each, 14 or fewer hold once in 90 trials.
    assert!(held > 14, "{held} of {all} intervals hold the truth");
}

#[test]
fn what_has_no_influence_or_a_double_is_named_and_keeps_its_value() {
    let (model, values) = model("key-hammer-springs", "playable");
    let strokes = played((&model, &values), &[("M2", 0.0100)], 8e-3);
    // The string is not reached, and mass times distance is one moment for any mass.
    let names = ["string_angle", "M2", "M1", "cK"];
    let found = fitted((&model, &values), &names, &measured(&strokes, 1, (0.01, 0.0)));
    let told = found.remarks.join("\n");
    assert!(told.contains("string (string_angle) has no influence on these strokes"), "{told}");
    assert!(
        told.contains("do not tell key mass (M1) from key balance (cK)")
            || told.contains("do not tell key balance (cK) from key mass (M1)"),
        "{told}"
    );
    let left: Vec<_> = found.parameters.iter().filter(|it| it.interval.is_none()).collect();
    assert_eq!(left.len(), 2, "{told}");
    assert!(left.iter().all(|it| it.value.to_bits() == it.before.to_bits()), "{left:?}");
    assert!(found.parameters.iter().any(|it| it.name == "M2" && covers(it, 0.0100)), "{found:?}");
}

#[test]
fn published_touch_weights_are_followed_and_their_friction_found() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/fit/published.csv");
    let mut stroke = read_stroke(path.as_ref(), 5e-3).expect("a stroke");
    stroke.rows.retain(|row| (0.8e-3..4.8e-3).contains(&row.travel));
    let (model, values) = model("reduced-grand", "default");
    let found = fitted((&model, &values), &["Wk", "Fc"], &[stroke]);
    // Weights of 50 and 26 gf are constants, in the data and in the model.
    assert!(found.strokes[0].after < 0.02, "{:?}", found.strokes);
    let friction = &found.parameters[1];
    assert!((friction.value - 0.118).abs() < 0.02, "{friction:?}");
}

#[track_caller]
fn check_mistakes(name: &str, text: &str, expected: &[&str]) {
    let path = std::env::temp_dir().join(format!("letoff-fit-{}-{name}.csv", std::process::id()));
    std::fs::write(&path, text).expect("a file");
    let wrong = read_stroke(&path, 5e-3);
    std::fs::remove_file(&path).expect("the file");
    let wrong: Vec<_> = wrong.expect_err("mistakes").iter().map(ToString::to_string).collect();
    assert_eq!(wrong.len(), expected.len(), "{wrong:#?}");
    for (said, expected) in wrong.iter().zip(expected) {
        assert!(said.contains(expected), "no {expected:?} in {said:?}");
    }
}

#[test]
fn bad_data_is_told_with_its_line_and_what_to_do() {
    let rows = |row: &dyn Fn(u32) -> String| (0..20).map(row).collect::<String>();
    let header = "time_s,travel_m,force_n\n";
    check_mistakes("empty", "", &["0 rows are no stroke; give 5 or more"]);
    check_mistakes(
        "columns",
        "time_s,travel_mm,force_n\n0,1,2\n",
        &[
            "line 1: there is no column \"travel_mm\": use \"travel_m\"",
            "the column travel_m is missing",
        ],
    );
    let cells = format!("{header}0,0,\n0.1,NaN,1\n0.2,1e-3,1,7\n0.1,1e-3,1\n0.05,x,1\n");
    check_mistakes(
        "cells",
        &cells,
        &[
            "line 2: force_n is empty",
            "line 3: travel_m = \"NaN\" is not a finite number",
            "line 4: 4 cells for 3 columns",
            "line 6: travel_m = \"x\"",
        ],
    );
    let back = format!("{header}0,0,0\n0.1,1e-3,1\n0.05,2e-3,1\n");
    check_mistakes("back", &back, &["line 4: time_s = 0.05 is not after 0.1"]);
    let gap = rows(&|it| format!("{},{},0.5\n", f64::from(it + 40 * (it / 10)) * 0.01, 1e-3));
    check_mistakes("gap", &format!("{header}{gap}"), &["line 12: 0.4100 s after the row before"]);
    let up = rows(&|it| format!("{},{},0.5\n", f64::from(it) * 0.01, f64::from(it) * -0.521e-3));
    check_mistakes(
        "up",
        &format!("{header}{up}"),
        &["travel_m goes down to -9.9 mm: down is positive"],
    );
    let mm = rows(&|it| format!("{},{},0.5\n", f64::from(it) * 0.01, f64::from(it) * 0.5));
    check_mistakes("mm", &format!("{header}{mm}"), &["it is in metres"]);
    let pulls = rows(&|it| format!("{},{},-0.5\n", f64::from(it) * 0.01, f64::from(it) * 5e-4));
    check_mistakes("pulls", &format!("{header}{pulls}"), &["force on the finger is positive up"]);
    let ways = "travel_m,force_n\n0,0\n2e-3,1\n1e-3,1\n3e-3,1\n4e-3,1\n8e-3,1\n";
    check_mistakes("ways", ways, &["line 4: without time_s", "line 7: 4.0 mm from the row before"]);
}
