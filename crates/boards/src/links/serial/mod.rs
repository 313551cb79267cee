//! Serial ports: USB, UART and pseudo-terminals, with frames on their bytes.
//!
//! The `serialport` crate sets a port up and locks out other programs. Its reads and writes wait,
//! so a second, non-blocking descriptor carries the bytes.

mod carrier;
mod pty;
mod stream;

use std::{path::Path, time::Duration};

use rustix::fd::OwnedFd;
use rustix::fs::{Mode, OFlags};
use serialport::{ClearBuffer, ErrorKind, SerialPort as _, TTYPort};

use self::carrier::SerialCarrier;
use super::address::BoardLinkKind;
use super::framed::Framing;
use super::trouble::PortTrouble;
use super::{Health, Link, RecvError, SendError};
use crate::links::Error;
use crate::plan::{Medium, NoPlan, uart::Wiring};

pub use pty::Pty;
pub(super) use pty::PtyPair;
pub(super) use stream::{Disconnected, NonBlockingFd};

/// USB devices ignore the baud rate.
pub const KIND: BoardLinkKind = BoardLinkKind {
    scheme: "serial",
    forms: "serial:PORT, serial:PORT@BAUD",
    help: "serial:PORT[@BAUD]",
    key: "serial",
    mode: None,
    options: &["baud"],
    noun: "serial",
    subject: "a serial port",
    baud: Some(2_000_000),
    is_in_lockstep: false,
    open: |address, _side, _clock| {
        let baud = address.baud.unwrap_or_default();
        Ok(Box::new(Serial::open(Path::new(&address.place), baud)?))
    },
    medium: |address, _rates| medium(Path::new(&address.place), address.baud.unwrap_or_default()),
};

/// Prefixes of the names of serial ports whose bits take time on a wire.
const UARTS: [&str; 7] = ["ttyS", "ttyUSB", "ttyAMA", "ttyO", "ttyTHS", "ttymxc", "cu.usbserial"];

/// Returns the medium of a UART. USB devices and pseudo-terminals accept and ignore any baud rate.
fn medium(port: &Path, baud: u32) -> Result<Medium, NoPlan> {
    let device = std::fs::canonicalize(port).unwrap_or_else(|_absent| port.to_owned());
    let name = device.file_name().map(|it| it.to_string_lossy().into_owned()).unwrap_or_default();
    let is_uart = UARTS.iter().any(|start| name.starts_with(start));
    is_uart.then_some(Medium::Uart { baud, wiring: Wiring::FullDuplex }).ok_or(NoPlan::NoRates)
}

/// An open serial port, which never waits. Stays down after its other end was, until reopened.
#[derive(Debug)]
pub struct Serial {
    framing: Framing,
    carrier: SerialCarrier,
    _keeper: Keeper,
}

#[derive(Debug)]
#[expect(dead_code, reason = "held, never read")]
enum Keeper {
    Port(TTYPort),
    /// The other end of a pseudo-terminal, which keeps the terminal alive between two clients.
    OtherEnd(OwnedFd),
}

impl Serial {
    /// Opens the port at `path` with `baud` bits per second, for this program alone.
    ///
    /// Discards the bytes that were received before. A pseudo-terminal ignores `baud`.
    pub fn open(path: &Path, baud: u32) -> Result<Self, Error> {
        let refused = |why| Error::Port { path: path.to_owned(), why };
        let (port, stream) = open(path, baud).map_err(|error| refused(trouble(path, error)))?;
        ask_for_low_latency(path);
        Ok(Self::new(stream, Keeper::Port(port)))
    }

    fn new(stream: NonBlockingFd, keeper: Keeper) -> Self {
        let (framing, carrier) = (Framing::default(), SerialCarrier::new(stream));
        Self { framing, carrier, _keeper: keeper }
    }

    pub const fn dropped(&self) -> u64 {
        self.carrier.dropped()
    }
}

/// # Real-time
/// At most two system calls to send, three per 68 received bytes; none waits. No heap.
impl Link for Serial {
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError> {
        self.framing.around(&mut self.carrier).try_send(frame)
    }

    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        self.framing.around(&mut self.carrier).try_recv(buffer)
    }

    fn health(&self) -> Health {
        Health { dropped: self.carrier.dropped(), ..Health::default() }
    }

    fn try_send_damaged(&mut self, frame: &[u8]) -> Option<Result<(), SendError>> {
        Some(self.framing.around(&mut self.carrier).send_damaged(frame))
    }
}

/// Opens a port twice: to set it up, and for the bytes.
///
/// A locked port cannot be opened again, so the exclusive lock comes last. A shared lock keeps out
/// other programs until then.
fn open(path: &Path, baud: u32) -> serialport::Result<(TTYPort, NonBlockingFd)> {
    let settings =
        serialport::new(path.to_string_lossy(), baud).exclusive(false).timeout(Duration::ZERO);
    let mut port = TTYPort::open(&settings)?;
    let flags = OFlags::RDWR | OFlags::NOCTTY | OFlags::NONBLOCK | OFlags::CLOEXEC;
    let bytes = rustix::fs::open(path, flags, Mode::empty()).map_err(std::io::Error::from)?;
    port.set_exclusive(true)?;
    port.clear(ClearBuffer::All)?;
    Ok((port, NonBlockingFd::new(bytes)))
}

fn trouble(path: &Path, error: serialport::Error) -> PortTrouble {
    use std::io::ErrorKind as Io;

    match error.kind() {
        ErrorKind::NoDevice | ErrorKind::Io(Io::ResourceBusy) => {
            PortTrouble::Busy { path: path.to_owned() }
        }
        ErrorKind::Io(Io::NotFound) => PortTrouble::Missing,
        ErrorKind::Io(Io::PermissionDenied) => crate::links::discovery::obstacle(path)
            .map_or_else(|| PortTrouble::Refused { path: path.to_owned() }, PortTrouble::Forbidden),
        ErrorKind::Io(_) | ErrorKind::InvalidInput | ErrorKind::Unknown => {
            PortTrouble::Unfit(error.into())
        }
    }
}

/// Asks an FTDI adapter to delay bytes by 1 ms instead of 16 ms, if there is one that may be asked.
fn ask_for_low_latency(path: &Path) {
    let device = std::fs::canonicalize(path).unwrap_or_else(|_unresolved| path.to_owned());
    let Some(name) = device.file_name() else { return };
    let timer = Path::new("/sys/class/tty").join(name).join("device/latency_timer");
    if timer.exists() {
        let _not_allowed = std::fs::write(timer, "1");
    }
}

#[cfg(test)]
mod tests;
