//! External tools for tests; a missing tool is reported.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Warnings under which firmware must compile.
pub(crate) const STRICT: [&str; 6] =
    ["-std=c99", "-Wall", "-Wextra", "-Wconversion", "-pedantic", "-Werror"];

/// Returns `true` if all tools exist; prints the missing ones past libtest's capture.
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

pub(crate) fn say(line: &str) {
    let _nobody_listens = writeln!(std::io::stderr(), "{line}");
}

pub(crate) fn crate_root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

pub(crate) fn scratch(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

pub(crate) fn run(command: &mut Command) -> Output {
    let output = command.output().expect("the command starts");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}\n{said}");
    output
}
