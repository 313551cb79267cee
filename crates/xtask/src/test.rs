//! Runs all tests in stages, fast proofs first; emulated machines separately.

use std::{ffi::OsString, path::Path, process::Command};

use crate::command::{cargo, root, target};
use crate::guest_boards::{self, CheckScope};
use crate::stage::{self, Stage, StageWork};
use crate::{apt, error::Error, guest::TriedProgram, guest_midi, optional, oracle};

const SEED_NAME: &str = "PROPTEST_RNG_SEED";

/// Seed of property tests: equal cases in each run, so that a failure belongs to the change. `cargo
/// test` draws other cases; the variable overrides the seed.
const SEED: &str = "1994";

const PROGRAM: &str = "LETOFF_PROGRAM";

/// Crates of the tick, which must build without the standard library.
const NO_STD: [&str; 4] = ["pode", "instruments", "scheduler", "firmware-protocol"];

const BARE_TARGET: &str = "thumbv7em-none-eabihf";

const NOT_INSTALLED: &str = "the target is not installed (rustup target add thumbv7em-none-eabihf)";

const MACHINES: &str = "LETOFF_MACHINES";

const FIRMWARE: [&str; 3] = ["--workspace", "--test=firmware", "--test=mcu"];

/// Tests of the host with such firmware, by their files and names.
const WITH_FIRMWARE: [&str; 5] =
    ["--workspace", "--test=boards", "--", "cortex::", "conformance::the_reference_firmware"];

#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum TestScope {
    ThisMachine,
    EmulatedMachines,
    /// Those of one crate whose names contain one of `filters`, or all.
    Crate {
        name: String,
        filters: Vec<OsString>,
    },
}

pub(crate) fn run(scope: TestScope) -> Result<(), Error> {
    apt::install_missing()?;
    let program = target()?.join("debug").join(format!("letoff{}", std::env::consts::EXE_SUFFIX));
    stage::run_all(match scope {
        TestScope::ThisMachine => {
            optional::install();
            stages(&program, (!has_bare_target()).then_some(NOT_INSTALLED))
        }
        TestScope::EmulatedMachines => {
            optional::install_machines();
            machines(&program)
        }
        TestScope::Crate { name, filters } => vec![of_crate(&name, filters)?],
    })
}

/// The stage with the tests of one crate. Cargo compiles dependencies once for each set of
/// features. With the package `letoff` the set is the same for each crate.
fn of_crate(name: &str, filters: Vec<OsString>) -> Result<Stage, Error> {
    let folder = match name {
        "firmware-protocol" => root().join(name),
        _ => root().join("crates").join(name),
    };
    if !folder.is_dir() {
        return Err(Error::unobtainable(format!("the crate {name}"), "no folder has its name"));
    }
    let sources = if folder.join("src/lib.rs").exists() { "--lib" } else { "--bins" };
    let mut command = cargo(["test", "--package", name, "--package", "letoff", sources]);
    if folder.join("tests/main.rs").exists() {
        command.args(["--test", "all"]);
    }
    command.arg("--").args(filters);
    Ok(Stage { name: "the tests of one crate", work: StageWork::Command(command), skipped: None })
}

fn cargo_stage(name: &'static str, arguments: &[&str], program: &Path) -> Stage {
    let mut command = cargo(arguments);
    command.env(SEED_NAME, std::env::var_os(SEED_NAME).unwrap_or_else(|| SEED.into()));
    command.env(PROGRAM, program);
    Stage { name, work: StageWork::Command(command), skipped: None }
}

/// Returns the stages without emulated machines, for tests of `program`; `no_bare_target` is the
/// reason to skip the stage for the bare target. All stages select the whole workspace, since Cargo
/// compiles dependencies once per set of features: later stages reuse the build.
fn stages(program: &Path, no_bare_target: Option<&'static str>) -> Vec<Stage> {
    let stage = |name, arguments: &[&str]| {
        let mut stage = cargo_stage(name, arguments, program);
        if let StageWork::Command(command) = &mut stage.work {
            command.env(MACHINES, "none");
        }
        stage
    };
    vec![
        stage("the tick's crates without std", &no_std(&[])),
        Stage {
            skipped: no_bare_target,
            ..stage("the same on bare metal", &no_std(&["--target", BARE_TARGET]))
        },
        // Show all crates' failures. Outside `cargo bench` each bench runs once.
        stage("tests, examples and benches", &test(&["--workspace", "--all-targets"])),
        stage("examples in the documentation", &test(&["--workspace", "--doc"])),
        Stage {
            name: "equations and motions beside SymPy's and MuJoCo's",
            work: StageWork::Chore(oracle::short),
            skipped: None,
        },
    ]
}

fn machines(program: &Path) -> Vec<Stage> {
    let chore = |name, chore| Stage { name, work: StageWork::Chore(chore), skipped: None };
    vec![
        cargo_stage("the programs", &test(&["--workspace", "--all-targets", "--no-run"]), program),
        cargo_stage("firmware on a Cortex-M3 (QEMU)", &test(&FIRMWARE), program),
        cargo_stage("the host with eight of them", &test(&WITH_FIRMWARE), program),
        chore("boards in a Debian kernel (QEMU)", || {
            guest_boards::guest(CheckScope::Short, TriedProgram::OfTheTests).run()
        }),
        chore("MIDI in a Debian kernel (QEMU)", || {
            guest_midi::guest(TriedProgram::OfTheTests).run()
        }),
    ]
}

/// Returns arguments that check the crates of the tick without the standard library.
fn no_std<'a>(more: &[&'a str]) -> Vec<&'a str> {
    let packages = NO_STD.iter().flat_map(|package| ["--package", package]);
    ["check", "--no-default-features"].into_iter().chain(packages).chain(more.to_vec()).collect()
}

fn test<'a>(which: &[&'a str]) -> Vec<&'a str> {
    ["test", "--no-fail-fast"].iter().chain(which).copied().collect()
}

fn has_bare_target() -> bool {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let output =
        Command::new(rustc).args(["--print", "target-libdir", "--target", BARE_TARGET]).output();
    let path = output.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned());
    path.is_ok_and(|path| !path.is_empty() && Path::new(&path).is_dir())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::words;

    #[test]
    fn every_crate_is_tested_not_only_the_default_one() {
        let all =
            stages(Path::new("letoff"), None).into_iter().chain(machines(Path::new("letoff")));
        for stage in all {
            let StageWork::Command(command) = stage.work else { continue };
            let line = words(&command);
            let selects = ["--workspace", "--package"].iter().any(|flag| line.contains(flag));
            assert!(selects, "{line}");
        }
    }

    #[test]
    fn the_cases_of_property_tests_are_chosen() {
        for stage in stages(Path::new("letoff"), None) {
            let StageWork::Command(command) = stage.work else { continue };
            for set in [SEED_NAME, PROGRAM] {
                assert!(command.get_envs().any(|(name, value)| name == set && value.is_some()));
            }
        }
    }

    #[test]
    fn without_the_bare_target_only_that_stage_is_skipped() {
        let stages = stages(Path::new("letoff"), Some("x"));
        let skipped: Vec<_> = stages.iter().map(|stage| stage.skipped).collect();
        assert_eq!(skipped, [None, Some("x"), None, None, None]);
    }
}
