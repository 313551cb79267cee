//! The virtual machine: booted, listened to, and ended when its time is over.

use std::io::{BufRead as _, BufReader};
use std::path::PathBuf;
use std::process::{Child, ChildStdout, Command, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

use super::system::GuestSystem;
use super::verdict::HeardNotes;
use crate::command;
use crate::error::Error;

/// How long the guest may say nothing, however long it may take.
const SILENCE_LIMIT: Duration = Duration::from_mins(3);

/// Emulated throughout, as build servers have no virtualisation.
///
/// A q35 and not the quicker microvm: that has timers of 4 ms only, and a tick needs better ones.
const QEMU: &str = "-accel tcg -machine q35 -smp 1 -m 1024 -nodefaults \
                    -display none -monitor none -serial stdio -no-reboot";

const KERNEL_ARGUMENTS: &str = "console=ttyS0 panic=-1 quiet reboot=t";

/// The emulated machine that is booted.
pub(super) struct VirtualMachine {
    pub kernel: PathBuf,
    pub initrd: PathBuf,
    pub system: GuestSystem,
    /// How long everything may take.
    pub time_limit: Duration,
}

impl VirtualMachine {
    /// Boots, shows the console, and returns the verdict that was given there.
    ///
    /// # Errors
    /// If QEMU does not start.
    pub(super) fn boot(&self) -> Result<HeardNotes, Error> {
        let mut command = self.command();
        println!("$ {}", command::words(&command));
        let failed = |cause| Error::NotStarted { command: "qemu-system-x86_64".into(), cause };
        let mut qemu = QemuGuard(command.spawn().map_err(failed)?);
        let lines = qemu.0.stdout.take().map(read);
        Ok(lines.map_or_else(HeardNotes::default, |lines| listen(&lines, self.time_limit)))
    }

    fn command(&self) -> Command {
        let mut command = Command::new("qemu-system-x86_64");
        let arguments = QEMU.split_whitespace().chain(self.system.machine().split_whitespace());
        command.args(arguments);
        command.arg("-kernel").arg(&self.kernel).arg("-initrd").arg(&self.initrd);
        command.args(["-append", KERNEL_ARGUMENTS]);
        command.stdin(Stdio::null()).stdout(Stdio::piped());
        command
    }
}

/// Ends QEMU with its owner.
struct QemuGuard(Child);

impl Drop for QemuGuard {
    fn drop(&mut self) {
        // Both fail only if it has ended already.
        if self.0.kill().is_ok() {
            drop(self.0.wait());
        }
    }
}

/// The lines of the console, as they come.
fn read(console: ChildStdout) -> Receiver<String> {
    let (sender, receiver) = mpsc::channel();
    thread::spawn(move || {
        for line in BufReader::new(console).split(b'\n').map_while(Result::ok) {
            let line = String::from_utf8_lossy(&line).trim_end().to_owned();
            if sender.send(line).is_err() {
                break;
            }
        }
    });
    receiver
}

/// Shows all lines, and judges by them; ends at the limits of time.
fn listen(lines: &Receiver<String>, time_limit: Duration) -> HeardNotes {
    let start = Instant::now();
    let mut verdict = HeardNotes::default();
    loop {
        let left = time_limit.saturating_sub(start.elapsed()).min(SILENCE_LIMIT);
        match lines.recv_timeout(left) {
            Ok(line) => {
                println!("{line}");
                verdict.hear(&line);
            }
            Err(RecvTimeoutError::Disconnected) => return verdict,
            Err(RecvTimeoutError::Timeout) => {
                println!("nothing more was said in time: the guest is ended");
                return verdict;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_guest_ends_when_its_program_does() {
        let (kernel, initrd) = ("vmlinuz".into(), "initrd".into());
        let (system, time_limit) = (GuestSystem::Busybox, Duration::ZERO);
        let machine = VirtualMachine { kernel, initrd, system, time_limit };
        let line = command::words(&machine.command());
        assert!(line.contains("-no-reboot -icount shift=0,sleep=off -kernel vmlinuz"), "{line}");
        assert!(line.ends_with("panic=-1 quiet reboot=t"), "{line}");
    }

    #[test]
    fn a_console_that_closes_ends_the_listening() {
        let (sender, lines) = mpsc::channel();
        sender.send("CHECK passed  1.0 s: something".to_owned()).unwrap();
        drop(sender);
        assert!(
            listen(&lines, Duration::from_mins(1)).into_result().is_err(),
            "no verdict was given"
        );
    }
}
