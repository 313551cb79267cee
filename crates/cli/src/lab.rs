//! `letoff lab`: starts the studies, a separate program beside this one.

use std::ffi::OsString;
use std::process::Command;

use clap::Args;

use super::Failure;
use super::child_program::{become_program, program_beside};

/// What `letoff lab` takes: what `letoff-lab` takes.
#[derive(Clone, Debug, Args)]
pub struct StudyArgs {
    /// A study and its arguments; --help lists them.
    #[arg(value_name = "STUDY", trailing_var_arg = true, allow_hyphen_values = true)]
    pub arguments: Vec<OsString>,
}

pub(super) fn run(args: &StudyArgs) -> Result<(), Failure> {
    let mut lab = Command::new(program_beside("letoff-lab", "lab")?);
    become_program(lab.args(&args.arguments))
}
