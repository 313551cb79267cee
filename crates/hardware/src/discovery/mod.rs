//! What this machine has to reach boards with, why it cannot be used, and what to change.
//!
//! Reads files of the system and asks `ip`; opens no port: opening one resets many boards.
//! An [`Obstacle`] keeps a device from being used; advice is for one that can be.
//! Not for the tick.

mod access;
mod can;
mod doctor;
mod serial;
#[cfg(test)]
mod testing;

use std::fmt;
use std::path::PathBuf;

pub(crate) use can::known_can_interfaces;
pub use can::{CanInterface, can_interfaces};
pub use doctor::can_link::{BitTiming, CanLink};
pub use doctor::machine::{Fact, this_machine};
pub use doctor::usb::{UsbPlace, UsbSpeed};
pub use serial::{SerialPort, UsbIdentity, serial_ports};

/// Why the user of this process cannot use the device at `path`, if that can be told.
#[cfg(unix)]
pub(crate) fn obstacle(path: &std::path::Path) -> Option<Obstacle> {
    access::User::current().obstacle(path)
}

/// What was found, or why there is nothing.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Listing<T> {
    /// What was found, in the order of names.
    pub found: Vec<T>,
    /// One sentence on why `found` is empty; none if it is not.
    pub why_empty: Option<String>,
}

impl<T> Listing<T> {
    /// A list, or `why_empty` if there is nothing in it.
    fn new(found: Vec<T>, why_empty: &str) -> Self {
        let why_empty = found.is_empty().then(|| why_empty.to_owned());
        Self { found, why_empty }
    }
}

/// Why something that is there cannot be used; a sentence when displayed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Obstacle {
    /// The user may not read and write the device.
    Forbidden {
        path: PathBuf,
        /// The group that may, if a group may.
        group: Option<String>,
    },
    /// The interface is down.
    Down {
        /// What brings it up.
        command: String,
    },
    /// The interface is up, but carries no frames.
    NotRunning { name: String },
}

impl fmt::Display for Obstacle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Forbidden { path, group: Some(group) } => write!(
                f,
                "you may not read and write {}; join the group {group}: \
                 sudo usermod -aG {group} $USER, then log in again",
                path.display()
            ),
            Self::Forbidden { path, group: None } => {
                write!(f, "you may not read and write {}; only its owner may", path.display())
            }
            Self::Down { command } => write!(f, "the interface is down; bring it up: {command}"),
            Self::NotRunning { name } => write!(
                f,
                "{name} is up but carries no frames; see its state: \
                 ip -details link show {name}"
            ),
        }
    }
}
