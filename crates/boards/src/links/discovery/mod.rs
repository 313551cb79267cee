//! Links of this machine to boards, obstacles to their use, and advice. Not for the tick.
//!
//! Reads system files and runs `ip`; opens no port, since that resets many boards. An [`Obstacle`]
//! keeps a device from being used; advice is for a usable one.

mod access;
mod can;
mod can_interface;
mod can_link;
mod diagnosis;
mod serial;
#[cfg(test)]
mod testing;

pub use crate::links::obstacle::Obstacle;
pub use can::can_interfaces;
pub(crate) use can::known_can_interfaces;
pub use can_interface::CanInterface;
pub use can_link::{BitTiming, CanLink};
pub use diagnosis::machine::{Fact, this_machine};
pub use diagnosis::usb::{UsbPlace, UsbSpeed};
pub use serial::{SerialPort, UsbIdentity, serial_ports};

#[cfg(unix)]
pub(crate) fn obstacle(path: &std::path::Path) -> Option<Obstacle> {
    access::User::current().obstacle(path)
}

/// Found devices, or the reason for their absence.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Listing<T> {
    /// In the order of names.
    pub found: Vec<T>,
    /// One sentence on why `found` is empty; none if it is not.
    pub why_empty: Option<String>,
}

impl<T> Listing<T> {
    fn new(found: Vec<T>, why_empty: &str) -> Self {
        let why_empty = found.is_empty().then(|| why_empty.to_owned());
        Self { found, why_empty }
    }
}
