//! Boards that a program simulates, in lockstep with the host: virtual time only.
//!
//! The host starts the program and exchanges bytes over its stdin and stdout, little endian:
//!
//! | from | bytes | content |
//! |---|---|---|
//! | host | 8 | time up to which the program must simulate (us), later than the last |
//! | host | 2 + n | number n, and the bytes that the host has sent since the last exchange |
//! | program | 2 + n | number n, and the bytes that its boards have sent since then |
//!
//! The program gives the bytes of the host to its boards at its old time, simulates up to the new
//! one, and answers. The bytes are those of a serial port, including framing. A program begins at
//! time 0, and exits when its stdin ends.

use std::io::{self, Read as _};
use std::process::{Child, ChildStdin, ChildStdout, Command, ExitStatus, Stdio};
use std::{collections::VecDeque, os::unix::process::CommandExt as _, time::Duration};

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::fs::{OFlags, fcntl_getfl, fcntl_setfl};
use rustix::{fd::AsFd, io::Errno};

use super::address::BoardLinkKind;
use super::framed::Framing;
use super::trouble::ProgramTrouble;
use super::{Link, RecvError, SendError};
use crate::links::{Error, HostClock, pause};
use crate::plan::NoPlan;

pub const KIND: BoardLinkKind = BoardLinkKind {
    scheme: "rig",
    forms: "rig:PROGRAM",
    help: "'rig:PROGRAM ARGUMENTS' for a program that lives boards in virtual time",
    key: "rig",
    mode: None,
    options: &[],
    noun: "a program in lockstep",
    subject: "a program in lockstep",
    baud: None,
    is_in_lockstep: true,
    open: |address, _side, clock| Ok(Box::new(Lockstep::start(&address.place, clock)?)),
    medium: |_address, _rates| Err(NoPlan::Virtual),
};

/// Time without a byte after which a program counts as hung (s), longer than on a busy machine.
const PATIENCE_S: i64 = 5;
/// Interval and maximum number of polls for the exit of a program: 5 s.
const LOOK: Duration = Duration::from_millis(5);
const MAX_LOOKS: u32 = 1_000;
/// Bytes before those of the wire: time and number.
const HEAD: usize = 10;
/// Maximum number of bytes of an exchange in each direction.
const MAX_BYTES: usize = u16::MAX as usize;
/// Simulated time after the last bytes of the host (us), so that the boards receive them.
const FAREWELL_US: u64 = 1_000;

/// A link to boards that a program simulates in lockstep with the host.
///
/// The first reception at a later time makes an exchange, which waits for the program: up to 5 s
/// of real time for each byte. Such a link is for virtual time alone, where waiting changes
/// nothing; the rules of the tick concern links to real boards. A program that hangs, exits or
/// breaks the exchange is killed, and its link stays down.
#[derive(Debug)]
pub struct Lockstep {
    framing: Framing,
    program: LockedProgram,
}

impl Lockstep {
    /// Starts the program of `command`, which is split at white space, without a shell.
    ///
    /// # Errors
    /// If the clock is not virtual, or the program cannot be started.
    pub fn start(command: &str, clock: &HostClock) -> Result<Self, Error> {
        let program = LockedProgram::start(command, clock)
            .map_err(|why| Error::Program { command: command.to_owned(), why })?;
        Ok(Self { framing: Framing::default(), program })
    }
}

impl Link for Lockstep {
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError> {
        self.framing.around(&mut self.program).try_send(frame)
    }

    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        self.framing.around(&mut self.program).try_recv(buffer)
    }

    fn fault(&self) -> Option<&Error> {
        self.program.fault.as_ref()
    }

    fn try_send_damaged(&mut self, frame: &[u8]) -> Option<Result<(), SendError>> {
        Some(self.framing.around(&mut self.program).send_damaged(frame))
    }
}

#[derive(Debug)]
struct LockedProgram {
    command: String,
    clock: HostClock,
    child: Child,
    /// `None` once the program is to exit.
    stdin: Option<ChildStdin>,
    stdout: ChildStdout,
    patience_s: i64,
    lived_us: u64,
    /// Next message: room for time and number, then the sent bytes.
    message: Vec<u8>,
    received: VecDeque<u8>,
    fault: Option<Error>,
}

impl LockedProgram {
    fn start(command: &str, clock: &HostClock) -> Result<Self, ProgramTrouble> {
        if let HostClock::Monotonic(_) = clock {
            return Err(ProgramTrouble::RealTime);
        }
        let mut words = command.split_whitespace();
        let mut program = Command::new(words.next().unwrap_or_default());
        program.args(words).stdin(Stdio::piped()).stdout(Stdio::piped());
        // Ctrl-C ends the host, which lets the program end in order.
        program.process_group(0);
        let mut child = program.spawn().map_err(ProgramTrouble::NotStarted)?;
        let missing = || ProgramTrouble::Io(io::ErrorKind::BrokenPipe.into());
        let stdin = child.stdin.take().ok_or_else(missing)?;
        let stdout = child.stdout.take().ok_or_else(missing)?;
        let flags = fcntl_getfl(&stdin).map_err(io::Error::from)?;
        fcntl_setfl(&stdin, flags | OFlags::NONBLOCK).map_err(io::Error::from)?;
        Ok(Self {
            command: command.to_owned(),
            clock: clock.clone(),
            child,
            stdin: Some(stdin),
            stdout,
            patience_s: PATIENCE_S,
            lived_us: 0,
            message: vec![0; HEAD],
            received: VecDeque::new(),
            fault: None,
        })
    }

    /// Simulates up to `now_us`; the link is down for good if that fails.
    fn live(&mut self, now_us: u64) -> Result<(), RecvError> {
        self.exchange(now_us).map_err(|why| {
            let _gone = self.child.kill();
            self.fault = Some(Error::Program { command: self.command.clone(), why });
            RecvError::Down
        })
    }

    fn exchange(&mut self, now_us: u64) -> Result<(), ProgramTrouble> {
        if is_ready(&self.stdout, PollFlags::IN, 0)? {
            return Err(match self.read(&mut [0])? {
                0 => self.ended(),
                _ => ProgramTrouble::Unasked,
            });
        }
        self.send_message(now_us)?;
        let mut len = [0; 2];
        self.read_exact(&mut len)?;
        let mut bytes = vec![0; u16::from_le_bytes(len).into()];
        self.read_exact(&mut bytes)?;
        self.received.extend(bytes);
        self.lived_us = now_us;
        Ok(())
    }

    fn send_message(&mut self, now_us: u64) -> Result<(), ProgramTrouble> {
        // `try_send` accepts no more than the number can express.
        let len = u16::try_from(self.message.len() - HEAD).unwrap_or(u16::MAX);
        self.message[..8].copy_from_slice(&now_us.to_le_bytes());
        self.message[8..HEAD].copy_from_slice(&len.to_le_bytes());
        let Some(stdin) = &self.stdin else { return Ok(()) };
        let mut sent = 0;
        while sent < self.message.len() {
            match rustix::io::write(stdin, &self.message[sent..]) {
                Ok(n) => sent += n,
                Err(Errno::INTR) => {}
                Err(Errno::AGAIN) if is_ready(stdin, PollFlags::OUT, self.patience_s)? => {}
                Err(Errno::AGAIN) => return Err(ProgramTrouble::ReadsNothing),
                Err(Errno::PIPE) => return Err(self.ended()),
                Err(error) => return Err(ProgramTrouble::Io(error.into())),
            }
        }
        self.message.truncate(HEAD);
        Ok(())
    }

    /// Reads the announced bytes, as long as each arrives in time.
    fn read_exact(&mut self, bytes: &mut [u8]) -> Result<(), ProgramTrouble> {
        let (mut came, announced) = (0, bytes.len());
        while came < announced {
            if !is_ready(&self.stdout, PollFlags::IN, self.patience_s)? {
                return Err(ProgramTrouble::Silent { came, announced });
            }
            match self.read(&mut bytes[came..])? {
                0 => return Err(self.ended()),
                n => came += n,
            }
        }
        Ok(())
    }

    /// Reads from a program that has written, or is at its end.
    fn read(&self, bytes: &mut [u8]) -> io::Result<usize> {
        Ok(rustix::io::retry_on_intr(|| rustix::io::read(&self.stdout, &mut *bytes))?)
    }

    fn ended(&mut self) -> ProgramTrouble {
        self.wait().map_or_else(ProgramTrouble::Io, ProgramTrouble::Ended)
    }

    /// Waits until the program has exited; kills it if that takes too long.
    fn wait(&mut self) -> io::Result<ExitStatus> {
        self.stdin = None;
        for _ in 0..MAX_LOOKS {
            if let Some(status) = self.child.try_wait()? {
                return Ok(status);
            }
            pause(LOOK);
        }
        self.child.kill()?;
        self.child.wait()
    }
}

impl Link for LockedProgram {
    fn try_send(&mut self, bytes: &[u8]) -> Result<(), SendError> {
        if self.fault.is_some() {
            return Err(SendError::Down);
        }
        if HEAD + MAX_BYTES < self.message.len() + bytes.len() {
            return Err(SendError::Full);
        }
        self.message.extend_from_slice(bytes);
        Ok(())
    }

    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        if self.fault.is_some() {
            return Err(RecvError::Down);
        }
        let now_us = self.clock.now_us();
        // If the host does not read, the program waits, as on a full wire.
        if self.lived_us < now_us && self.received.len() < MAX_BYTES {
            self.live(now_us)?;
        }
        let len = self.received.read(buffer).unwrap_or_default();
        Ok((0 < len).then_some(len))
    }
}

impl Drop for LockedProgram {
    /// Sends the rest, closes stdin, and waits for the program to exit.
    fn drop(&mut self) {
        if self.fault.is_none() && HEAD < self.message.len() {
            let _last = self.live(self.lived_us + FAREWELL_US);
        }
        let _status = self.wait();
    }
}

/// Waits for up to `seconds` until a pipe can be read or written, or its other end is closed.
fn is_ready(pipe: &impl AsFd, flags: PollFlags, seconds: i64) -> io::Result<bool> {
    let limit = Timespec { tv_sec: seconds, tv_nsec: 0 };
    let mut pipes = [PollFd::new(pipe, flags)];
    Ok(0 < rustix::io::retry_on_intr(|| poll(&mut pipes, Some(&limit)))?)
}

#[cfg(test)]
mod tests;
