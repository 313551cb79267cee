//! Whole frames on a stream that may accept half of one.

use std::ops::Range;

use super::stream::{Disconnected, NonBlockingFd};
use crate::links::{Link, MAX_LEN, RecvError, SendError};

/// A stream, and the rest of a frame that it has accepted in part.
///
/// The rest goes first, so that whole frames arrive. A frame that cannot be begun is dropped.
#[derive(Debug)]
pub(super) struct SerialCarrier {
    stream: NonBlockingFd,
    frame: [u8; MAX_LEN],
    /// Range of `frame` that the stream has not accepted yet.
    rest: Range<usize>,
    dropped: u64,
}

impl SerialCarrier {
    pub(super) const fn new(stream: NonBlockingFd) -> Self {
        Self { stream, frame: [0; MAX_LEN], rest: 0..0, dropped: 0 }
    }

    pub(super) const fn dropped(&self) -> u64 {
        self.dropped
    }

    fn flush(&mut self) -> Result<(), Disconnected> {
        if !self.rest.is_empty() {
            self.rest.start += self.stream.write(&self.frame[self.rest.clone()])?;
        }
        Ok(())
    }

    const fn drop_frame(&mut self) -> SendError {
        self.dropped += 1;
        SendError::Full
    }
}

impl From<Disconnected> for SendError {
    fn from(_: Disconnected) -> Self {
        Self::Down
    }
}

impl From<Disconnected> for RecvError {
    fn from(_: Disconnected) -> Self {
        Self::Down
    }
}

impl Link for SerialCarrier {
    fn try_send(&mut self, bytes: &[u8]) -> Result<(), SendError> {
        self.flush()?;
        if !self.rest.is_empty() {
            return Err(self.drop_frame());
        }
        let too_long = SendError::TooLong { len: bytes.len() };
        self.frame.get_mut(..bytes.len()).ok_or(too_long)?.copy_from_slice(bytes);
        let taken = self.stream.write(bytes)?;
        if taken == 0 {
            return Err(self.drop_frame());
        }
        self.rest = taken..bytes.len();
        Ok(())
    }

    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        // The read reports a port that is gone as well, after its last bytes.
        let _gone = self.flush();
        let len = self.stream.read(buffer)?;
        Ok((0 < len).then_some(len))
    }
}
