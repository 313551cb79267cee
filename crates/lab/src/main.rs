//! `letoff-lab`, which `letoff lab` starts.

use std::process::ExitCode;

use clap::Parser as _;
use lab::command::{LabArgs, run};

fn main() -> ExitCode {
    cli::main_thread("letoff-lab", || cli::finish(|out| run(&LabArgs::parse(), out)))
}
