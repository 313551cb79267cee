//! Compares derived equations of motion with those of other programs, which are installed first.

use std::{path::PathBuf, process::Command};

use crate::command::{self, cargo, root};
use crate::{apt, error::Error, peers, stage::Done};

/// Variable with a Python with SymPy and `MuJoCo`, for the tests of `mechanism::kane`.
const PYTHON: &str = "LETOFF_ORACLE_PYTHON";

/// Variable with the number of random mechanisms.
const COUNT: &str = "LETOFF_ORACLE_MECHANISMS";

/// Requirements of the Python, from the workspace's root.
const REQUIREMENTS: &str = "crates/mechanism/tests/kane/oracle/requirements.txt";

/// Random mechanisms of a short run, among them those of two and three bodies.
const SHORT: &str = "6";

pub(crate) fn run() -> Result<(), Error> {
    apt::install_missing()?;
    command::run(&mut compare(&python()?))
}

/// Compares fewer random mechanisms; skipped if the other programs cannot be installed.
pub(crate) fn short() -> Result<Done, Error> {
    match python() {
        Ok(python) => command::run(compare(&python).env(COUNT, SHORT)).map(|()| Done::All),
        Err(error) => Ok(Done::Skipped(error.to_string())),
    }
}

fn python() -> Result<PathBuf, Error> {
    let work = root().join("target/oracle");
    std::fs::create_dir_all(&work).map_err(|cause| Error::file(&work, cause))?;
    peers::python_with(&work, &root().join(REQUIREMENTS))
}

/// Returns the tests of `mechanism::kane` that need it. They select the whole workspace: for one
/// package alone Cargo would build dependencies again with other features.
fn compare(python: &PathBuf) -> Command {
    let mut command =
        cargo(["test", "--workspace", "--test", "all", "oracle", "--", "--nocapture"]);
    command.env(PYTHON, python);
    command
}
