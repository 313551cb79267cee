//! Frames on a byte stream.
//!
//! ```text
//! frame ++ CRC (2 bytes, little-endian)  →  COBS: no zero inside  →  0x00
//! ```
//!
//! A receiver that joins in the middle, or has lost bytes, is in step again after the next zero.

mod cobs;
mod crc;

pub use crate::MAX_FRAME;
/// Length of the longest frame on the stream: checksum, one byte of stuffing, closing zero (bytes).
pub const MAX_WIRE: usize = MAX_FRAME + crc::LEN + cobs::OVERHEAD + 1;

const END: u8 = 0;

/// A frame that is longer than [`MAX_FRAME`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TooLong {
    pub len: usize,
}

/// Reason why the bytes between two zeros are not a frame.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FramingError {
    TooLong,
    Stuffing,
    Checksum,
}

/// Encodes `frame` for the stream; returns the length in `wire`.
pub fn encode(frame: &[u8], wire: &mut [u8; MAX_WIRE]) -> Result<usize, TooLong> {
    let too_long = TooLong { len: frame.len() };
    if MAX_FRAME < frame.len() {
        return Err(too_long);
    }
    let mut body = [0; MAX_FRAME + crc::LEN];
    let n = frame.len() + crc::LEN;
    body[..frame.len()].copy_from_slice(frame);
    body[frame.len()..n].copy_from_slice(&crc::checksum(frame));
    let stuffed = cobs::stuff(&body[..n], wire).ok_or(too_long)?;
    wire[stuffed] = END;
    Ok(stuffed + 1)
}

/// Finds frames in a stream of bytes, one byte at a time, in a fixed buffer.
#[derive(Clone, Debug)]
pub struct Deframer {
    buffer: [u8; MAX_WIRE],
    n: usize,
    overrun: bool,
}

impl Default for Deframer {
    fn default() -> Self {
        Self { buffer: [0; MAX_WIRE], n: 0, overrun: false }
    }
}

impl Deframer {
    /// Accepts the next byte; returns a frame after its last byte.
    ///
    /// An error ends at the zero that reports it; the next byte starts afresh. Zeros without bytes
    /// between them are ignored.
    pub fn push(&mut self, byte: u8) -> Option<Result<&[u8], FramingError>> {
        if byte != END {
            self.keep(byte);
            return None;
        }
        let n = core::mem::take(&mut self.n);
        if core::mem::take(&mut self.overrun) {
            return Some(Err(FramingError::TooLong));
        }
        (0 < n).then(|| open(&mut self.buffer[..n]))
    }

    fn keep(&mut self, byte: u8) {
        // The last position belongs to the closing zero, which is never kept.
        if self.n < MAX_WIRE - 1 {
            self.buffer[self.n] = byte;
            self.n += 1;
        } else {
            self.overrun = true;
        }
    }
}

fn open(bytes: &mut [u8]) -> Result<&[u8], FramingError> {
    let body = cobs::unstuff(bytes).ok_or(FramingError::Stuffing)?;
    let (frame, checksum) = body.split_last_chunk().ok_or(FramingError::Checksum)?;
    if *checksum == crc::checksum(frame) { Ok(frame) } else { Err(FramingError::Checksum) }
}
