//! Reasons why a link cannot be used: the fault and its remedy.

use std::{io, path::PathBuf, process::ExitStatus};

use crate::links::obstacle::Obstacle;

/// Reason why a serial port could not be opened.
#[derive(Debug, thiserror::Error)]
pub enum PortTrouble {
    #[error("it is not there; plug the board in, `letoff devices` lists the ports there are")]
    Missing,
    #[error("{0}")]
    Forbidden(Obstacle),
    #[error("the system does not allow it; see its rights: ls -l {path}")]
    Refused { path: PathBuf },
    #[error("another program has it open; see which one: fuser -v {path}")]
    Busy { path: PathBuf },
    #[error("it does not work as a serial port: {0}; `letoff devices` says what is behind each")]
    Unfit(io::Error),
}

/// Reason why a CAN interface could not be opened.
#[derive(Debug, thiserror::Error)]
pub enum CanTrouble {
    #[error("CAN is for Linux, as SocketCAN; connect the boards by serial ports")]
    NotLinux,
    #[error("there is no CAN interface of that name; {there_are}")]
    Missing {
        /// List of the interfaces, or the reason why there is none.
        there_are: String,
    },
    #[error("{0}")]
    Down(Obstacle),
    #[error("it is not set up for CAN FD (MTU 16); do that: {command}; or use classic CAN")]
    NoFd { command: String },
    #[error(
        "this process may not open CAN sockets; a container or a security policy keeps it from \
         the address family AF_CAN: allow it there, or run outside"
    )]
    Forbidden,
    #[error("this kernel has no CAN sockets; load them: sudo modprobe can-raw")]
    NoSockets,
    #[error("{0}; `letoff devices` says how it is set up")]
    Other(io::Error),
}

/// Reason why a program cannot be used in lockstep.
#[derive(Debug, thiserror::Error)]
pub enum ProgramTrouble {
    #[error(
        "it lives in virtual time only; give --virtual-time to a run, and no other kind of link"
    )]
    RealTime,
    #[error("it cannot be started: {0}; give the path of a program, then its arguments")]
    NotStarted(io::Error),
    #[error("it ended ({0}) while the host still needed it; see what it wrote on stderr")]
    Ended(ExitStatus),
    #[error(
        "within 5 s {came} of {announced} bytes of its answer came; see that it answers every \
         exchange with two bytes of length and so many more, and flushes its stdout"
    )]
    Silent { came: usize, announced: usize },
    #[error("it read nothing for 5 s; see that it reads every exchange from its stdin")]
    ReadsNothing,
    #[error(
        "it wrote more than an answer; see that it writes nothing else on its stdout, and messages \
         on its stderr"
    )]
    Unasked,
    #[error("the system refused to exchange bytes with it: {0}; start it by hand to see why")]
    Io(#[from] io::Error),
}
