//! Mechanisms compared with SymPy's `KanesMethod`, and motions with `MuJoCo`.
//!
//! `cargo xtask oracle` installs both and compares all, `cargo xtask test` a part. Without a Python
//! that has them the tests compare nothing and report that they were skipped.

mod built_in;
mod linkages;
mod planar;

use std::ffi::OsString;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

/// Python with the packages of requirements.txt.
const PYTHON: &str = "LETOFF_ORACLE_PYTHON";

const COUNT: &str = "LETOFF_ORACLE_MECHANISMS";

const ALL: u64 = 20;

/// Returns the Python; without one, reports that nothing is compared.
fn python() -> Option<OsString> {
    let python = std::env::var_os(PYTHON);
    if python.is_none() {
        println!(
            "skipped: no Python with SymPy and MuJoCo ({PYTHON}); `cargo xtask oracle` installs them"
        );
    }
    python
}

fn compare(python: OsString, program: &str, cases: &[Value]) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("oracle");
    std::fs::create_dir_all(&folder).expect("a folder");
    let file = folder.join(program).with_extension("json");
    let text = serde_json::to_string_pretty(cases).expect("JSON");
    std::fs::write(&file, text).expect("written");
    let program = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/kane/oracle").join(program);
    let output = Command::new(python).arg(program).arg(&file).output().expect("Python");
    println!("{}", String::from_utf8_lossy(&output.stdout));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn accelerations_are_those_of_kanes_method_in_sympy() {
    let Some(python) = python() else { return };
    let count = std::env::var(COUNT).ok().and_then(|it| it.parse().ok()).unwrap_or(ALL);
    let mechanisms: Vec<_> = (0..count).map(planar::random).collect();
    compare(python, "kanes_method.py", &mechanisms);
}

#[test]
fn built_in_models_are_those_of_kanes_method_in_sympy() {
    let cases = built_in::cases();
    assert_eq!(cases.len(), 2 * (2 + 2 + 3 + 2 + 11), "modes of the models, in two presets");
    let Some(python) = python() else { return };
    compare(python, "built_in.py", &cases);
}

#[test]
fn free_linkages_move_as_in_mujoco() {
    let cases = linkages::cases();
    let Some(python) = python() else { return };
    compare(python, "linkages.py", &cases);
}

/// Without another program: the mechanisms are derived, and energy is conserved.
#[test]
fn random_mechanisms_have_equations() {
    let mut constrained = 0;
    for seed in 0..ALL {
        let mechanism = planar::random(seed);
        let constraints = mechanism["constraints"].as_array().expect("a list").len();
        constrained += usize::from(constraints > 0);
        assert!((2..=5).contains(&mechanism["bodies"].as_array().expect("a list").len()));
    }
    assert!(constrained >= 8, "{constrained} with constraints");
}
