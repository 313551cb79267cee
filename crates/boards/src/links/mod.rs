//! Links: what carries frames between the host and boards, without waiting.
//!
//! One `try_send` puts one frame of the protocol on the wire, whole or not at all; one
//! `try_recv` brings one. What carries bytes only becomes a link by [`framed`].
//!
//! | module | what stands there |
//! |---|---|
//! | [`serial`], [`can`] | the real ones, opened by an [`address`] |
//! | [`loopback`] | a wire in memory |
//! | [`framed`] | frames on a stream of bytes |
//! | [`reconnecting`] | a link that is opened again when it comes back |
//! | [`lockstep`] | a program that lives boards, in virtual time |
//! | [`faulty`], [`wire`] | frames and bytes that are lost, late or damaged on demand |
//! | [`discovery`] | the ports and interfaces that this machine has, and why they cannot be used |
//!
//! Not here: what frames mean, keys, forces.

pub mod address;
pub mod can;
mod clock;
pub mod discovery;
mod error;
pub mod faulty;
pub mod framed;
pub mod lockstep;
pub mod loopback;
mod obstacle;
mod pause;
mod queued_frame;
pub mod random;
pub mod reconnecting;
pub mod serial;
pub mod trouble;
pub mod wire;

pub use clock::HostClock;
pub use error::Error;
pub use pause::pause;
pub use queued_frame::MAX_LEN;

use address::BoardLinkKind;
use firmware_protocol::key::BoardId;
use queued_frame::QueuedFrame;

/// All kinds of links that an address can name.
pub static LINKS: &[BoardLinkKind] = &[serial::KIND, can::FD, can::CLASSIC, lockstep::KIND];

/// Which end of a link this is; a bus passes on only what is for it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BusSide {
    /// The host: hears what boards say.
    Host,
    /// A board: hears what is for it and for all boards.
    Board(BoardId),
}

/// A transport that was opened before and never blocks, but for those of [`lockstep`].
pub trait Link {
    /// Hands over a frame.
    ///
    /// # Errors
    /// The frame was not taken, nor will be; the caller drops it and goes on.
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError>;

    /// Writes the next frame into `buffer`; returns its length, or nothing if there is none.
    ///
    /// # Errors
    /// What had come is lost; the caller goes on.
    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError>;

    /// Returns what the wire itself has said of its condition; nothing if it never says anything.
    fn health(&self) -> Health {
        Health::default()
    }

    /// Returns why the link is down for good, if it is.
    fn fault(&self) -> Option<&Error> {
        None
    }

    /// Sends `frame` with a wrong checksum; `None` on a link whose checksums are not ours.
    fn try_send_damaged(&mut self, _frame: &[u8]) -> Option<Result<(), SendError>> {
        None
    }
}

impl<L: Link + ?Sized> Link for &mut L {
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError> {
        (**self).try_send(frame)
    }

    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        (**self).try_recv(buffer)
    }

    fn health(&self) -> Health {
        (**self).health()
    }

    fn fault(&self) -> Option<&Error> {
        (**self).fault()
    }

    fn try_send_damaged(&mut self, frame: &[u8]) -> Option<Result<(), SendError>> {
        (**self).try_send_damaged(frame)
    }
}

impl<L: Link + ?Sized> Link for Box<L> {
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError> {
        (**self).try_send(frame)
    }

    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        (**self).try_recv(buffer)
    }

    fn health(&self) -> Health {
        (**self).health()
    }

    fn fault(&self) -> Option<&Error> {
        (**self).fault()
    }

    fn try_send_damaged(&mut self, frame: &[u8]) -> Option<Result<(), SendError>> {
        (**self).try_send_damaged(frame)
    }
}

/// Why a frame was not taken.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SendError {
    /// The frame is longer than this link carries.
    TooLong {
        /// Length of the frame (bytes).
        len: usize,
    },
    /// There is no room: what was sent before is still on its way.
    Full,
    /// The other end is not there.
    Down,
}

/// Why nothing could be received.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RecvError {
    /// A frame is longer than the buffer, and lost.
    BufferTooShort {
        /// Length of the frame (bytes).
        len: usize,
    },
    /// Something came that was no frame: checksum, stuffing, length, a lost piece, or an
    /// identifier that does not agree.
    Corrupt,
    /// The other end is not there.
    Down,
}

/// The condition of a wire, as its controller and driver tell it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Health {
    /// Whether its controller takes part in the traffic.
    pub state: WireState,
    /// Transmission errors, as the controller counts them up and down.
    pub transmit_errors: u8,
    pub receive_errors: u8,
    /// Reports of errors that came.
    pub reports: u64,
    /// Times that the controller was started again after it had left the bus.
    pub restarts: u64,
    /// Frames that were dropped here, because those before were still on their way or found no
    /// room.
    pub dropped: u64,
}

/// What a controller does.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub enum WireState {
    #[default]
    Active,
    /// It has counted many errors.
    Warning,
    /// It may not complain any more.
    Passive,
    /// It has left the bus.
    Off,
}
