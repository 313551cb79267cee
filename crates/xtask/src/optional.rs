//! Optional tools of tests: emulators, a tracer, a target. Tests without them report a skip.

use std::process::Command;

use crate::tools::{self, Tool};
use crate::{apt, command, guest_boards, needs::has_program};

/// Tools for firmware on an emulated microcontroller.
const FIRMWARE: [Tool; 3] = [
    ("qemu-system-arm", "qemu-system-arm"),
    ("arm-none-eabi-gcc", "gcc-arm-none-eabi"),
    ("/usr/include/newlib/newlib.h", "libnewlib-arm-none-eabi"),
];

/// Tool for the system calls of a tick.
const TRACER: [Tool; 1] = [("strace", "strace")];

/// Tools of all tests on emulated machines.
const MACHINES: [&[Tool]; 3] = [&FIRMWARE, &tools::MAKERS, &guest_boards::PROGRAMS];

const TARGET: &str = "thumbv7m-none-eabi";

/// Installs what the tests without emulated machines use.
pub(crate) fn install() {
    install_tools(&[&TRACER]);
}

/// Installs what the tests on emulated machines use.
pub(crate) fn install_machines() {
    install_tools(&MACHINES);
    if cfg!(target_os = "linux") && has_program("rustup") {
        let mut add = Command::new("rustup");
        if command::run(add.args(["target", "add", TARGET])).is_err() {
            println!("the tests for {TARGET} are skipped");
        }
    }
}

fn install_tools(wanted: &[&[Tool]]) {
    let packages = tools::packages(wanted, |it| tools::find(it).is_some());
    if !cfg!(target_os = "linux") || packages.is_empty() {
        return;
    }
    println!("installing what some tests need: {}", packages.join(" "));
    if let Err(error) = apt::install(&packages) {
        println!("{error}; the tests that need it are skipped");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_missing_is_installed_in_one_call() {
        assert!(tools::packages(&MACHINES, |_| true).is_empty());
        let is_there = |it: &str| !["qemu", "/"].iter().any(|lacks| it.starts_with(lacks));
        let expected = ["libnewlib-arm-none-eabi", "qemu-system-arm", "qemu-system-x86"];
        assert_eq!(tools::packages(&MACHINES, is_there), expected);
        assert_eq!(tools::packages(&[&TRACER], |_| false), ["strace"]);
    }
}
