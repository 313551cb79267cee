//! Frames in pieces of seven bytes, several of them under way at once.

use firmware_protocol::MAX_FRAME;
use firmware_protocol::can::pieces::{PieceLost, Reassembler, cut};

use super::bus::{CanBus, Data};
use crate::links::SendError;

const CLASSES: usize = 16;
const NODES: usize = 16;

#[derive(Clone, Debug, Default)]
struct ReassemblyState {
    assembler: Reassembler,
    /// Three-bit number of the next frame sent under this identifier.
    roll: u8,
}

#[derive(Clone, Debug)]
pub(super) struct Classic {
    places: Box<[ReassemblyState]>,
    sending: Sending,
}

#[derive(Clone, Debug)]
struct Sending {
    id: u16,
    frame: [u8; MAX_FRAME],
    len: usize,
    roll: u8,
    /// Index of the next piece; `None` if all were sent.
    next: Option<usize>,
}

impl Classic {
    /// Allocates about 20 kB.
    pub(super) fn new() -> Self {
        let places = vec![ReassemblyState::default(); CLASSES * NODES].into_boxed_slice();
        let sending = Sending { id: 0, frame: [0; MAX_FRAME], len: 0, roll: 0, next: None };
        Self { places, sending }
    }

    /// Sends a frame; the rest of a partly sent one goes first.
    pub(super) fn send(
        &mut self,
        bus: &mut impl CanBus,
        id: u16,
        frame: &[u8],
    ) -> Result<(), SendError> {
        self.flush(bus)?;
        let len = frame.len();
        let room = self.sending.frame.get_mut(..len).ok_or(SendError::TooLong { len })?;
        room.copy_from_slice(frame);
        let roll = place(&mut self.places, id).map_or(0, ReassemblyState::next_roll);
        self.sending = Sending { id, len, roll, next: Some(0), ..self.sending };
        match (self.flush(bus), self.sending.next) {
            (Err(SendError::Full), Some(0)) => {
                self.sending.next = None;
                Err(SendError::Full)
            }
            // It has begun, so it will go.
            (Err(SendError::Full), _) => Ok(()),
            (outcome, _) => outcome,
        }
    }

    pub(super) fn flush(&mut self, bus: &mut impl CanBus) -> Result<(), SendError> {
        let Sending { id, frame, len, roll, next } = &mut self.sending;
        let Some(first) = *next else { return Ok(()) };
        for (index, (piece, size)) in cut(&frame[..*len], *roll).enumerate().skip(first) {
            if let Err(error) = bus.write(*id, &piece[..size]) {
                // Pieces that were under way when the bus went down are stale when it is back.
                *next = (error == SendError::Full).then_some(index);
                return Err(error);
            }
        }
        *next = None;
        Ok(())
    }

    pub(super) fn push(&mut self, piece: &Data) -> Result<Option<&[u8]>, PieceLost> {
        place(&mut self.places, piece.id).ok_or(PieceLost)?.assembler.push(piece.bytes())
    }
}

impl ReassemblyState {
    const fn next_roll(&mut self) -> u8 {
        self.roll = self.roll.wrapping_add(1);
        self.roll
    }
}

/// Returns the state of an identifier; `None` if no frame travels under it.
fn place(places: &mut [ReassemblyState], id: u16) -> Option<&mut ReassemblyState> {
    let (class, node) = (usize::from(id >> 7), usize::from(id & 0x7F));
    places.get_mut(class * NODES + node).filter(|_| node < NODES)
}
