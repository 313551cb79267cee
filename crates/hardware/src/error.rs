//! What can be wrong at set-up, as sentences for the operator.

use std::io;
use std::path::PathBuf;

use crate::link::trouble::{CanTrouble, PortTrouble};

/// Why something could not be set up.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The tick's period is not one that boards can keep.
    #[error("a tick of {period} s is not possible; give a period above 0 and up to 1 s")]
    Period {
        /// What was asked for (s).
        period: f64,
    },
    /// A serial port could not be opened.
    #[error("the serial port {path} cannot be opened: {why}")]
    Port {
        path: PathBuf,
        /// What is wrong, and what to do.
        why: PortTrouble,
    },
    /// The system gave no thread.
    #[error("the system gives no thread: {0}; see its limit of processes: ulimit -u")]
    Thread(io::Error),
    /// The system gave no pseudo-terminal.
    #[error("the system gives no pseudo-terminal: {0}; see that /dev/pts is there")]
    Pty(io::Error),
    /// A CAN interface could not be opened.
    #[error("the CAN interface {interface} cannot be opened: {why}")]
    Can {
        interface: String,
        /// What is wrong, and what to do.
        why: CanTrouble,
    },
    /// A board cannot carry these keys.
    #[error(
        "a board of {n_keys} keys from key {first} on is not possible; \
         give 1 to 12 keys, all within the 88"
    )]
    BoardKeys {
        /// The first, `0 ..= 87`.
        first: u8,
        n_keys: usize,
    },
    /// A file could not be written.
    #[error("{path} cannot be written: {source}; see to the folder and its rights")]
    Unwritable { path: PathBuf, source: io::Error },
    /// The system refused to list its serial ports.
    #[error("the system does not list its serial ports: {0}; name one: serial:/dev/ttyACM0")]
    SerialPorts(#[from] serialport::Error),
    /// A folder or file of the system could not be read.
    #[error("{path} cannot be read: {source}; see to its rights")]
    Unreadable { path: PathBuf, source: io::Error },
}
