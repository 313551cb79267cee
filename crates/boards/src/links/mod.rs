//! Links carry frames between the host and boards, without waiting.
//!
//! One `try_send` puts one frame of the protocol on the wire, whole or not at all; one
//! `try_recv` returns one. [`framed`] makes a link of a carrier of bytes.
//!
//! | module | contents |
//! |---|---|
//! | [`serial`], [`can`] | real links, opened by an [`address`] |
//! | [`loopback`] | a wire in memory |
//! | [`framed`] | frames on a stream of bytes |
//! | [`reconnecting`] | a link that is reopened when it comes back |
//! | [`lockstep`] | a program that simulates boards, in virtual time |
//! | [`faulty`], [`wire`] | frames and bytes that are lost, late or damaged on demand |
//! | [`discovery`] | the ports and interfaces of this machine, and obstacles to their use |
//!
//! Not here: the meaning of frames, keys, forces.

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

pub static LINKS: &[BoardLinkKind] = &[serial::KIND, can::FD, can::CLASSIC, lockstep::KIND];

/// End of a link; a bus delivers only the frames for that end.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BusSide {
    /// Receives the frames of boards.
    Host,
    /// Receives the frames for this board and for all boards.
    Board(BoardId),
}

/// An open transport that never blocks, except for those of [`lockstep`].
pub trait Link {
    /// Sends a frame.
    ///
    /// # Errors
    /// The link rejected the frame and does not retry. The caller drops it.
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError>;

    /// Writes the next frame into `buffer`; returns its length, or `None` without a frame.
    ///
    /// # Errors
    /// The received bytes are lost; the caller continues.
    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError>;

    /// Returns the wire's own reports of its condition; the default if it has none.
    fn health(&self) -> Health {
        Health::default()
    }

    fn fault(&self) -> Option<&Error> {
        None
    }

    /// Sends `frame` with a wrong checksum; `None` on a link whose hardware makes the checksums.
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

/// Reason why a frame was rejected.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SendError {
    /// The frame is longer than this link carries.
    TooLong {
        len: usize,
    },
    /// There is no room: earlier frames are still on their way.
    Full,
    Down,
}

/// Reason for a failed reception.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RecvError {
    /// A frame is longer than the buffer, and lost.
    BufferTooShort {
        len: usize,
    },
    /// The bytes were no frame: checksum, stuffing, length, a lost piece, or a wrong identifier.
    Corrupt,
    Down,
}

/// Condition of a wire, from its controller and driver.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Health {
    /// Participation of its controller in the traffic.
    pub state: WireState,
    /// Transmission errors, which the controller counts up and down.
    pub transmit_errors: u8,
    pub receive_errors: u8,
    pub reports: u64,
    /// Restarts of the controller after it had left the bus.
    pub restarts: u64,
    /// Frames that the host dropped because earlier ones were on their way, or for lack of room.
    pub dropped: u64,
}

/// State of a controller on its wire.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default)]
pub enum WireState {
    #[default]
    Active,
    /// It has counted many errors.
    Warning,
    /// It may not signal errors any more.
    Passive,
    /// It has left the bus.
    Off,
}
