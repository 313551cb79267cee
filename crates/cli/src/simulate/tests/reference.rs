//! Compares the command's files with trajectories of an independent program.

use std::fmt::Write as _;
use std::fs;

use serde_json::Value;

use super::{Columns, Folder, simulate};

const REFERENCE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../instruments/tests/reference");

fn number(value: &Value) -> f64 {
    value
        .as_str()
        .map_or_else(|| value.as_f64().expect("a number"), |text| text.parse().expect("a number"))
}

fn text<'a>(event: &'a Value, key: &str) -> &'a str {
    event[key].as_str().expect("a name")
}

struct Case {
    json: Value,
    words: Vec<String>,
    table: Columns,
}

impl Case {
    fn load(name: &str) -> Self {
        let text = fs::read_to_string(format!("{REFERENCE}/{name}.json")).expect("the case");
        let json: Value = serde_json::from_str(&text).expect("JSON");
        let mut words =
            vec![json["model"].as_str().expect("a name").to_owned(), "--set".to_owned()];
        for (name, value) in json["parameters"].as_object().expect("parameters") {
            words.push(format!("{name}={:?}", number(value)));
        }
        words.extend(["--until".to_owned(), number(&json["t_end"]).to_string()]);
        let table = Columns::read(&format!("{REFERENCE}/{name}.csv"));
        Self { json, words, table }
    }

    fn bells(&self) -> Vec<[f64; 3]> {
        let bells = self.json["input"]["A_tc_w"].as_array().expect("an input");
        bells.iter().map(|bell| [0, 1, 2].map(|i| number(&bell[i]))).collect()
    }

    fn expression(&self) -> String {
        let mut text = "s=0".to_owned();
        for [a, tc, w] in self.bells() {
            write!(text, "+{a:?}*exp(-((t-{tc:?})/{w:?})^2)").expect("a String");
        }
        text
    }

    /// Returns events as (guard, from, to).
    fn sequence(&self) -> Vec<[&str; 3]> {
        let events = self.json["events"].as_array().expect("events");
        let name = |event| ["guard", "from", "to"].map(|key| text(event, key));
        events.iter().map(name).collect()
    }

    /// Runs the command with ticks of `step`; returns trajectory and events.
    fn run(&self, folder: &Folder, step: &str, more: &[&str]) -> (Columns, Columns) {
        let (out, events) = (folder.path("traj.csv"), folder.path("events.csv"));
        let mut words: Vec<_> = self.words.iter().map(String::as_str).collect();
        words.extend(["--step", step, "--out", &out, "--events", &events]);
        words.extend(more);
        simulate(&words).expect("a run");
        (Columns::read(&out), Columns::read(&events))
    }

    /// Asserts the sequence of `events`; returns the largest error of their times (s).
    #[track_caller]
    fn event_error(&self, events: &Columns) -> f64 {
        let columns = ["guard", "from", "to"].map(|name| events.text(name));
        let seen: Vec<_> =
            (0..events.rows.len()).map(|i| columns.each_ref().map(|column| column[i])).collect();
        assert_eq!(seen, self.sequence());
        let expected = self.json["events"].as_array().expect("events");
        let errors = events.numbers("t").into_iter().zip(expected);
        errors.map(|(t, event)| (t - number(&event["t"])).abs()).fold(0.0, f64::max)
    }

    fn state_error(&self, events: &Columns) -> f64 {
        let expected = self.json["events"].as_array().expect("events");
        let error = |(column, when, name): (String, &str, &str)| {
            let pairs = events.numbers(&column).into_iter().zip(expected);
            pairs.map(|(got, event)| (got - number(&event[when][name])).abs()).fold(0.0, f64::max)
        };
        let names = expected[0]["before"].as_object().expect("a state").keys();
        let columns = names.flat_map(|name| {
            ["before", "after"].map(|when| (format!("{name}_{when}"), when, name.as_str()))
        });
        columns.map(error).fold(0.0, f64::max)
    }
}

/// Asserts event times of RK4: order 4, so 1e-9 s at 1e-4 s is 1e-5 s at 1e-3 s.
#[track_caller]
fn check_case(name: &str) {
    let folder = Folder::new(name);
    let case = Case::load(name);
    let input = case.expression();
    let coarse = case.event_error(&case.run(&folder, "1e-3", &["--input", &input]).1);
    let (trajectory, events) = case.run(&folder, "1e-4", &["--input", &input]);
    let fine = case.event_error(&events);
    assert!(coarse < 1e-5, "event times at 1e-3 are off by {coarse:e} s");
    assert!(fine < 1e-9, "event times at 1e-4 are off by {fine:e} s");
    let states = case.state_error(&events);
    assert!(states < 1e-7, "states at events are off by {states:e}");
    // The reference has a row every 0.01 s: modes are equal, and every column is here.
    let modes = trajectory.text("mode");
    for (row, mode) in case.table.text("mode").into_iter().enumerate() {
        assert_eq!(modes[row * 100], mode, "mode in row {row} of the reference");
    }
    for column in case.table.names.iter().filter(|name| *name != "mode") {
        let ours = trajectory.numbers(column);
        for (row, expected) in case.table.numbers(column).into_iter().enumerate() {
            let error = (ours[row * 100] - expected).abs();
            assert!(
                error < 1e-6 * expected.abs().max(1.0),
                "{column} in row {row}: off by {error:e}"
            );
        }
    }
}

#[test]
fn figure_6_comes_out_of_the_command() {
    check_case("model-b-figure6");
}

#[test]
fn the_columns_of_model_b_are_these() {
    let folder = Folder::new("columns");
    let case = Case::load("model-b-figure6");
    let (trajectory, events) = case.run(&folder, "1e-2", &["--input", &case.expression()]);
    assert_eq!(
        trajectory.names.join(","),
        "t,mode,theta_h,theta_k,theta_h_dot,theta_k_dot,s,guard_release,guard_string,guard_land,\
         F_KH,T_KU,gap,q4,q3,readout_per_s,readout_per_s_dot,\
         E_supplied,E_dissipated,E_jumps,E_sampling,E_integration,E_stored"
    );
    assert_eq!(
        events.names.join(","),
        "t,guard,from,to,theta_h_before,theta_k_before,theta_h_dot_before,theta_k_dot_before,\
         theta_h_after,theta_k_after,theta_h_dot_after,theta_k_dot_after,\
         impulse,error,projection,stands_for"
    );
    for (mode, release) in trajectory.text("mode").into_iter().zip(trajectory.text("guard_release"))
    {
        assert_eq!(release.is_empty(), mode == "B2", "release is a guard of B1 only");
    }
}

/// The stroke sampled at 1 kHz, by each reconstruction: event times have its order.
#[test]
fn a_sampled_stroke_is_as_good_as_its_reconstruction() {
    let folder = Folder::new("sampled");
    let case = Case::load("model-b-figure6");
    let mut csv = "t,s\n".to_owned();
    for i in 0..=3000 {
        let t = f64::from(i) * 1e-3;
        let bell = |[a, tc, w]: [f64; 3]| a * (-((t - tc) / w).powi(2)).exp();
        let s: f64 = case.bells().into_iter().map(bell).sum();
        writeln!(csv, "{t:?},{s:?}").expect("a String");
    }
    let path = folder.write("stroke.csv", &csv);
    let error = |how: &str| {
        let more = ["--input", &path, "--reconstruct", how];
        case.event_error(&case.run(&folder, "1e-4", &more).1)
    };
    let [hold, linear, quadratic, hermite, spline] =
        ["hold", "linear", "quadratic", "hermite", "spline"].map(error);
    // A held input is half a sample late.
    assert!((hold - 5e-4).abs() < 1e-4, "hold: {hold:e}");
    // The others miss s by some 100 rad/s^n per order n, at speeds of some rad/s.
    assert!(linear < 3e-5, "linear: {linear:e}");
    assert!(quadratic < 1e-6 && hermite < 1e-7, "{quadratic:e} {hermite:e}");
    assert!(spline < 1e-9, "spline: {spline:e}");
}
