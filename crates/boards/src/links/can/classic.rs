//! Frames in pieces of seven bytes, several of them under way at once.

use firmware_protocol::MAX_FRAME;
use firmware_protocol::can::pieces::{PieceLost, Reassembler, cut};

use super::bus::{CanBus, Data};
use crate::links::SendError;

/// Numbers of classes, used or not.
const CLASSES: usize = 16;
/// Boards, and all boards.
const NODES: usize = 16;

/// What is remembered for each identifier.
#[derive(Clone, Debug, Default)]
struct ReassemblyState {
    assembler: Reassembler,
    /// The number of the next frame sent under it; the protocol takes three bits.
    roll: u8,
}

/// The frames that are being put together, and the one that is being sent.
#[derive(Clone, Debug)]
pub(super) struct Classic {
    places: Box<[ReassemblyState]>,
    sending: Sending,
}

/// A frame of which some pieces have still to go.
#[derive(Clone, Debug)]
struct Sending {
    id: u16,
    frame: [u8; MAX_FRAME],
    len: usize,
    roll: u8,
    /// The next piece; none if all have gone.
    next: Option<usize>,
}

impl Classic {
    /// Takes its memory, about 20 kB.
    pub(super) fn new() -> Self {
        let places = vec![ReassemblyState::default(); CLASSES * NODES].into_boxed_slice();
        let sending = Sending { id: 0, frame: [0; MAX_FRAME], len: 0, roll: 0, next: None };
        Self { places, sending }
    }

    /// Sends a frame; what the bus takes only in part goes on before anything else.
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

    /// Sends the pieces that have still to go.
    pub(super) fn flush(&mut self, bus: &mut impl CanBus) -> Result<(), SendError> {
        let Sending { id, frame, len, roll, next } = &mut self.sending;
        let Some(first) = *next else { return Ok(()) };
        for (index, (piece, size)) in cut(&frame[..*len], *roll).enumerate().skip(first) {
            if let Err(error) = bus.write(*id, &piece[..size]) {
                // What was on its way when the bus went down is old when it is back.
                *next = (error == SendError::Full).then_some(index);
                return Err(error);
            }
        }
        *next = None;
        Ok(())
    }

    /// Takes a piece; returns the frame when it was the last of one.
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

/// Returns what is remembered for an identifier; none if no frame travels under it.
fn place(places: &mut [ReassemblyState], id: u16) -> Option<&mut ReassemblyState> {
    let (class, node) = (usize::from(id >> 7), usize::from(id & 0x7F));
    places.get_mut(class * NODES + node).filter(|_| node < NODES)
}
