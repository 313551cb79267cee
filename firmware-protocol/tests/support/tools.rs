//! Other people's tools, run by tests; a tool that is missing is said aloud.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Warnings that firmware compiles without.
pub(crate) const STRICT: [&str; 6] =
    ["-std=c99", "-Wall", "-Wextra", "-Wconversion", "-pedantic", "-Werror"];

/// Whether all tools are there; if not, says so where libtest does not catch it.
pub(crate) fn are_there(tools: &[&str]) -> bool {
    let emulates = tools.contains(&"qemu-system-arm");
    if emulates && std::env::var_os("LETOFF_MACHINES").is_some_and(|it| it == "none") {
        say("SKIPPED: firmware under QEMU is tested by cargo xtask test --machines");
        return false;
    }
    let missing: Vec<_> = tools.iter().filter(|tool| !answers(tool)).collect();
    if !missing.is_empty() {
        say(&format!("SKIPPED: not installed: {missing:?}"));
    }
    missing.is_empty()
}

fn answers(tool: &str) -> bool {
    Command::new(tool).arg("--version").output().is_ok_and(|output| output.status.success())
}

/// A line for whoever runs the tests, passed or not.
pub(crate) fn say(line: &str) {
    let _nobody_listens = writeln!(std::io::stderr(), "{line}");
}

/// The crate's folder.
pub(crate) fn crate_root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Where tests may leave files.
pub(crate) fn scratch(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

/// Runs `command`; fails with what it said if it does.
pub(crate) fn run(command: &mut Command) -> Output {
    let output = command.output().expect("the command starts");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}\n{said}");
    output
}
