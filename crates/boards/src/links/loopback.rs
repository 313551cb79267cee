//! A wire in memory. A full queue drops and counts its oldest frame, which is outdated.

use super::{Link, QueuedFrame, RecvError, SendError};

/// Both directions between a host and a board, for one thread. Allocates only when made.
#[derive(Clone, Debug)]
pub struct Loopback {
    to_board: Queue,
    to_host: Queue,
}

impl Loopback {
    /// Returns a wire that holds `capacity` frames in each direction, at least one.
    pub fn new(capacity: usize) -> Self {
        Self { to_board: Queue::new(capacity), to_host: Queue::new(capacity) }
    }

    pub const fn host_end(&mut self) -> LoopbackEnd<'_> {
        LoopbackEnd { out: &mut self.to_board, back: &mut self.to_host }
    }

    pub const fn board_end(&mut self) -> LoopbackEnd<'_> {
        LoopbackEnd { out: &mut self.to_host, back: &mut self.to_board }
    }

    /// Returns the number of frames that were replaced before they were received.
    pub const fn dropped(&self) -> u64 {
        self.to_board.dropped + self.to_host.dropped
    }
}

/// One end of a [`Loopback`].
#[derive(Debug)]
pub struct LoopbackEnd<'a> {
    out: &'a mut Queue,
    back: &'a mut Queue,
}

impl Link for LoopbackEnd<'_> {
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError> {
        self.out.push(QueuedFrame::new(frame)?);
        Ok(())
    }

    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        self.back.pop().map(|frame| frame.unpack(buffer)).transpose()
    }
}

/// First in, first out; when full, first in is lost.
#[derive(Clone, Debug)]
struct Queue {
    places: Box<[QueuedFrame]>,
    first: usize,
    n: usize,
    dropped: u64,
}

impl Queue {
    fn new(capacity: usize) -> Self {
        let places = std::iter::repeat_n(QueuedFrame::EMPTY, capacity.max(1)).collect();
        Self { places, first: 0, n: 0, dropped: 0 }
    }

    fn push(&mut self, frame: QueuedFrame) {
        if self.n == self.places.len() {
            self.forget_oldest();
            self.dropped += 1;
        }
        self.places[(self.first + self.n) % self.places.len()] = frame;
        self.n += 1;
    }

    fn pop(&mut self) -> Option<QueuedFrame> {
        let oldest = (0 < self.n).then(|| self.places[self.first])?;
        self.forget_oldest();
        Some(oldest)
    }

    const fn forget_oldest(&mut self) {
        self.first = (self.first + 1) % self.places.len();
        self.n -= 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_full_wire_keeps_the_newest_and_counts_the_rest() {
        let mut wire = Loopback::new(2);
        for frame in [b"a", b"b", b"c"] {
            wire.host_end().try_send(frame).unwrap();
        }
        let mut buffer = [0; 8];
        for expected in [b"b", b"c"] {
            assert_eq!(wire.board_end().try_recv(&mut buffer), Ok(Some(1)));
            assert_eq!(&buffer[..1], expected);
        }
        assert_eq!(wire.board_end().try_recv(&mut buffer), Ok(None));
        assert_eq!(wire.dropped(), 1);
    }
}
