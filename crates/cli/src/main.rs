//! The `letoff` command.

use std::process::ExitCode;

use clap::Parser as _;

fn main() -> ExitCode {
    cli::main_thread("letoff", || cli::run(&cli::Letoff::parse()))
}
