//! The command as a whole: its files, its summary, its exit codes.

mod methods;
mod mistakes;
mod plot;
mod reference;

use std::fs;
use std::path::Path;

use clap::Parser as _;
use mechanism::Library;
use serde_json::Value;

use super::{SimulateArgs, SimulateError, run};

const PAPER_MODELS: [&str; 6] = [
    "key-hammer-springs",
    "key-hammer-rigid",
    "reduced-grand",
    "bouncing-ball",
    "cart-pendulum",
    "spring-wall",
];

/// A folder that is deleted after the test.
struct Folder(tempfile::TempDir);

impl Folder {
    fn new(name: &str) -> Self {
        Self(tempfile::TempDir::with_prefix(name).expect("a folder"))
    }

    fn path(&self, name: &str) -> String {
        self.0.path().join(name).to_str().expect("UTF-8").to_owned()
    }

    fn write(&self, name: &str, text: &str) -> String {
        fs::write(self.path(name), text).expect("a file");
        self.path(name)
    }
}

fn args(words: &[&str]) -> SimulateArgs {
    let all = ["simulate"].iter().chain(words);
    SimulateArgs::try_parse_from(all).expect("arguments that clap takes")
}

fn simulate(words: &[&str]) -> Result<String, SimulateError> {
    let mut out = Vec::new();
    run(&args(words), &mut out, &mut |_| ())?;
    Ok(String::from_utf8(out).expect("UTF-8"))
}

#[track_caller]
fn summary(words: &[&str]) -> Value {
    let words: Vec<_> = words.iter().copied().chain(["--json"]).collect();
    serde_json::from_str(&simulate(&words).expect("a run")).expect("JSON")
}

struct Columns {
    names: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Columns {
    fn read(path: &str) -> Self {
        let mut reader = csv::Reader::from_path(path).expect("a table");
        let names = reader.headers().expect("a header").iter().map(String::from).collect();
        let rows =
            reader.records().map(|row| row.expect("a row").iter().map(String::from).collect());
        Self { names, rows: rows.collect() }
    }

    #[track_caller]
    fn text(&self, column: &str) -> Vec<&str> {
        let index = self.names.iter().position(|name| name == column).expect("a column");
        self.rows.iter().map(|row| row[index].as_str()).collect()
    }

    #[track_caller]
    fn numbers(&self, column: &str) -> Vec<f64> {
        self.text(column).iter().map(|text| text.parse().expect("a number")).collect()
    }
}

#[test]
fn the_help_shows_an_example_and_units() {
    let help = SimulateArgs::try_parse_from(["simulate", "--help"]).expect_err("help").to_string();
    for wanted in
        ["letoff simulate key-hammer-springs", "(s)", "Exit codes: 0 done", "[default: rk4]"]
    {
        assert!(help.contains(wanted), "{wanted} is not in\n{help}");
    }
}

#[test]
fn the_trajectory_has_a_row_per_tick_and_a_shorter_last_one() {
    let folder = Folder::new("rows");
    let out = folder.path("traj.csv");
    simulate(&["bouncing-ball", "--until", "0.35", "--step", "0.1", "--out", &out]).expect("a run");
    let table = Columns::read(&out);
    let names = "t mode y v s guard_floor guard_lift F gap readout_per_s readout_per_s_dot \
                 E_supplied E_dissipated E_jumps E_sampling E_integration E_stored";
    assert_eq!(table.names.join(" "), names);
    let step = 0.1;
    assert_eq!(table.numbers("t"), [0.0, step, 2.0 * step, 3.0 * step, 0.35]);
    assert_eq!(table.text("mode"), ["flight"; 5]);
    assert_eq!(table.text("guard_lift"), [""; 5], "lift is a guard of the other mode");
    assert_eq!(table.numbers("guard_floor"), table.numbers("gap"));
    for (t, y) in table.numbers("t").into_iter().zip(table.numbers("y")) {
        assert!((y - (1.0 - 0.5 * 9.81 * t * t)).abs() < 1e-14, "y({t}) = {y}");
    }
}

#[test]
fn preset_parameters_mode_and_initial_state_are_taken() {
    let folder = Folder::new("start");
    let out = folder.path("traj.csv");
    let run = ["bouncing-ball", "--until", "1e-3", "--step", "1e-3", "--out", &out];
    let first = |more: &[&str], column: &str| {
        simulate(&[&run, more].concat()).expect("a run");
        Columns::read(&out).text(column)[0].to_owned()
    };
    assert_eq!(first(&["--set", "y0=2"], "y"), "2.0");
    assert_eq!(first(&["--preset", "key"], "y"), "0.0");
    assert_eq!(first(&["--initial", "v=-3", "y=0.5"], "v"), "-3.0");
    assert_eq!(first(&["--mode", "rest", "--input", "s=0.25+t"], "y"), "0.25");
    assert_eq!(first(&["--mode", "rest", "--set", "mass=2"], "F"), "19.62");
}

/// Asserts that `--initial state=…` is the start of a run of `model`.
#[track_caller]
fn check_initial(model: &str, state: &str, more: &[&str]) {
    let initial = format!("{state}=0.015625");
    let start = |given: &[&str]| {
        let words = [&[model, "--until", "1e-12", "--step", "1e-12"], more, given].concat();
        summary(&words)["final"]["state"][state].as_f64().expect("a state")
    };
    let (rest, given) = (start(&[]), start(&["--initial", &initial]));
    assert!((given - 0.015_625).abs() < 1e-9, "{state} of {model} is {given}, at rest {rest}");
}

#[test]
fn every_state_of_every_model_can_be_given() {
    for name in PAPER_MODELS {
        let model = Library::default().find(name, Path::new("")).expect("a model");
        // A1 has no freedom: all its state is the input's. ACC has one: the hammer is the key's.
        let more: &[&str] = match name {
            "key-hammer-rigid" => &["--mode", "A2"],
            "reduced-grand" => &["--mode", "FLT"],
            _ => &[],
        };
        for state in &model.states {
            check_initial(name, state, more);
        }
    }
}

#[test]
fn the_summary_is_one_json_object() {
    let words = ["bouncing-ball", "--until", "0.5", "--step", "1e-3", "--method", "heun"];
    let json = summary(&words);
    assert_eq!(json["model"], "bouncing-ball");
    assert_eq!(json["method"], "heun");
    assert_eq!(json["outcome"], "completed");
    assert_eq!(json["counts"]["ticks"], 500);
    assert_eq!(json["counts"]["events"], 1);
    assert_eq!(json["counts"]["steps"], 501, "the tick with the impact has two steps");
    assert_eq!(json["counts"]["evaluations"]["derivatives"], 1002);
    assert_eq!(json["final"]["t"], 0.5);
    assert_eq!(json["final"]["mode"], "flight");
    let [y, v] = ["y", "v"].map(|name| json["final"]["state"][name].as_f64().expect("a state"));
    assert!(y > 0.0 && v > 0.0, "{json}");
    let audit = |name: &str| json["energy_audit"][name].as_f64().expect("an energy");
    // At the impact 1 kg loses 1 − 0.8² of its energy from 1 m.
    assert!((audit("jumps") + 0.36 * 9.81).abs() < 1e-9, "{json}");
    assert!(audit("residual").abs() < 1e-9, "{json}");
    assert!(simulate(&words).expect("a run").starts_with("bouncing-ball with heun: completed"));
}

#[test]
fn rounding_of_a_conservative_motion_is_no_error() {
    let words = ["bouncing-ball", "--set", "restitution=1", "--until", "5", "--step", "1e-3"];
    let audit = &summary(&words)["energy_audit"];
    let [error, moved] = ["error", "turned_over"].map(|it| audit[it].as_f64().expect("a number"));
    assert!((moved - 9.81).abs() < 0.1 && error < 1e-12, "{audit}");
    assert!(!simulate(&words).expect("a run").contains("wrong"));
}

#[test]
fn capped_ticks_are_a_failure_that_says_what_to_do_and_leaves_its_files() {
    let folder = Folder::new("capped");
    let out = folder.path("traj.csv");
    let words = ["bouncing-ball", "--set", "restitution=1", "--until", "200", "--step", "100"];
    let words = [&words[..], &["--out", &out, "--json"]].concat();
    let mut printed = Vec::new();
    let error = run(&args(&words), &mut printed, &mut |_| ()).expect_err("capped");
    assert_eq!(error.exit_code(), 1);
    assert_eq!(
        error.to_string(),
        "bouncing-ball reached a maximum in 2 of 2 ticks (2 times 64 events in one tick) and held \
         its state for the rest of each, so what comes after the first of them is not the model's \
         motion: take a shorter --step"
    );
    let json: Value = serde_json::from_slice(&printed).expect("JSON");
    assert_eq!(json["outcome"], "capped: events 2");
    assert_eq!(json["capped_ticks"]["events"], 2);
    assert_eq!(json["final"]["t"], 200.0);
    assert_eq!(fs::read_to_string(&out).expect("the table").lines().count(), 1 + 3);
    let steps = ["--set", "k2=15e6", "--input", "s=0.099*exp(-((t-0.514)/0.079)^2)"];
    let steps = [&["key-hammer-springs"], &steps[..], &["--until", "1", "--step", "1e-2"]].concat();
    let tolerance = ["--method", "by-need", "--tolerance", "1e-12"];
    let error = run(&args(&[&steps[..], &tolerance].concat()), &mut Vec::new(), &mut |_| ());
    let error = error.expect_err("capped").to_string();
    assert!(error.ends_with("take a shorter --step or a larger --tolerance"), "{error}");
}

#[test]
fn energy_that_the_method_makes_is_told_and_none_where_it_makes_none() {
    let told = |step: &str| {
        let words = ["key-hammer-springs", "--input", "s=0.1*sin(2*pi*t)", "--until", "1"];
        let words = [&words[..], &["--step", step, "--method", "heun"]].concat();
        let mut printed = Vec::new();
        run(&args(&words), &mut printed, &mut |_| ()).expect("a run");
        String::from_utf8(printed).expect("text")
    };
    let (long, short) = (told("0.05"), told("1e-4"));
    assert!(long.contains("of the energy that went through: take a shorter --step"), "{long}");
    assert!(!short.contains("the method made"), "{short}");
}

#[test]
fn energy_that_is_not_finite_is_a_fault_and_no_null_in_a_completed_run() {
    let words = ["bouncing-ball", "--until", "1", "--step", "1e-3", "--initial", "v=1e200"];
    let words = [&words[..], &["--json"]].concat();
    let mut printed = Vec::new();
    let error = run(&args(&words), &mut printed, &mut |_| ()).expect_err("no energy");
    assert_eq!(error.exit_code(), 1);
    assert_eq!(
        error.to_string(),
        "bouncing-ball failed after t = 0.001 s in mode flight: the energy is not finite, so that \
         nothing tells whether the motion is right; the last rows of --out show how it came there"
    );
    let json: Value = serde_json::from_slice(&printed).expect("JSON");
    assert_eq!(json["outcome"], "fault: energy");
}

#[test]
fn an_event_says_how_many_impacts_it_stands_for() {
    let folder = Folder::new("impacts");
    let events = folder.path("events.csv");
    let ball = ["bouncing-ball", "--until", "5", "--step", "0.5", "--events", &events];
    let counts = summary(&ball)["counts"].clone();
    let table = Columns::read(&events);
    let (names, numbers) = (table.text("guard"), table.numbers("stands_for"));
    let of = |name: &str| {
        let named = names.iter().zip(&numbers).filter(|(it, _)| **it == name);
        named.map(|(_, number)| *number).collect::<Vec<_>>()
    };
    let floor = of("floor");
    assert_eq!(floor, vec![1.0; floor.len()]);
    assert_eq!(of("settled"), [f64::INFINITY]);
    assert_eq!(counts["settled"], 1);
    let together: f64 = of("impacts").iter().sum();
    assert_eq!(counts["impacts_in_closed_form"], together);
    let text = simulate(&ball).expect("a run");
    assert!(text.contains("1 events stand for all that were left"), "{text}");
}

#[test]
fn where_the_rows_of_the_input_end_is_told_with_the_value_that_holds() {
    let folder = Folder::new("held");
    let input = folder.write("s.csv", "t,s\n0.25,0.1\n0.5,0.2\n");
    let words = ["bouncing-ball", "--step", "1e-2", "--input", &input, "--json", "--until"];
    let told = |until: &str| {
        let (mut printed, mut notes) = (Vec::new(), String::new());
        run(&args(&[&words[..], &[until]].concat()), &mut printed, &mut |note| notes += note)
            .expect("a run");
        let json: Value = serde_json::from_slice(&printed).expect("JSON");
        (json["held_input"].to_string(), notes)
    };
    let (json, note) = told("1");
    let held = r#"[{"from":0.0,"s":0.1,"to":0.25},{"from":0.5,"s":0.2,"to":1.0}]"#;
    assert_eq!(json, held);
    let wanted = "the input has no rows there and is held at s = 0.1 from 0.0 s to 0.25 s and \
                  s = 0.2 from 0.5 s to 1.0 s";
    assert_eq!(note, wanted);
    let whole = folder.write("s.csv", "t,s\n0,0.1\n0.5,0.2\n");
    assert_eq!(whole, input);
    assert_eq!(told("0.5"), ("[]".to_owned(), String::new()));
}

#[test]
fn a_fault_says_where_and_leaves_what_was_produced() {
    let folder = Folder::new("fault");
    let out = folder.path("traj.csv");
    let words = ["bouncing-ball", "--until", "2", "--step", "0.25", "--input", "s=0.1/(1-t)-1"];
    let mut printed = Vec::new();
    let words = [&words[..], &["--out", &out, "--json"]].concat();
    let error = run(&args(&words), &mut printed, &mut |_| ()).expect_err("a fault");
    assert_eq!(error.exit_code(), 1);
    let sentence = error.to_string();
    assert!(sentence.starts_with("bouncing-ball failed after t = "), "{sentence}");
    assert!(
        sentence.ends_with("the input s or a derivative of it is not finite there"),
        "{sentence}"
    );
    assert_eq!(Columns::read(&out).numbers("t"), [0.0, 0.25, 0.5, 0.75]);
    let json: Value = serde_json::from_slice(&printed).expect("JSON also then");
    assert_eq!(json["outcome"], "fault: input");
}

#[test]
fn a_state_that_leaves_the_finite_numbers_is_a_fault() {
    let words = ["key-hammer-springs", "--until", "1", "--step", "1e-3"];
    let error =
        simulate(&[&words[..], &["--initial", "theta_h_dot=1e308", "theta_k_dot=1e308"]].concat())
            .expect_err("a fault");
    assert_eq!(
        error.to_string(),
        "key-hammer-springs failed after t = 0.0 s in mode B1: \
         the state is not finite any more; take a shorter --step"
    );
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_is_one_sentence() {
    for until in ["0.01", "10"] {
        for file in ["--out", "--events", "--plot"] {
            let words = ["bouncing-ball", "--until", until, "--step", "1e-3", file, "/dev/full"];
            let error = simulate(&words).expect_err("a full disk");
            assert_eq!(error.exit_code(), 1);
            assert_eq!(
                error.to_string(),
                "cannot write /dev/full: No space left on device (os error 28); \
                 make room there or choose another file"
            );
        }
    }
}

#[test]
fn the_same_run_gives_the_same_bytes() {
    let folder = Folder::new("bytes");
    let files = ["a", "b"].map(|name| folder.path(name));
    for out in &files {
        let words = ["key-hammer-springs", "--until", "0.2", "--step", "1e-3", "--out", out];
        simulate(&[&words[..], &["--input", "s=0.1*sin(20*t)"]].concat()).expect("a run");
    }
    let [a, b] = files.map(|path| fs::read(path).expect("a file"));
    assert_eq!(a, b);
}
