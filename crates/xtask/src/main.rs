//! Chores of the workspace; `cargo xtask help` lists them.
//!
//! Nothing here needs a system library: xtask must run on a machine on which they are missing.
#![forbid(unsafe_code)]
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a command for people")]

mod apt;
mod arguments;
mod bench;
mod command;
mod demo;
mod dist;
mod error;
mod files;
mod fuzz;
mod guest;
mod guest_boards;
mod guest_midi;
mod guest_service;
mod needs;
mod optional;
mod oracle;
mod peers;
mod size;
mod stage;
mod test;
mod tools;

use std::{env, process::ExitCode};

use arguments::{Task, USAGE};
use error::Error;

fn main() -> ExitCode {
    match arguments::parse(env::args_os().skip(1)).and_then(perform) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("xtask: {error}");
            error.exit_code()
        }
    }
}

fn perform(task: Task) -> Result<(), Error> {
    match task {
        Task::Demo { forwarded } => demo::play(forwarded),
        Task::Test(scope) => test::run(scope),
        Task::Dist { profile } => dist::run(&profile),
        Task::GuestService { profile } => guest_service::guest(&profile).run().map(drop),
        Task::GuestMidi => guest_midi::guest(guest::TriedProgram::Release).run().map(drop),
        Task::GuestBoards(form) => {
            guest_boards::guest(form, guest::TriedProgram::Release).run().map(drop)
        }
        Task::Oracle => oracle::run(),
        Task::Bench(usage) => bench::measure(usage),
        Task::Fuzz(options) => fuzz::run(&options),
        Task::Peers(options) => peers::run(&options),
        Task::Size => size::print(),
        Task::Tool(target, arguments) => {
            let mut tool = command::cargo(["run", "--release", "--quiet"]);
            command::become_command(tool.args(target).arg("--").args(arguments))
        }
        Task::Help => {
            print!("{USAGE}");
            Ok(())
        }
    }
}
