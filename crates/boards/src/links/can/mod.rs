//! CAN: the protocol's frames on a bus that several boards share.
//!
//! On CAN FD a frame of the protocol is one frame of the bus, padded to a valid length; on classic
//! CAN it travels in pieces. All but the socket is plain arithmetic without an operating system.

mod bus;
mod classic;
mod filter;
mod health;
mod open;
mod port;
#[cfg(target_os = "linux")]
mod socket;

#[cfg(target_os = "linux")]
use self::{port::CanPort, socket::Socket};
use super::{BusSide, Health, Link, RecvError, SendError, address::BoardLinkKind};
use crate::links::Error;
use crate::plan::{Medium, NoPlan};

pub const FD: BoardLinkKind = BoardLinkKind {
    scheme: "can",
    forms: "can:INTERFACE",
    help: "can:INTERFACE",
    key: "can",
    mode: Some("fd"),
    options: &["mode", "bit_rate", "data_bit_rate"],
    noun: "CAN",
    subject: "a CAN bus",
    baud: None,
    is_in_lockstep: false,
    open: |address, side, _clock| Ok(Box::new(Can::open(&address.place, CanMode::Fd, side)?)),
    medium: |address, (nominal, data)| medium(&address.place, Medium::CanFd { nominal, data }),
};

pub const CLASSIC: BoardLinkKind = BoardLinkKind {
    scheme: "classic-can",
    forms: "classic-can:INTERFACE",
    help: "classic-can:INTERFACE",
    mode: Some("classic"),
    options: &["mode", "bit_rate"],
    subject: "classic CAN",
    open: |address, side, _clock| Ok(Box::new(Can::open(&address.place, CanMode::Classic, side)?)),
    medium: |address, (bitrate, _)| medium(&address.place, Medium::ClassicCan { bitrate }),
    ..FD
};

/// Returns `real` for a controller; a virtual interface takes no time.
fn medium(interface: &str, real: Medium) -> Result<Medium, NoPlan> {
    let is_virtual = ["vcan", "vxcan"].iter().any(|start| interface.starts_with(start));
    if is_virtual { Err(NoPlan::Virtual) } else { Ok(real) }
}

/// Kind of frames on a bus.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CanMode {
    /// CAN FD with a second, faster bit rate: up to 64 bytes in a frame.
    Fd,
    /// Classic CAN: eight bytes.
    Classic,
}

/// An open CAN interface, which never waits.
///
/// Frames outside of the protocol have no identifier: they are [`SendError::TooLong`], whatever
/// their length. On CAN FD a frame arrives with its padding zeros.
///
/// An interface that is down works again when it is up; one that was removed must be reopened.
#[derive(Debug)]
pub struct Can {
    #[cfg(target_os = "linux")]
    port: CanPort<Socket>,
    #[cfg(not(target_os = "linux"))]
    port: std::convert::Infallible,
}

#[cfg(target_os = "linux")]
impl Can {
    pub fn open(interface: &str, mode: CanMode, side: BusSide) -> Result<Self, Error> {
        let refused = |why| Error::Can { interface: interface.to_owned(), why };
        open::check(interface, mode).map_err(refused)?;
        let socket =
            Socket::open(interface, mode, side).map_err(|error| refused(open::trouble(error)))?;
        Ok(Self { port: CanPort::new(socket, mode) })
    }

    pub const fn dropped(&self) -> u64 {
        self.port.dropped()
    }
}

/// # Real-time
/// A frame sent costs up to ten system calls, a reception up to 256; none waits. No heap.
#[cfg(target_os = "linux")]
impl Link for Can {
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError> {
        self.port.try_send(frame)
    }

    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        self.port.try_recv(buffer)
    }

    fn health(&self) -> Health {
        Health { dropped: self.port.dropped(), ..self.port.health() }
    }
}

#[cfg(not(target_os = "linux"))]
impl Can {
    /// Fails: CAN requires Linux.
    pub fn open(interface: &str, _mode: CanMode, _side: BusSide) -> Result<Self, Error> {
        let why = super::trouble::CanTrouble::NotLinux;
        Err(Error::Can { interface: interface.to_owned(), why })
    }

    pub const fn dropped(&self) -> u64 {
        match self.port {}
    }
}

#[cfg(not(target_os = "linux"))]
impl Link for Can {
    fn try_send(&mut self, _frame: &[u8]) -> Result<(), SendError> {
        match self.port {}
    }

    fn try_recv(&mut self, _buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        match self.port {}
    }

    fn health(&self) -> Health {
        match self.port {}
    }
}
