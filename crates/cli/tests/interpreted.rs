//! Models without machine code: in a process whose memory may never be executable.

use std::io::Write as _;
use std::process::{Command, Output};

/// Denies the process all memory that becomes executable later, and runs its other arguments.
const DENIED: &str = "import ctypes, os, sys
PR_SET_MDWE, PR_MDWE_REFUSE_EXEC_GAIN = 65, 1
if ctypes.CDLL(None).prctl(PR_SET_MDWE, PR_MDWE_REFUSE_EXEC_GAIN, 0, 0, 0): sys.exit(99)
os.execv(sys.argv[1], sys.argv[1:])";

/// Prints energy, work and end of half a second of model C, pressed.
const STROKE: &str = "simulate reduced-grand --until 0.5 --step 1e-3 --input s=0.004*(1-cos(20*t))";

fn simulated(command: &mut Command) -> Output {
    command.args(STROKE.split(' ')).output().expect("a program that runs")
}

#[test]
fn interpreted_models_move_as_compiled_ones_and_one_line_says_so() {
    let letoff = env!("CARGO_BIN_EXE_letoff");
    let compiled = simulated(&mut Command::new(letoff));
    assert!(compiled.status.success());
    let mut denied = Command::new("python3");
    denied.args(["-c", DENIED, letoff]);
    let Ok(_) = Command::new("python3").arg("--version").output() else {
        return skip("there is no python3");
    };
    let interpreted = simulated(&mut denied);
    if interpreted.status.code() == Some(99) {
        return skip("this kernel cannot deny executable memory");
    }
    let words = String::from_utf8_lossy(&interpreted.stderr);
    assert!(words.contains("models are interpreted"), "{words}");
    assert_eq!(words.lines().count(), 1, "{words}");
    let printed = |output: &Output| String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(printed(&interpreted), printed(&compiled));
}

fn skip(why: &str) {
    let _closed = writeln!(std::io::stderr(), "SKIPPED: {why}: interpretation was not tested");
}
