//! Optional tools of tests: emulators, a tracer, a target. Tests without them report a skip.

use std::process::Command;

use crate::apt;
use crate::command;
use crate::guest_boards;
use crate::needs::has_program;
use crate::tools::{self, Tool};

/// Tools for firmware on an emulated microcontroller.
const FIRMWARE: [Tool; 3] = [
    ("qemu-system-arm", "qemu-system-arm"),
    ("arm-none-eabi-gcc", "gcc-arm-none-eabi"),
    ("/usr/include/newlib/newlib.h", "libnewlib-arm-none-eabi"),
];

/// Tool for the system calls of a tick.
const TRACER: [Tool; 1] = [("strace", "strace")];

const TARGET: &str = "thumbv7m-none-eabi";

/// Installs what is possible, and reports the rest.
pub(crate) fn install() {
    if !cfg!(target_os = "linux") {
        return;
    }
    let packages = packages(|it| tools::find(it).is_some());
    if !packages.is_empty() {
        println!("installing what some tests need: {}", packages.join(" "));
        if let Err(error) = apt::install(&packages) {
            println!("{error}; the tests that need it are skipped");
        }
    }
    if has_program("rustup") {
        let mut add = Command::new("rustup");
        if command::run(add.args(["target", "add", TARGET])).is_err() {
            println!("the tests for {TARGET} are skipped");
        }
    }
}

/// Returns the missing packages, for one call of apt.
fn packages(is_there: impl Fn(&str) -> bool) -> Vec<&'static str> {
    tools::packages(&[&FIRMWARE, &TRACER, &tools::MAKERS, &guest_boards::PROGRAMS], is_there)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_missing_is_installed_in_one_call() {
        assert!(packages(|_| true).is_empty());
        let is_there =
            |it: &str| !["qemu", "strace", "/"].iter().any(|lacks| it.starts_with(lacks));
        let packages = packages(is_there);
        let expected = ["libnewlib-arm-none-eabi", "qemu-system-arm", "qemu-system-x86", "strace"];
        assert_eq!(packages, expected);
    }
}
