//! Random planar mechanisms, here and by SymPy's `KanesMethod`.
//!
//! `cargo xtask oracle` installs SymPy and runs all of them, `cargo xtask test` a few. Without a
//! Python that has it there is nothing to compare with, and the test says that it was skipped.

mod planar;

use std::path::Path;
use std::process::Command;

/// A Python that has what requirements.txt names.
const PYTHON: &str = "LETOFF_ORACLE_PYTHON";

/// How many mechanisms are compared.
const COUNT: &str = "LETOFF_ORACLE_MECHANISMS";

/// How many there are in all.
const ALL: u64 = 20;

#[test]
fn accelerations_are_those_of_kanes_method_in_sympy() {
    let Some(python) = std::env::var_os(PYTHON) else {
        println!("skipped: no Python with SymPy ({PYTHON}); `cargo xtask oracle` installs it");
        return;
    };
    let count = std::env::var(COUNT).ok().and_then(|it| it.parse().ok()).unwrap_or(ALL);
    let mechanisms: Vec<_> = (0..count).map(planar::random).collect();
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("oracle");
    std::fs::create_dir_all(&folder).expect("a folder");
    let file = folder.join("planar.json");
    let text = serde_json::to_string_pretty(&mechanisms).expect("JSON");
    std::fs::write(&file, text).expect("written");
    let program = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/oracle/kanes_method.py");
    let output = Command::new(python).arg(program).arg(&file).output().expect("Python");
    println!("{}", String::from_utf8_lossy(&output.stdout));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// Without any other program: the mechanisms are derived, and energy is conserved.
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
