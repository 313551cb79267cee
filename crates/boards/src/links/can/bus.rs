//! Port of a CAN socket, so that tests need none.

use firmware_protocol::MAX_FRAME;

use crate::links::{RecvError, SendError};

/// Frames of the bus, in and out, without waiting.
pub(super) trait CanBus {
    /// Sends a frame of the bus; `data` has a valid length.
    fn write(&mut self, id: u16, data: &[u8]) -> Result<(), SendError>;

    fn read(&mut self) -> Result<Option<BusRead>, RecvError>;
}

#[derive(Clone, Copy, Debug)]
pub(super) enum BusRead {
    Data(Data),
    Report(ControllerReport),
    /// A frame that no board sends: extended, remote, or not of this mode.
    Foreign,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Data {
    /// Identifier, 11 bits.
    pub(super) id: u16,
    bytes: [u8; MAX_FRAME],
    len: usize,
}

impl Data {
    /// Copies `data`, cut off at the longest frame.
    pub(super) fn new(id: u16, data: &[u8]) -> Self {
        let len = data.len().min(MAX_FRAME);
        let mut bytes = [0; MAX_FRAME];
        bytes[..len].copy_from_slice(&data[..len]);
        Self { id, bytes, len }
    }

    pub(super) fn bytes(&self) -> &[u8] {
        &self.bytes[..self.len]
    }
}

/// A report of a controller or its driver, which Linux delivers as a frame.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct ControllerReport {
    /// Subjects, as bits.
    pub(super) class: u32,
    pub(super) data: [u8; 8],
}
