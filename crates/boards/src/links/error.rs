use std::{io, path::PathBuf};

use crate::links::trouble::{CanTrouble, PortTrouble, ProgramTrouble};

/// Reason why a link could not be set up; a sentence for the operator.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error("the serial port {path} cannot be opened: {why}")]
    Port { path: PathBuf, why: PortTrouble },
    #[error("the CAN interface {interface} cannot be opened: {why}")]
    Can { interface: String, why: CanTrouble },
    #[error("the program `{command}` cannot be used in lockstep: {why}")]
    Program { command: String, why: ProgramTrouble },
    #[error("the system gives no thread: {0}; see its limit of processes: ulimit -u")]
    Thread(io::Error),
    #[error("the system gives no pseudo-terminal: {0}; see that /dev/pts is there")]
    Pty(io::Error),
    #[error("the system does not list its serial ports: {0}; name one: serial:/dev/ttyACM0")]
    SerialPorts(#[from] serialport::Error),
    #[error("{path} cannot be read: {source}; see to its rights")]
    Unreadable { path: PathBuf, source: io::Error },
}
