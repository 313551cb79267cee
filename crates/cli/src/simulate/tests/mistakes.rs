//! Wrong usage and invalid files: every message, word for word.

use super::{Folder, args, simulate};
use crate::simulate::{SimulateError, run};

const RUN: [&str; 4] = ["--until", "1", "--step", "1e-3"];

/// Asserts that `words` are rejected with exactly these sentences, and write nothing.
#[track_caller]
fn check(words: &[&str], expected: &[&str]) {
    let mut out = Vec::new();
    let error = run(&args(&[words, &RUN].concat()), &mut out, &mut |_| ()).expect_err("a mistake");
    assert_eq!(error.exit_code(), 2);
    assert!(matches!(error, SimulateError::Usage(_)));
    assert_eq!(error.to_string().lines().collect::<Vec<_>>(), expected);
    assert!(out.is_empty());
}

const MODELS: &str = "key-hammer-springs, key-hammer-rigid";

#[test]
fn an_unknown_model_is_refused_with_the_nearest_name() {
    let error = simulate(&[&["key-hammer-spring"], &RUN[..]].concat()).expect_err("a mistake");
    let start = format!(
        "there is no model \"key-hammer-spring\"; use \"key-hammer-springs\", the nearest of {MODELS}"
    );
    assert!(error.to_string().starts_with(&start), "{error}");
    let error = simulate(&[&["my/action.toml"], &RUN[..]].concat()).expect_err("a mistake");
    let missing = "my/action.toml: there is no such file; correct the path";
    assert_eq!(error.to_string(), missing);
}

#[test]
fn all_mistakes_come_at_once() {
    let words = "bouncing-ball --preset defualt --key 88 --set mas=1 g=x restitution=1.5 g=2 g=3 y0 \
         --mode fly --initial z=1 --method rk5 --event-tolerance 0 --input s=2t --reconstruct hold";
    let words: Vec<_> = words.split_whitespace().collect();
    check(
        &words,
        &[
            "--event-tolerance = 0 is out of range: 1e-16 to 0.5 of a tick",
            "there is no method `rk5` (did you mean `rk4`?); there are by-need, explicit-euler, \
             semi-implicit-euler, heun, velocity-verlet, adams-bashforth2, adams-bashforth3, \
             bogacki-shampine, rk4, tsitouras5, dop853, linear-implicit-midpoint, rodas3, exact, \
              newmark",
            "--input, column 3: the input is in kg; write numbers without units, in SI",
            "--reconstruct is for an --input from a CSV file",
            "--key = 88 is out of range: 0 to 87 (A0 to C8)",
            "there is no preset `defualt` (did you mean `default`?); there are default, key",
            "there is no parameter `mas` (did you mean `mass`?); there are g, restitution, mass, \
             y0, scale",
            "`--set g=x`: `x` is not a finite number",
            "`--set g` is given twice",
            "`--set y0` must be NAME=VALUE",
            "parameter `restitution` = 1.5 is out of range: 0 to 1",
            "there is no state `z`; there are y, v",
            "there is no mode `fly`; there are flight, rest",
        ],
    );
}

#[test]
fn times_must_be_lengths_of_time() {
    let check = |until: &str, step: &str, expected: &[&str]| {
        let error = simulate(&["bouncing-ball", "--until", until, "--step", step]);
        let error = error.expect_err("a mistake");
        assert_eq!(error.to_string().lines().collect::<Vec<_>>(), expected);
    };
    check(
        "-1",
        "0",
        &[
            "--until = -1.0: it must be a positive, finite number of seconds",
            "--step = 0.0: it must be a positive, finite number of seconds",
        ],
    );
    check("1", "nan", &["--step = NaN: it must be a positive, finite number of seconds"]);
    check("1", "1e-12", &["--until / --step are 1e12 ticks, more than 1e11: take a longer --step"]);
}

#[test]
fn expressions_that_cannot_be_read_are_refused() {
    let check =
        |input: &str, expected: &str| check(&["bouncing-ball", "--input", input], &[expected]);
    check("x=t", "--input x=…: the model's input is called `s`");
    let functions = mechanism::formulas::FUNCTIONS.join(", ");
    check(
        "s = 0.1 * sni(t)",
        &format!(
            "--input, column 11: there is no function \"sni\"; use \"sin\", the nearest of {functions}"
        ),
    );
    let names = "the variable is t, and there are pi, e, tau and functions as sin(t)";
    check("s=2*x", &format!("--input, column 5: there is no \"x\"; {names}"));
    let missing = "stands where a value should; write a number, a name or a function";
    check("s=2**t", &format!("--input, column 5: \"*\" {missing}"));
    check(
        "s=x(P)",
        "--input, column 5: an input has no points and no forces; write a function of t",
    );
    check("s=1/t", "--input: s or one of its first three derivatives is not finite at t = 0");
    check("s=sqrt(t)", "--input: s or one of its first three derivatives is not finite at t = 0");
    check("s=floor(t)", "--input, column 9: floor is of numbers only; write a number");
}

#[test]
fn tables_are_refused_with_line_and_column() {
    let folder = Folder::new("tables");
    let check = |text: &str, expected: &[&str]| {
        let path = folder.write("in.csv", text);
        let expected: Vec<_> = expected.iter().map(|text| format!("{path}{text}")).collect();
        let expected: Vec<_> = expected.iter().map(String::as_str).collect();
        check(&["bouncing-ball", "--input", &path], &expected);
    };
    check("t,s\n0,0\n", &[" has 1 rows: an input needs at least 2"]);
    check("", &[" has 0 rows: an input needs at least 2"]);
    check(
        "time,s\n0,0\n1,x\n1,2,3\n0.5,1\n2\n3,inf\n4,1\n",
        &[
            ", line 1, column 1: the header must be t,s: expected `t`, not `time`",
            ", line 3, column 2: s = `x` is not a finite number",
            ", line 4, column 3: 3 columns: a row is t,s",
            ", line 5, column 1: t = 0.5 is not after 1.0: times must increase",
            ", line 6, column 2: s is missing",
            ", line 7, column 2: s = `inf` is not a finite number",
        ],
    );
    let many = format!("t,s\n{}", "x,0\n".repeat(12));
    let path = folder.write("in.csv", &many);
    let error = simulate(&[&["bouncing-ball", "--input", &path], &RUN[..]].concat());
    let error = error.expect_err("mistakes").to_string();
    assert_eq!(error.lines().count(), 11);
    assert!(error.ends_with("in.csv: 2 more mistakes"), "{error}");
}

#[test]
fn files_that_cannot_be_opened_are_refused() {
    let folder = Folder::new("files");
    let missing = folder.path("missing.csv");
    check(
        &["bouncing-ball", "--input", &missing],
        &[&format!("cannot read {missing}: No such file or directory (os error 2)")],
    );
    let [out, events, plot] =
        ["traj.csv", "events.csv", "plot.svg"].map(|name| folder.path(&format!("no/{name}")));
    check(
        &["bouncing-ball", "--out", &out, "--events", &events, "--plot", &plot],
        &[
            &format!("cannot create {out}: No such file or directory (os error 2)"),
            &format!("cannot create {events}: No such file or directory (os error 2)"),
            &format!("cannot create {plot}: No such file or directory (os error 2)"),
        ],
    );
}

#[test]
fn an_input_is_never_overwritten() {
    let folder = Folder::new("same");
    let path = folder.write("in.csv", "t,s\n0,0\n1,0\n");
    let again = folder.path("./in.csv");
    check(
        &["bouncing-ball", "--input", &path, "--out", &again],
        &[&format!("--input and --out are the same file, {again}")],
    );
    let new = folder.path("new.csv");
    check(
        &["bouncing-ball", "--out", &new, "--events", &new],
        &[&format!("--out and --events are the same file, {new}")],
    );
    check(
        &["bouncing-ball", "--out", &new, "--plot", &new],
        &[&format!("--out and --plot are the same file, {new}")],
    );
    assert!(!std::path::Path::new(&new).exists(), "nothing is created on a mistake");
}

#[test]
fn parameters_that_do_not_go_together_as_they_say_are_refused() {
    let unmet = "cart-pendulum needs right > left, which does not hold: choose other parameters";
    check(&["cart-pendulum", "--set", "right=-0.1"], &[unmet]);
}
