//! Boots virtual machines, reads their consoles, and ends them after their time.

use std::io::{BufRead as _, BufReader};
use std::process::{Child, ChildStdout, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender};
use std::time::{Duration, Instant};
use std::{path::Path, thread};

use super::{system::GuestSystem, verdict::HeardNotes};
use crate::{command, error::Error};

/// Maximum silence of all guests, at any total time.
const SILENCE_LIMIT: Duration = Duration::from_mins(3);

/// Emulation, as build servers have no virtualisation. A microvm's timers of 4 ms are too coarse.
const QEMU: &str = "-accel tcg -machine q35 -smp 1 -m 1024 -nodefaults \
                    -display none -monitor none -serial stdio -no-reboot";

const KERNEL_ARGUMENTS: &str = "console=ttyS0 panic=-1 quiet reboot=t";

pub(super) struct VirtualMachine<'a> {
    pub kernel: &'a Path,
    pub initrd: &'a Path,
    pub system: GuestSystem,
    pub part: &'static str,
}

pub(super) struct ConsoleLine {
    part: &'static str,
    text: String,
}

impl VirtualMachine<'_> {
    /// Boots; sends console lines to `console`, which is closed at the end.
    pub(super) fn boot(&self, console: Sender<ConsoleLine>) -> Result<QemuGuard, Error> {
        let mut command = self.command();
        println!("$ {}", command::words(&command));
        let failed = |cause| Error::NotStarted { command: "qemu-system-x86_64".into(), cause };
        let mut qemu = command.spawn().map_err(failed)?;
        if let Some(output) = qemu.stdout.take() {
            read(output, self.part, console);
        }
        Ok(QemuGuard(qemu))
    }

    fn command(&self) -> Command {
        let mut command = Command::new("qemu-system-x86_64");
        let arguments = QEMU.split_whitespace().chain(self.system.machine().split_whitespace());
        command.args(arguments);
        command.arg("-kernel").arg(self.kernel).arg("-initrd").arg(self.initrd);
        // Arguments unknown to the kernel become variables of the first program.
        command.arg("-append").arg(format!("{KERNEL_ARGUMENTS} part={}", self.part));
        command.stdin(Stdio::null()).stdout(Stdio::piped());
        command
    }
}

pub(super) struct QemuGuard(Child);

impl Drop for QemuGuard {
    fn drop(&mut self) {
        // Both fail only if QEMU has already ended.
        if self.0.kill().is_ok() {
            drop(self.0.wait());
        }
    }
}

fn read(output: ChildStdout, part: &'static str, console: Sender<ConsoleLine>) {
    thread::spawn(move || {
        for line in BufReader::new(output).split(b'\n').map_while(Result::ok) {
            let text = String::from_utf8_lossy(&line).trim_end().to_owned();
            if console.send(ConsoleLine { part, text }).is_err() {
                break;
            }
        }
    });
}

/// Prints and judges all lines of `n_guests`, until the last guest ends or the time is over.
pub(super) fn listen(
    lines: &Receiver<ConsoleLine>,
    n_guests: usize,
    time_limit: Duration,
) -> HeardNotes {
    let start = Instant::now();
    let mut heard = HeardNotes::of(n_guests);
    loop {
        let left = time_limit.saturating_sub(start.elapsed()).min(SILENCE_LIMIT);
        match lines.recv_timeout(left) {
            Ok(ConsoleLine { part, text }) => {
                println!("{part}: {text}");
                heard.hear(&text);
            }
            Err(RecvTimeoutError::Disconnected) => return heard,
            Err(RecvTimeoutError::Timeout) => {
                println!("nothing more was said in time: the guests are ended");
                return heard;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::mpsc;

    use super::*;

    #[test]
    fn a_console_that_closes_ends_the_listening() {
        let (console, lines) = mpsc::channel();
        for text in ["CHECK passed  1.0 s: something", "VERDICT 0 of 1 checks failed, after 1 s"] {
            console.send(ConsoleLine { part: "bus", text: text.into() }).unwrap();
        }
        drop(console);
        let heard = listen(&lines, 2, Duration::from_mins(1));
        assert!(heard.into_result().is_err(), "the other guest gave no verdict");
    }
}
