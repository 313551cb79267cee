//! Frames of the protocol on frames of a bus.

use firmware_protocol::MAX_FRAME;
use firmware_protocol::can::{agrees, identifier, padded};

use super::bus::{BusRead, CanBus, Data};
use super::{CanMode, classic::Classic};
use crate::links::{Health, Link, RecvError, SendError};

/// Frames and reports of the bus to read per frame of the protocol; the rest waits.
const MAX_ARRIVALS: usize = 256;

#[derive(Debug)]
pub(super) struct CanPort<B> {
    bus: B,
    classic: Option<Classic>,
    health: Health,
    dropped: u64,
}

impl<B: CanBus> CanPort<B> {
    pub(super) fn new(bus: B, mode: CanMode) -> Self {
        let classic = (mode == CanMode::Classic).then(Classic::new);
        Self { bus, classic, health: Health::default(), dropped: 0 }
    }

    pub(super) const fn dropped(&self) -> u64 {
        self.dropped
    }

    fn send(&mut self, id: u16, frame: &[u8]) -> Result<(), SendError> {
        if let Some(classic) = &mut self.classic {
            return classic.send(&mut self.bus, id, frame);
        }
        let mut data = [0; MAX_FRAME];
        data[..frame.len()].copy_from_slice(frame);
        self.bus.write(id, &data[..padded(frame.len())])
    }

    /// Handles an arrival; returns the outcome of the frame that it ends, if any.
    fn arrive(&mut self, arrival: BusRead, buffer: &mut [u8]) -> Option<Result<usize, RecvError>> {
        match arrival {
            BusRead::Data(data) => self.unpack(&data, buffer),
            BusRead::Foreign => Some(Err(RecvError::Corrupt)),
            BusRead::Report(report) => {
                self.health.note(report);
                None
            }
        }
    }

    fn unpack(&mut self, data: &Data, buffer: &mut [u8]) -> Option<Result<usize, RecvError>> {
        let Some(classic) = &mut self.classic else {
            return Some(deliver(data.id, data.bytes(), buffer));
        };
        match classic.push(data) {
            Ok(frame) => Some(deliver(data.id, frame?, buffer)),
            Err(_piece_lost) => Some(Err(RecvError::Corrupt)),
        }
    }
}

impl<B: CanBus> Link for CanPort<B> {
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError> {
        let too_long = SendError::TooLong { len: frame.len() };
        let id = identifier(frame).filter(|_| frame.len() <= MAX_FRAME).ok_or(too_long)?;
        let outcome = self.send(id, frame);
        self.dropped += u64::from(outcome == Err(SendError::Full));
        outcome
    }

    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        if let Some(classic) = &mut self.classic {
            // The rest is tried again, and errors are reported, at the next send.
            let _not_now = classic.flush(&mut self.bus);
        }
        for _ in 0..MAX_ARRIVALS {
            let Some(arrival) = self.bus.read()? else { return Ok(None) };
            if let Some(outcome) = self.arrive(arrival, buffer) {
                return outcome.map(Some);
            }
        }
        Ok(None)
    }

    fn health(&self) -> Health {
        self.health
    }
}

fn deliver(id: u16, frame: &[u8], buffer: &mut [u8]) -> Result<usize, RecvError> {
    let len = frame.len();
    if !agrees(id, frame) {
        return Err(RecvError::Corrupt);
    }
    buffer.get_mut(..len).ok_or(RecvError::BufferTooShort { len })?.copy_from_slice(frame);
    Ok(len)
}

#[cfg(test)]
mod tests;
