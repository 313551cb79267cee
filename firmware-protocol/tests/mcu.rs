//! This crate meets the vectors on the microcontroller too.
#![expect(clippy::expect_used, reason = "helpers of tests, outside #[test]")]
#![expect(clippy::disallowed_macros, reason = "tests run on the host")]

#[expect(dead_code, reason = "other tests use the rest")]
#[path = "support/tools.rs"]
mod tools;

use std::path::PathBuf;
use std::process::Command;

use tools::{are_there, crate_root, run, say, scratch};

const TARGET: &str = "thumbv7m-none-eabi";

#[test]
fn the_crate_meets_every_vector_on_a_cortex_m3() {
    if !are_there(&["qemu-system-arm", "rustup"]) || !has_target() {
        return;
    }
    let mut qemu = Command::new("qemu-system-arm");
    qemu.args(["-M", "lm3s6965evb", "-display", "none", "-monitor", "none"]);
    qemu.args(["-semihosting-config", "enable=on,target=native", "-kernel"]);
    let said = run(qemu.arg(build())).stdout;
    let said = String::from_utf8_lossy(&said);
    let files = std::fs::read_dir(crate_root().join("vectors")).expect("the vectors");
    let files = files.map(|file| file.expect("a file").path());
    let n = files.filter(|path| path.extension().is_some_and(|end| end == "hex")).count();
    assert_eq!(said.trim(), format!("{n} of {n} vectors hold on this machine"));
}

fn has_target() -> bool {
    let installed = run(Command::new("rustup").args(["target", "list", "--installed"])).stdout;
    let there = String::from_utf8_lossy(&installed).lines().any(|line| line == TARGET);
    if !there {
        say(&format!("SKIPPED: not installed: run rustup target add {TARGET}"));
    }
    there
}

fn build() -> PathBuf {
    let folder = scratch("mcu");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--release", "--locked"]).current_dir(crate_root().join("mcu"));
    run(cargo.env("CARGO_TARGET_DIR", &folder).env_remove("RUSTFLAGS"));
    folder.join(TARGET).join("release/firmware-protocol-mcu")
}
