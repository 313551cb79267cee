//! The `letoff` command.

use std::process::ExitCode;

use clap::Parser as _;

fn main() -> ExitCode {
    cli::run(&cli::Letoff::parse())
}
