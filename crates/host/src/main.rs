//! The `letoff` command.

use std::process::ExitCode;

use clap::Parser as _;

fn main() -> ExitCode {
    host::command::run(&host::command::Letoff::parse())
}
