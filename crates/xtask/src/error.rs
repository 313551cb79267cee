//! Errors of chores, each a sentence with a remedy.

use std::{fmt, io, path::PathBuf, process::ExitCode};

use crate::needs::{self, Need};

#[derive(Debug)]
pub(crate) enum Error {
    /// An argument is not understood.
    Argument(String),
    /// A missing program that is not installed from here.
    Missing {
        needs: Vec<Need>,
        /// Reason not to install it.
        because: &'static str,
    },
    /// Another thing that a chore needs and cannot get.
    Unobtainable { what: String, because: String },
    /// A file or folder could not be read or written.
    File { path: PathBuf, cause: io::Error },
    /// Benches became slower than noise.
    Slower(Vec<String>),
    /// Checks in the guest failed, or were not made.
    Guest(String),
    /// Runs with damaged files failed; the files are kept in `folder`.
    Fuzz { failed: usize, folder: PathBuf },
    /// A command could not be started.
    NotStarted { command: String, cause: io::Error },
    /// A command ended without success.
    Failed { command: String },
}

impl Error {
    pub(crate) fn unobtainable(what: impl Into<String>, because: impl Into<String>) -> Self {
        Self::Unobtainable { what: what.into(), because: because.into() }
    }

    pub(crate) fn file(path: impl Into<PathBuf>, cause: io::Error) -> Self {
        Self::File { path: path.into(), cause }
    }

    /// Returns 2 for a wrong argument, 1 for everything else, as `letoff` does.
    pub(crate) fn exit_code(&self) -> ExitCode {
        if matches!(self, Self::Argument(_)) { ExitCode::from(2) } else { ExitCode::FAILURE }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Argument(argument) => write!(
                f,
                "\"{argument}\" is not understood here: see `cargo xtask help`, and put what \
                 is meant for `letoff run` behind `--`"
            ),
            Self::Missing { needs, because } => {
                let names: Vec<_> = needs.iter().map(|need| need.description()).collect();
                let packages = needs::packages(needs).join(" ");
                write!(
                    f,
                    "the build needs {}, and {because}: install what is missing (on Debian and \
                     Ubuntu: apt-get install {packages}), then try again",
                    names.join(" and "),
                )
            }
            Self::Unobtainable { what, because } => {
                write!(f, "{what} cannot be had here: {because}")
            }
            Self::File { path, cause } => {
                write!(f, "{} cannot be used: {cause}", path.display())
            }
            Self::Slower(benches) => write!(
                f,
                "slower than before: {}; if that is meant, `cargo xtask bench --write-baseline`",
                benches.join(", ")
            ),
            Self::Guest(verdict) => write!(f, "not all is well in the guest: {verdict}"),
            Self::Fuzz { failed, folder } => {
                write!(f, "{failed} runs failed; the damaged files are in {}", folder.display())
            }
            Self::NotStarted { command, cause } => write!(f, "cannot start `{command}`: {cause}"),
            Self::Failed { command } => write!(f, "this command failed: {command}"),
        }
    }
}
