//! Parses the command line.

use std::ffi::OsString;

use crate::{
    bench::BaselineUse, dist, error::Error, fuzz::FuzzOptions, guest_boards::CheckScope,
    peers::PeerOptions, test::TestScope,
};

pub(crate) const USAGE: &str = "\
Chores of this workspace.

  cargo xtask demo [-- ARGUMENTS]   installs what is missing, builds, and runs
                                    `letoff run --duration 30 ARGUMENTS`: the simulated
                                    keybed and a virtual pianist, on any machine
  cargo xtask test [--machines]     installs what is missing and runs every test that needs no
                                    emulated machine; with --machines those that do: boards on
                                    microcontrollers, and the drivers of a Debian kernel
  cargo xtask test CRATE [NAMES]    runs the tests of a crate, those whose names contain one of
                                    NAMES; builds nothing twice from one crate to the next
  cargo xtask dist [--profile NAME] makes a Debian package of the command, the window and the
                                    service, target/dist/letoff_VERSION_ARCH.deb, on Debian and
                                    Ubuntu; most of its time is an optimised build, which is
                                    shorter with `--profile release`
  cargo xtask guest-service [--profile NAME]
                                    makes the package of a release build, installs, starts,
                                    breaks, stops and removes it under systemd in an emulated
                                    machine, as guest-midi; a few minutes after the build
  cargo xtask guest-midi            plays to real ALSA ports in an emulated machine, and
                                    checks what is heard: Debian or Ubuntu on x86_64; the
                                    first time downloads QEMU and a kernel (90 MB), then
                                    about a minute; skipped, and says so, elsewhere
  cargo xtask guest-boards [--full]
                                    plays and breaks boards over real CAN and USB drivers in
                                    two emulated machines, as guest-midi; two minutes, with
                                    --full six
  cargo xtask peers [--quick] [--out DIR]
                                    runs other people's ODE solvers and ours side by side
                                    and writes results.json and table.md, by default into
                                    benches/peers/results; a quarter of an hour, with
                                    --quick two minutes and into target/peers/results
  cargo xtask bench [--write-baseline]
                                    measures codec, strike to MIDI, ticks and voices of the
                                    built-in models, and names those that became slower than
                                    noise since benches/baseline.toml, which --write-baseline
                                    writes anew; some minutes, on a machine that is idle
  cargo xtask oracle                derives random mechanisms and the built-in models here
                                    and with SymPy, moves linkages here and with MuJoCo,
                                    both installed from PyPI into target/oracle, and
                                    compares accelerations, forces and motions; three minutes
  cargo xtask fuzz [--mutations N] [--kind KIND] [--seed N] [--program PATH]
                                    gives damaged scenes, descriptions, instruments, MIDI, CSV,
                                    recordings, tokens, play lists and calibration files, 1000
                                    of each, to a release build with limits of memory and
                                    processor time, and keeps those on which it panics, takes
                                    more than 5 s of processor time or ends with a code that is
                                    not documented; half an hour
  cargo xtask size                  counts lines of product and of tests, and names the largest
                                    crates, structs and traits
  cargo xtask soak [ARGUMENTS]      plays random music on a simulated keybed with faults in
                                    everything around it, and judges what the host promises;
                                    --help lists the arguments
  cargo xtask certificates [ARGUMENTS]
                                    looks for a step that was called certain and hides a
                                    crossing, on random systems; --help lists the arguments
  cargo xtask help                  prints this

Example: cargo xtask demo -- --duration 5
";

/// Cargo's arguments for the target of each tool in the folder `tests/`.
const SOAK: &[&str] = &["--package", "soak"];
const CERTIFICATES: &[&str] = &["--package", "letoff", "--example", "certificates"];

/// A task of the command line.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Task {
    Demo {
        forwarded: Vec<OsString>,
    },
    Test(TestScope),
    Dist {
        profile: String,
    },
    GuestService {
        profile: String,
    },
    GuestMidi,
    GuestBoards(CheckScope),
    /// Compare derived equations with SymPy's, and motions with `MuJoCo`'s.
    Oracle,
    /// Measure latencies, and compare them with the baseline.
    Bench(BaselineUse),
    Peers(PeerOptions),
    Fuzz(FuzzOptions),
    /// Count the lines of Rust, and compare them with the allowance.
    Size,
    /// Run the tool of this cargo target with these arguments.
    Tool(&'static [&'static str], Vec<OsString>),
    Help,
}

pub(crate) fn parse(mut arguments: impl Iterator<Item = OsString>) -> Result<Task, Error> {
    let Some(name) = arguments.next() else { return Ok(Task::Help) };
    let task = match name.to_str() {
        Some("demo") => return demo(arguments),
        Some("peers") => return peers(arguments),
        Some("soak") => return Ok(Task::Tool(SOAK, arguments.collect())),
        Some("certificates") => return Ok(Task::Tool(CERTIFICATES, arguments.collect())),
        Some("fuzz") => {
            let options = FuzzOptions::parse(arguments)?;
            return Ok(options.map_or(Task::Help, Task::Fuzz));
        }
        Some("bench") => {
            let modes = [BaselineUse::Compare, BaselineUse::Write];
            return with_flag(arguments, "--write-baseline", modes.map(Task::Bench));
        }
        Some("test") => return test(arguments),
        Some("size") => Task::Size,
        Some("oracle") => Task::Oracle,
        Some("guest-midi") => Task::GuestMidi,
        Some("dist") => {
            return with_profile(arguments, dist::PROFILE, |profile| Task::Dist { profile });
        }
        Some("guest-service") => {
            return with_profile(arguments, "release", |profile| Task::GuestService { profile });
        }
        Some("guest-boards") => {
            let scopes = [CheckScope::Short, CheckScope::Full];
            return with_flag(arguments, "--full", scopes.map(Task::GuestBoards));
        }
        Some("help" | "--help" | "-h") => Task::Help,
        _ => return Err(refused(&name)),
    };
    match arguments.next() {
        None => Ok(task),
        Some(argument) if is_help(&argument) => Ok(Task::Help),
        Some(argument) => Err(refused(&argument)),
    }
}

fn demo(mut arguments: impl Iterator<Item = OsString>) -> Result<Task, Error> {
    match arguments.next() {
        None => Ok(Task::Demo { forwarded: Vec::new() }),
        Some(separator) if separator == "--" => Ok(Task::Demo { forwarded: arguments.collect() }),
        Some(argument) if is_help(&argument) => Ok(Task::Help),
        Some(argument) => Err(refused(&argument)),
    }
}

/// Parses the profile of a task that builds; `usual` is the default.
fn with_profile(
    mut arguments: impl Iterator<Item = OsString>,
    usual: &str,
    task: impl FnOnce(String) -> Task,
) -> Result<Task, Error> {
    let mut profile = usual.to_owned();
    while let Some(argument) = arguments.next() {
        if is_help(&argument) {
            return Ok(Task::Help);
        }
        let named = (argument == "--profile").then(|| arguments.next()).flatten();
        let named = named.and_then(|name| name.into_string().ok());
        profile = named.ok_or_else(|| refused(&argument))?;
    }
    Ok(task(profile))
}

/// Returns the second of two tasks if `flag` follows, else the first.
fn with_flag(
    arguments: impl Iterator<Item = OsString>,
    flag: &str,
    [mut task, flagged]: [Task; 2],
) -> Result<Task, Error> {
    for argument in arguments {
        if is_help(&argument) {
            return Ok(Task::Help);
        } else if argument != flag {
            return Err(refused(&argument));
        }
        task = flagged.clone();
    }
    Ok(task)
}

fn test(mut arguments: impl Iterator<Item = OsString>) -> Result<Task, Error> {
    let scope = match arguments.next() {
        None => TestScope::ThisMachine,
        Some(argument) if is_help(&argument) => return Ok(Task::Help),
        Some(argument) if argument == "--machines" => TestScope::EmulatedMachines,
        Some(argument) if argument.as_encoded_bytes().starts_with(b"-") => {
            return Err(refused(&argument));
        }
        Some(argument) => {
            let name = argument.into_string().map_err(|argument| refused(&argument))?;
            TestScope::Crate { name, filters: arguments.by_ref().collect() }
        }
    };
    arguments.next().map_or(Ok(Task::Test(scope)), |argument| Err(refused(&argument)))
}

fn peers(mut arguments: impl Iterator<Item = OsString>) -> Result<Task, Error> {
    let mut options = PeerOptions::default();
    while let Some(argument) = arguments.next() {
        if is_help(&argument) {
            return Ok(Task::Help);
        } else if argument == "--quick" {
            options.quick = true;
        } else if argument == "--out"
            && let Some(folder) = arguments.next()
        {
            options.out = Some(folder.into());
        } else {
            return Err(refused(&argument));
        }
    }
    Ok(Task::Peers(options))
}

fn is_help(argument: &OsString) -> bool {
    argument == "--help" || argument == "-h"
}

fn refused(argument: &OsString) -> Error {
    Error::Argument(argument.to_string_lossy().into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(line: &str, expected: &Task) {
        let task = parse(line.split_whitespace().map(OsString::from)).expect("a task");
        assert_eq!(&task, expected, "{line}");
    }

    #[track_caller]
    fn check_refused(line: &str, argument: &str) {
        let error = parse(line.split_whitespace().map(OsString::from)).expect_err("refused");
        assert!(matches!(&error, Error::Argument(named) if named == argument), "{error}");
    }

    fn demo(forwarded: &[&str]) -> Task {
        Task::Demo { forwarded: forwarded.iter().map(OsString::from).collect() }
    }

    #[test]
    fn each_chore_has_its_name() {
        check("demo", &demo(&[]));
        check("test", &Task::Test(TestScope::ThisMachine));
        check("test --machines", &Task::Test(TestScope::EmulatedMachines));
        let scope = TestScope::Crate { name: "pode".into(), filters: vec!["zeno".into()] };
        check("test pode zeno", &Task::Test(scope));
        check("dist", &Task::Dist { profile: "dist".into() });
        check("dist --profile dev", &Task::Dist { profile: "dev".into() });
        check("guest-service", &Task::GuestService { profile: "release".into() });
        check("guest-service --profile dev", &Task::GuestService { profile: "dev".into() });
        check("oracle", &Task::Oracle);
        check("guest-midi", &Task::GuestMidi);
        check("guest-boards", &Task::GuestBoards(CheckScope::Short));
        check("guest-boards --full", &Task::GuestBoards(CheckScope::Full));
        check("bench", &Task::Bench(BaselineUse::Compare));
        check("bench --write-baseline", &Task::Bench(BaselineUse::Write));
        check("help", &Task::Help);
    }

    #[test]
    fn nothing_and_the_usual_flags_ask_for_help() {
        for line in ["", "-h", "--help", "demo --help", "test -h", "dist -h", "guest-boards -h"] {
            check(line, &Task::Help);
        }
    }

    #[test]
    fn what_follows_the_separator_is_for_letoff() {
        check("demo -- --duration 5 --help", &demo(&["--duration", "5", "--help"]));
        check("demo --", &demo(&[]));
    }

    #[test]
    fn what_follows_a_tool_is_the_tool_s() {
        check("soak", &Task::Tool(SOAK, Vec::new()));
        let forwarded = vec!["--seed".into(), "7".into(), "--help".into()];
        check("certificates --seed 7 --help", &Task::Tool(CERTIFICATES, forwarded));
    }

    #[test]
    fn the_peers_take_a_folder() {
        let options = PeerOptions { quick: true, out: Some("here".into()) };
        check("peers --quick --out here", &Task::Peers(options));
        check("peers", &Task::Peers(PeerOptions::default()));
        check("peers --help", &Task::Help);
        check_refused("peers --out", "--out");
    }

    #[test]
    fn what_is_not_understood_is_named() {
        check_refused("tset", "tset");
        check_refused("demo --duration 5", "--duration");
        check_refused("test --host", "--host");
        check_refused("test --machines host", "host");
        check_refused("dist release", "release");
        check_refused("dist --profile", "--profile");
        check_refused("guest-boards --fast", "--fast");
        check_refused("bench --quick", "--quick");
    }
}
