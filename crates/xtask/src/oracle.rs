//! Derived equations of motion beside those of other programs, which are installed for it.

use std::path::PathBuf;
use std::process::Command;

use crate::command::{self, cargo, root};
use crate::error::Error;
use crate::peers;
use crate::stage::Done;

/// Where the tests of `kane` look for a Python with SymPy and `MuJoCo`.
const PYTHON: &str = "LETOFF_ORACLE_PYTHON";

/// How many random mechanisms they compare.
const COUNT: &str = "LETOFF_ORACLE_MECHANISMS";

/// What the Python needs, from the workspace's root.
const REQUIREMENTS: &str = "crates/mechanism/tests/kane/oracle/requirements.txt";

/// How many random mechanisms a short run compares: those of two and three bodies among them.
const SHORT: &str = "6";

/// Compares all mechanisms and motions.
///
/// # Errors
/// Says what could not be installed, or that the equations or motions are others.
pub(crate) fn run() -> Result<(), Error> {
    command::run(&mut compare(&python()?))
}

/// Compares fewer random mechanisms; skipped where the other programs cannot be had.
///
/// # Errors
/// Says that the equations or motions are others.
pub(crate) fn short() -> Result<Done, Error> {
    match python() {
        Ok(python) => command::run(compare(&python).env(COUNT, SHORT)).map(|()| Done::All),
        Err(error) => Ok(Done::Skipped(error.to_string())),
    }
}

/// A Python with SymPy and `MuJoCo`.
fn python() -> Result<PathBuf, Error> {
    let work = root().join("target/oracle");
    std::fs::create_dir_all(&work).map_err(|cause| Error::file(&work, cause))?;
    peers::python_with(&work, &root().join(REQUIREMENTS))
}

/// The tests that ask for it, which are in `kane`. The whole workspace is selected, since for one
/// package alone Cargo builds what it needs once more, with other features.
fn compare(python: &PathBuf) -> Command {
    let mut command =
        cargo(["test", "--workspace", "--test", "all", "oracle", "--", "--nocapture"]);
    command.env(PYTHON, python);
    command
}
