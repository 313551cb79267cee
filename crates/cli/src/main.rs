//! The `letoff` command.

use std::process::ExitCode;
use std::thread;

use clap::Parser as _;

/// Stack of the command (B), whatever the shell allows the first thread.
const STACK: usize = 8 << 20;

fn main() -> ExitCode {
    let command = || cli::run(&cli::Letoff::parse());
    match thread::Builder::new().name("letoff".to_owned()).stack_size(STACK).spawn(command) {
        // A panic was reported where it happened.
        Ok(running) => running.join().unwrap_or(ExitCode::from(101)),
        Err(error) => cli::no_thread(&error),
    }
}
