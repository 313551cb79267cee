//! Programs that this one starts and ends.

use std::io;
use std::os::unix::process::CommandExt as _;
use std::path::PathBuf;
use std::process::{Child, Command, ExitStatus};
use std::time::Duration;

use rustix::process::{Pid, Signal, kill_process};

use super::Failure;
use super::signals::Signals;

/// Returns the program of ours called `name`, which `package` makes: beside this one, or where
/// programs are looked for.
pub(super) fn program_beside(name: &str, package: &str) -> Result<PathBuf, Failure> {
    let name = format!("{name}{}", std::env::consts::EXE_SUFFIX);
    let beside = std::env::current_exe().ok().map(|own| own.with_file_name(&name));
    let path = std::env::var_os("PATH").unwrap_or_default();
    let others = std::env::split_paths(&path).map(|folder| folder.join(&name));
    let found = beside.into_iter().chain(others).find(|file| file.is_file());
    found.ok_or_else(|| {
        Failure::Running(format!(
            "{name} is a program of its own and is not installed: `cargo build --release --package \
             {package}` makes it"
        ))
    })
}

/// Replaces this program by another one; returns only if that cannot be started.
pub(super) fn become_program(command: &mut Command) -> Result<(), Failure> {
    let error = command.exec();
    let program = command.get_program().to_string_lossy();
    Err(Failure::Running(format!("{program} cannot be started: {error}")))
}

/// Time between two looks whether a program has ended.
const LOOK: Duration = Duration::from_millis(50);

/// Looks at a program that loses nothing before it is killed: five seconds.
const LOOKS: u32 = 100;

/// The way in which a program is ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum EndMode {
    /// It is asked, and killed if it does not end in time, since it loses nothing.
    Brief,
    /// It is asked as by Ctrl-C, and waited for: forces fade and notes end.
    Patient,
}

/// A program that ends when this is dropped, if it has not before.
#[derive(Debug)]
pub(super) struct ChildProgram {
    child: Child,
    end_mode: EndMode,
}

impl ChildProgram {
    /// Starts `command`.
    pub(super) fn start(command: &mut Command, end_mode: EndMode) -> io::Result<Self> {
        Ok(Self { child: command.spawn()?, end_mode })
    }

    /// Returns its exit status, if it has ended.
    pub(super) fn ended(&mut self) -> io::Result<Option<ExitStatus>> {
        self.child.try_wait()
    }

    /// Waits until it has ended, and how; nothing if this program is to end before.
    pub(super) async fn end(&mut self, signals: &mut Signals) -> io::Result<Option<ExitStatus>> {
        let mut looks = tokio::time::interval(LOOK);
        loop {
            // Ctrl-C is for both, and then nothing went wrong with the other.
            if signals.come_before(&mut looks).await {
                return Ok(None);
            }
            if let Some(status) = self.ended()? {
                return Ok(Some(status));
            }
        }
    }

    /// Returns whether it runs; until it was seen to end, its number is not used again.
    fn is_there(&mut self) -> bool {
        matches!(self.child.try_wait(), Ok(None))
    }

    fn tell(&self, signal: Signal) {
        let id = i32::try_from(self.child.id()).ok().and_then(Pid::from_raw);
        // One that is gone is as good.
        let _gone = id.map(|id| kill_process(id, signal));
    }

    /// Returns whether it ends in time.
    fn goes(&mut self) -> bool {
        for _ in 0..LOOKS {
            if !self.is_there() {
                return true;
            }
            std::thread::sleep(LOOK);
        }
        false
    }
}

impl Drop for ChildProgram {
    fn drop(&mut self) {
        if !self.is_there() {
            return;
        }
        match self.end_mode {
            EndMode::Patient => self.tell(Signal::INT),
            EndMode::Brief => {
                self.tell(Signal::TERM);
                if !self.goes() {
                    self.tell(Signal::KILL);
                }
            }
        }
        let _ended = self.child.wait();
    }
}
