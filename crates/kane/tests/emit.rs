//! Emitted Rust: it is what is committed, as rustfmt leaves it, and gives the tape's bits.

use std::io::Write as _;
use std::process::{Command, Stdio};

use equations::table::{Arguments, Functions as _};
use kane::emit;
use kane::tape;

use crate::common::{example, lever};
use crate::emitted;

const PATH: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/emitted/example.rs");

fn text() -> String {
    emit::rust(&example::TABLE, &lever::functions(), "lever-with-hammer.toml")
}

/// `EMIT=1 cargo test -p kane` writes the file anew.
#[test]
fn the_committed_file_is_what_is_emitted() {
    let text = text();
    if std::env::var_os("EMIT").is_some() {
        std::fs::write(PATH, &text).unwrap();
    }
    let committed = std::fs::read_to_string(PATH).unwrap_or_default();
    assert!(committed == text, "tests/emitted/example.rs is not what is emitted today");
}

#[test]
fn rustfmt_changes_nothing() {
    let mut rustfmt = Command::new("rustfmt")
        .args(["--edition", "2024", "--config", "max_width=100,use_small_heuristics=Max"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let text = text();
    rustfmt.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
    let output = rustfmt.wait_with_output().unwrap();
    assert!(output.status.success());
    let formatted = String::from_utf8(output.stdout).unwrap();
    for (at, (emitted, formatted)) in text.lines().zip(formatted.lines()).enumerate() {
        assert_eq!(emitted, formatted, "line {}", at + 1);
    }
    assert_eq!(text.len(), formatted.len());
}

#[test]
fn the_committed_table_is_the_table() {
    assert_eq!(emitted::TABLE, example::TABLE);
}

#[test]
fn emitted_functions_give_the_tape_s_bits() {
    let constants = [0.4, 0.2, 0.03, 0.01, 6.2, 4e3, 1.0, 2.0];
    for n in 0..2000_u32 {
        let n = f64::from(n);
        let state = [(0.37 * n).sin(), (0.73 * n).sin() * 0.9, (0.11 * n).sin() * 8.0, 3.0];
        let input = [(0.21 * n).sin(), 0.7, -2.0, 1.0];
        let given = Arguments { constants: &constants, state: &state, input: &input, extra: &[n] };
        for (number, tape) in (0..).zip(lever::functions()) {
            let expected = tape.evaluate(&tape::TapeArguments {
                constants: &constants,
                state: &state,
                input,
                extra: &[n],
            });
            let mut out = vec![0.0; expected.len()];
            emitted::LeverWithHammerFunctions.call(number, &given, &mut out);
            let bits = |all: &[f64]| all.iter().map(|it| it.to_bits()).collect::<Vec<_>>();
            assert_eq!(bits(&out), bits(&expected), "function {number}");
        }
    }
}

#[test]
fn short_arguments_give_no_number() {
    let given = Arguments { constants: &[1.0], state: &[], input: &[0.0; 4], extra: &[] };
    let mut out = [0.0; 4];
    emitted::LeverWithHammerFunctions.call(1, &given, &mut out);
    assert!(out.iter().all(|it| it.is_nan()));
    let mut kept = [7.0; 4];
    emitted::LeverWithHammerFunctions.call(999, &given, &mut kept);
    assert_eq!(kept.map(f64::to_bits), [7.0_f64; 4].map(f64::to_bits));
}
