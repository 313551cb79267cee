//! Where a link leads: what a scene or the command line says, and how it is opened.

use std::fmt;
use std::path::PathBuf;

use super::Link;
use super::can::{BusSide, Can, CanMode};
use crate::links::{Error, HostClock};

/// Bits per second of a serial port of which nothing is said; USB devices ignore it.
pub const BAUD: u32 = 2_000_000;

/// Where a link leads.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Address {
    Serial {
        port: PathBuf,
        baud: u32,
    },
    Can {
        interface: String,
        mode: CanMode,
    },
    /// A program in lockstep, with its arguments behind it; see `lockstep`.
    Rig {
        command: String,
    },
}

impl Address {
    /// Reads `serial:/dev/ttyACM0`, `serial:/dev/ttyUSB0@1000000`, `can:can0`,
    /// `classic-can:can0`, or `rig:PROGRAM ARGUMENTS`, split at white space.
    ///
    /// # Errors
    /// A sentence on what is wrong, and what to write.
    pub fn parse(text: &str) -> Result<Self, String> {
        const KINDS: &str = "write serial:PORT, serial:PORT@BAUD, can:INTERFACE, \
                             classic-can:INTERFACE or rig:PROGRAM";
        let unknown = || format!("\"{text}\" is no link: {KINDS}");
        let (kind, rest) = text.split_once(':').ok_or_else(unknown)?;
        let interface = rest.to_owned();
        match kind {
            _ if rest.trim().is_empty() => Err(unknown()),
            "serial" => serial(rest),
            "can" => Ok(Self::Can { interface, mode: CanMode::Fd }),
            "classic-can" => Ok(Self::Can { interface, mode: CanMode::Classic }),
            "rig" => Ok(Self::Rig { command: rest.trim().to_owned() }),
            _ => Err(unknown()),
        }
    }

    /// Returns what it is called in sentences: the port, the interface, or the program.
    pub fn name(&self) -> String {
        match self {
            Self::Serial { port, .. } => port.display().to_string(),
            Self::Can { interface, .. } => interface.clone(),
            Self::Rig { command } => command.clone(),
        }
    }

    /// Returns what is typed for it in a shell: in quotes if it has several words.
    pub fn typed(&self) -> String {
        let text = self.to_string();
        if text.contains(char::is_whitespace) { format!("'{text}'") } else { text }
    }

    /// Returns whether it leads to a program in lockstep, which lives in virtual time only.
    pub const fn is_in_lockstep(&self) -> bool {
        match self {
            Self::Rig { .. } => true,
            Self::Serial { .. } | Self::Can { .. } => false,
        }
    }

    /// Opens it for one end, which lives by `clock`.
    ///
    /// # Errors
    /// Says what is wrong with the port, interface or program, and what to do.
    pub fn open(&self, side: BusSide, clock: &HostClock) -> Result<Box<dyn Link + Send>, Error> {
        match self {
            Self::Serial { port, baud } => open_serial(port, *baud),
            Self::Can { interface, mode } => Ok(Box::new(Can::open(interface, *mode, side)?)),
            Self::Rig { command } => start(command, clock),
        }
    }
}

#[cfg(unix)]
fn open_serial(port: &std::path::Path, baud: u32) -> Result<Box<dyn Link + Send>, Error> {
    Ok(Box::new(super::serial::Serial::open(port, baud)?))
}

#[cfg(not(unix))]
fn open_serial(port: &std::path::Path, _baud: u32) -> Result<Box<dyn Link + Send>, Error> {
    let source = std::io::Error::from(std::io::ErrorKind::Unsupported);
    Err(Error::Unreadable { path: port.to_owned(), source })
}

#[cfg(unix)]
fn start(command: &str, clock: &HostClock) -> Result<Box<dyn Link + Send>, Error> {
    Ok(Box::new(super::lockstep::Lockstep::start(command, clock)?))
}

#[cfg(not(unix))]
fn start(command: &str, _clock: &HostClock) -> Result<Box<dyn Link + Send>, Error> {
    let why = std::io::Error::from(std::io::ErrorKind::Unsupported);
    let why = super::trouble::ProgramTrouble::NotStarted(why);
    Err(Error::Program { command: command.to_owned(), why })
}

fn serial(rest: &str) -> Result<Address, String> {
    let (port, baud) = match rest.rsplit_once('@') {
        None => (rest, BAUD),
        Some((port, baud)) => {
            let number = baud.parse().ok().filter(|baud| *baud != 0);
            (port, number.ok_or_else(|| format!("\"{baud}\" is no baud rate: write 2000000"))?)
        }
    };
    Ok(Address::Serial { port: port.into(), baud })
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Serial { port, baud } => write!(f, "serial:{}@{baud}", port.display()),
            Self::Can { interface, mode: CanMode::Fd } => write!(f, "can:{interface}"),
            Self::Can { interface, mode: CanMode::Classic } => {
                write!(f, "classic-can:{interface}")
            }
            Self::Rig { command } => write!(f, "rig:{command}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_address_reads_as_it_is_written() {
        let rig = "rig:./rig --fault half";
        for text in ["serial:/dev/ttyUSB0@1000000", "can:can0", "classic-can:vcan1", rig] {
            assert_eq!(Address::parse(text).unwrap().to_string(), text);
        }
        let usual = Address::parse("serial:/dev/ttyACM0").unwrap();
        assert_eq!(usual, Address::Serial { port: "/dev/ttyACM0".into(), baud: BAUD });
    }

    #[test]
    fn what_is_no_address_says_what_to_write() {
        for text in ["", "can", "can:", "usb:1", "serial:/dev/x@fast", "serial:/dev/x@0", "rig: "] {
            assert!(Address::parse(text).unwrap_err().contains("write"), "{text}");
        }
    }
}
