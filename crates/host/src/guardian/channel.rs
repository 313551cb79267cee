//! The host's end of the socket to its guardian, with bounded waits.

use std::io::{self, ErrorKind, Read as _, Write as _};
use std::os::unix::net::{UnixListener, UnixStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::{os::fd::OwnedFd, os::unix::process::CommandExt as _, time::Duration};

use documents::shown;
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::net::sockopt::socket_peercred;
use rustix::process::{Pid, Signal, kill_process};

use super::protocol::{GuardianLine, HostLine};
use crate::control::place;

const COMMAND: &str = "midi-guardian";

const LONGEST_LINE: usize = 4096;

#[derive(Debug)]
pub(super) struct GuardianChannel {
    stream: UnixStream,
    /// Received bytes after the last whole line.
    received: Vec<u8>,
    child: Option<Child>,
    pid: Pid,
}

impl GuardianChannel {
    /// Connects to the guardian at `path`, and starts one if none exists.
    ///
    /// # Errors
    /// If the start fails, or the process there belongs to another user.
    pub(super) fn reach(path: &Path) -> io::Result<Self> {
        let (stream, child) = match UnixStream::connect(path) {
            Ok(stream) => (stream, None),
            Err(error)
                if matches!(error.kind(), ErrorKind::NotFound | ErrorKind::ConnectionRefused) =>
            {
                let child = start(path)?;
                (UnixStream::connect(path)?, Some(child))
            }
            Err(error) => return Err(error),
        };
        let peer = socket_peercred(&stream)?;
        if peer.uid.as_raw() != place::user() {
            let text = format!("another user listens at {}", shown(path));
            return Err(io::Error::new(ErrorKind::PermissionDenied, text));
        }
        stream.set_nonblocking(true)?;
        Ok(Self { stream, received: Vec::new(), child, pid: peer.pid })
    }

    /// Sends `line` without waiting.
    ///
    /// # Errors
    /// If the guardian is gone, or its buffer is full.
    pub(super) fn send(&mut self, line: &HostLine) -> io::Result<()> {
        let mut text = serde_json::to_vec(line)?;
        text.push(b'\n');
        self.stream.write_all(&text)
    }

    /// Returns the next received line, if any.
    ///
    /// # Errors
    /// If the guardian is gone, or its line is invalid.
    pub(super) fn receive(&mut self) -> io::Result<Option<GuardianLine>> {
        let mut bytes = [0; 512];
        while !self.received.contains(&b'\n') {
            match self.stream.read(&mut bytes) {
                Ok(0) => return Err(ErrorKind::UnexpectedEof.into()),
                Ok(n) => self.received.extend(bytes.iter().take(n)),
                Err(error) if error.kind() == ErrorKind::WouldBlock => return Ok(None),
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
            if LONGEST_LINE < self.received.len() {
                return Err(ErrorKind::InvalidData.into());
            }
        }
        self.first_line()
    }

    fn first_line(&mut self) -> io::Result<Option<GuardianLine>> {
        let end = self.received.iter().position(|byte| *byte == b'\n');
        let Some(end) = end else { return Ok(None) };
        let text: Vec<u8> = self.received.drain(..=end).collect();
        Ok(Some(serde_json::from_slice(&text)?))
    }

    /// Waits for the next line except beats, at most `patience` for each line.
    ///
    /// # Errors
    /// If none arrives, or the guardian is gone.
    pub(super) fn wait(&mut self, patience: Duration) -> io::Result<GuardianLine> {
        loop {
            match self.receive()? {
                Some(GuardianLine::Beat(_)) => {}
                Some(line) => return Ok(line),
                None => self.wait_until_readable(patience)?,
            }
        }
    }

    fn wait_until_readable(&self, patience: Duration) -> io::Result<()> {
        let timeout = Timespec::try_from(patience).ok();
        let mut fds = [PollFd::new(&self.stream, PollFlags::IN)];
        if poll(&mut fds, timeout.as_ref())? == 0 {
            return Err(ErrorKind::TimedOut.into());
        }
        Ok(())
    }

    /// Kills a guardian that does not answer, which closes its port and ends its notes.
    pub(super) fn kill(mut self) {
        // Before a guardian has begun, the process behind its socket is the host that started it.
        let pid = self.pid.as_raw_nonzero();
        let command = std::fs::read(format!("/proc/{pid}/cmdline")).unwrap_or_default();
        if command.split(|byte| *byte == 0).any(|word| word == COMMAND.as_bytes()) {
            // A missing process is as good as a killed one.
            let _gone = kill_process(self.pid, Signal::KILL);
        }
        if let Some(child) = &mut self.child {
            let _ended = child.kill().and_then(|()| child.wait());
        }
    }
}

impl Drop for GuardianChannel {
    fn drop(&mut self) {
        let _ended = self.child.as_mut().map(Child::try_wait);
    }
}

/// Starts a guardian that listens at `path`, where a killed one may have left its socket.
///
/// It inherits the listening socket, so clients can connect at once.
fn start(path: &Path) -> io::Result<Child> {
    place::prepare_folder(path)?;
    place::clear(path)?;
    let listener = UnixListener::bind(path)?;
    let mut command = Command::new(program());
    command.arg(COMMAND).arg(path).stdin(Stdio::from(OwnedFd::from(listener)));
    // It outlives this process, so it holds none of its pipes and gets no terminal signals.
    command.stdout(Stdio::null()).stderr(Stdio::null()).process_group(0);
    command.spawn()
}

/// Returns this program, even if a newer file replaced it.
pub fn program() -> PathBuf {
    let named = std::env::current_exe().ok().filter(|path| path.exists());
    named.unwrap_or_else(|| PathBuf::from("/proc/self/exe"))
}
