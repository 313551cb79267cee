//! The demo: the simulated keybed and a virtual pianist, for half a minute.

use std::ffi::{OsStr, OsString};

use crate::apt;
use crate::command::{self, cargo};
use crate::error::Error;

/// Default duration (s).
const DURATION: &str = "30";

/// Installs what is missing, builds, and becomes `letoff run`.
pub(crate) fn play(forwarded: Vec<OsString>) -> Result<(), Error> {
    apt::install_missing()?;
    println!("building the host, in release mode; the first time takes a few minutes");
    command::run(&mut cargo(["build", "--release", "--package", "cli"]))?;
    let arguments = letoff_arguments(forwarded);
    let ours = ["run", "--release", "--quiet", "--package", "cli", "--"].map(OsString::from);
    command::become_command(&mut cargo(ours.into_iter().chain(arguments)))
}

/// Returns our arguments of `letoff`, then the user's; a duration of theirs replaces ours.
fn letoff_arguments(forwarded: Vec<OsString>) -> Vec<OsString> {
    let sets_duration = |argument: &OsString| {
        argument == "--duration" || argument.as_encoded_bytes().starts_with(b"--duration=")
    };
    let ours: &[&str] = if forwarded.iter().any(sets_duration) {
        &["run"]
    } else {
        &["run", "--duration", DURATION]
    };
    ours.iter().map(OsStr::new).map(OsStr::to_owned).chain(forwarded).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(forwarded: &[&str], expected: &[&str]) {
        let arguments = letoff_arguments(forwarded.iter().map(OsString::from).collect());
        assert_eq!(arguments, expected);
    }

    #[test]
    fn it_plays_for_half_a_minute_unless_told_otherwise() {
        check(&[], &["run", "--duration", "30"]);
        check(&["--json"], &["run", "--duration", "30", "--json"]);
        check(&["--duration", "5"], &["run", "--duration", "5"]);
        check(&["--duration=5"], &["run", "--duration=5"]);
    }
}
