//! Links: what carries bytes between the host and a board, without waiting.
//!
//! One `try_send` puts one frame on the wire, whole or not at all. What comes out of
//! `try_recv` may be a frame or a piece of a stream: the bus puts it together.

pub mod faulty;
pub mod loopback;

/// A transport that was opened before and never blocks.
pub trait Link {
    /// Hands over a frame.
    ///
    /// # Errors
    /// The frame was not taken, nor will be; the caller drops it and goes on.
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError>;

    /// Writes what has come into `buffer`; returns how much, or nothing if there is none.
    ///
    /// # Errors
    /// What had come is lost; the caller tries again in the next tick.
    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError>;
}

/// Why a frame was not taken.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SendError {
    /// The frame is longer than this link carries.
    TooLong {
        /// Its length [bytes].
        len: usize,
    },
    /// The other end is not there.
    Down,
}

/// Why nothing could be received.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RecvError {
    /// A frame is longer than the buffer, and lost.
    BufferTooShort {
        /// Its length [bytes].
        len: usize,
    },
    /// The other end is not there.
    Down,
}

/// A frame as it stands in a queue.
#[derive(Clone, Copy, Debug)]
struct Parcel {
    bytes: [u8; MAX_LEN],
    len: usize,
}

/// The longest frame that the links in memory carry [bytes].
pub const MAX_LEN: usize = firmware_protocol::serial::MAX_WIRE;

impl Parcel {
    const EMPTY: Self = Self { bytes: [0; MAX_LEN], len: 0 };

    /// A copy of `frame`.
    fn new(frame: &[u8]) -> Result<Self, SendError> {
        let mut parcel = Self { len: frame.len(), ..Self::EMPTY };
        let place = parcel.bytes.get_mut(..frame.len());
        place.ok_or(SendError::TooLong { len: frame.len() })?.copy_from_slice(frame);
        Ok(parcel)
    }

    fn as_slice(&self) -> &[u8] {
        &self.bytes[..self.len]
    }

    /// Copies the frame into `buffer`; returns its length.
    fn unpack(&self, buffer: &mut [u8]) -> Result<usize, RecvError> {
        let place = buffer.get_mut(..self.len);
        place.ok_or(RecvError::BufferTooShort { len: self.len })?.copy_from_slice(self.as_slice());
        Ok(self.len)
    }
}
