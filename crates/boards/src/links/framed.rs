//! Frames on a stream of bytes: COBS, a checksum, and a zero at the end.

use firmware_protocol::serial::{self, Deframer, MAX_WIRE};

use super::{Health, Link, RecvError, SendError};

/// Pieces to read from the stream for one frame; the rest waits for the next call.
const MAX_PIECES: usize = 64;

/// State of a stream between two calls.
#[derive(Clone, Debug)]
pub struct Framing {
    deframer: Deframer,
    piece: [u8; MAX_WIRE],
    /// The unread range of `piece`.
    rest: std::ops::Range<usize>,
}

impl Default for Framing {
    fn default() -> Self {
        Self { deframer: Deframer::default(), piece: [0; MAX_WIRE], rest: 0..0 }
    }
}

impl Framing {
    /// Drops an incomplete frame, as after the stream was reopened.
    pub fn forget(&mut self) {
        *self = Self::default();
    }

    /// Adds frames to `bytes`, which carries any pieces of a stream.
    pub const fn around<L: Link>(&mut self, bytes: L) -> Framed<'_, L> {
        Framed { framing: self, bytes }
    }

    /// Continues reading the piece; returns the outcome of the frame that it ends, if any.
    fn read(&mut self, buffer: &mut [u8]) -> Option<Result<usize, RecvError>> {
        for place in self.rest.by_ref() {
            if let Some(outcome) = self.deframer.push(self.piece[place]) {
                return Some(
                    outcome
                        .map_err(|_framing| RecvError::Corrupt)
                        .and_then(|frame| copy(frame, buffer)),
                );
            }
        }
        None
    }
}

fn copy(frame: &[u8], buffer: &mut [u8]) -> Result<usize, RecvError> {
    let len = frame.len();
    let room = buffer.get_mut(..len).ok_or(RecvError::BufferTooShort { len })?;
    room.copy_from_slice(frame);
    Ok(len)
}

/// A link over a carrier of bytes.
#[derive(Debug)]
pub struct Framed<'a, L> {
    framing: &'a mut Framing,
    bytes: L,
}

impl<L: Link> Framed<'_, L> {
    /// Sends `frame` with a wrong checksum, by an inverted bit in its second byte.
    ///
    /// The first three bytes of `frame` must not be zero: stuffing moves zeros on the stream.
    pub(super) fn send_damaged(&mut self, frame: &[u8]) -> Result<(), SendError> {
        let (mut wire, len) = wire(frame)?;
        // The byte stuffing puts one byte before the frame.
        wire[2] ^= 0x40;
        self.bytes.try_send(&wire[..len])
    }
}

/// Returns a frame as it travels on the stream, and its length there.
fn wire(frame: &[u8]) -> Result<([u8; MAX_WIRE], usize), SendError> {
    let mut wire = [0; MAX_WIRE];
    let len = serial::encode(frame, &mut wire)
        .map_err(|serial::TooLong { len }| SendError::TooLong { len })?;
    Ok((wire, len))
}

impl<L: Link> Link for Framed<'_, L> {
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError> {
        let (wire, len) = wire(frame)?;
        self.bytes.try_send(&wire[..len])
    }

    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        for _ in 0..MAX_PIECES {
            if let Some(outcome) = self.framing.read(buffer) {
                return outcome.map(Some);
            }
            let Some(len) = self.bytes.try_recv(&mut self.framing.piece)? else {
                return Ok(None);
            };
            self.framing.rest = 0..len.min(MAX_WIRE);
        }
        Ok(None)
    }

    fn health(&self) -> Health {
        self.bytes.health()
    }
}
