use std::io;
use std::os::unix::process::CommandExt as _;
use std::path::PathBuf;
use std::process::{Child, Command, ExitStatus};
use std::time::Duration;

use rustix::process::{Pid, Signal, kill_process};

use super::Failure;
use super::signals::Signals;

/// Returns the path of our program `name` (of `package`): beside this program, or on the path.
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

/// Interval between checks for a program's end.
const LOOK: Duration = Duration::from_millis(50);

/// Checks before a program that loses nothing is killed: five seconds.
const LOOKS: u32 = 100;

/// Method of ending a program.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum EndMode {
    /// Terminate, and kill it if it does not end in time, since it loses nothing.
    Brief,
    /// Interrupt as by Ctrl-C, and wait: forces fade and notes end.
    Patient,
}

/// A program that ends when this value is dropped, unless it ended before.
#[derive(Debug)]
pub(super) struct ChildProgram {
    child: Child,
    end_mode: EndMode,
}

impl ChildProgram {
    pub(super) fn start(command: &mut Command, end_mode: EndMode) -> io::Result<Self> {
        Ok(Self { child: command.spawn()?, end_mode })
    }

    pub(super) fn ended(&mut self) -> io::Result<Option<ExitStatus>> {
        self.child.try_wait()
    }

    /// Waits for its exit status; `None` if this program must end first.
    pub(super) async fn end(&mut self, signals: &mut Signals) -> io::Result<Option<ExitStatus>> {
        let mut looks = tokio::time::interval(LOOK);
        loop {
            // Ctrl-C reaches both, and is no failure of the other.
            if signals.come_before(&mut looks).await {
                return Ok(None);
            }
            if let Some(status) = self.ended()? {
                return Ok(Some(status));
            }
        }
    }

    /// Returns `true` while it runs; its process id is not reused before.
    fn is_there(&mut self) -> bool {
        matches!(self.child.try_wait(), Ok(None))
    }

    fn tell(&self, signal: Signal) {
        let id = i32::try_from(self.child.id()).ok().and_then(Pid::from_raw);
        // The process may have exited.
        let _gone = id.map(|id| kill_process(id, signal));
    }

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
