use super::{RecvError, SendError};

/// Longest frame of the wires in memory: one with its framing (bytes).
pub const MAX_LEN: usize = firmware_protocol::serial::MAX_WIRE;

#[derive(Clone, Copy, Debug)]
pub(crate) struct QueuedFrame {
    pub(crate) bytes: [u8; MAX_LEN],
    pub(crate) len: usize,
}

impl QueuedFrame {
    pub(crate) const EMPTY: Self = Self { bytes: [0; MAX_LEN], len: 0 };

    pub(crate) fn new(frame: &[u8]) -> Result<Self, SendError> {
        let mut queued = Self { len: frame.len(), ..Self::EMPTY };
        let place = queued.bytes.get_mut(..frame.len());
        place.ok_or(SendError::TooLong { len: frame.len() })?.copy_from_slice(frame);
        Ok(queued)
    }

    pub(crate) fn as_slice(&self) -> &[u8] {
        &self.bytes[..self.len]
    }

    pub(crate) fn unpack(&self, buffer: &mut [u8]) -> Result<usize, RecvError> {
        let place = buffer.get_mut(..self.len);
        place.ok_or(RecvError::BufferTooShort { len: self.len })?.copy_from_slice(self.as_slice());
        Ok(self.len)
    }
}
