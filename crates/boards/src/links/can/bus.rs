//! What a CAN socket does, so that tests can do it without one.

use firmware_protocol::MAX_FRAME;

use crate::links::{RecvError, SendError};

/// Frames of the bus, in and out, without waiting.
pub(super) trait CanBus {
    /// Hands over a frame of the bus; `data` has a length that the bus has.
    fn write(&mut self, id: u16, data: &[u8]) -> Result<(), SendError>;

    /// Returns the next thing that came, if anything did.
    fn read(&mut self) -> Result<Option<BusRead>, RecvError>;
}

/// What comes from a bus.
#[derive(Clone, Copy, Debug)]
pub(super) enum BusRead {
    Data(Data),
    /// A report of the controller.
    Report(ControllerReport),
    /// A frame that no board sends: extended, remote, or not of this mode.
    Foreign,
}

/// A frame of the bus.
#[derive(Clone, Copy, Debug)]
pub(super) struct Data {
    /// Its identifier, 11 bits.
    pub(super) id: u16,
    bytes: [u8; MAX_FRAME],
    len: usize,
}

impl Data {
    /// Returns a copy; what is longer than any frame is cut off.
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

/// What a controller or its driver reports; Linux hands it over in the shape of a frame.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct ControllerReport {
    /// What it is about, as bits.
    pub(super) class: u32,
    pub(super) data: [u8; 8],
}
