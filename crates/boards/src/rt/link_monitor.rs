//! What a run tells of its lines and boards while it goes on: a snapshot of one of them in a tick,
//! of all of them once a second, so that no tick costs more than another.

use rtrb::{Consumer, Producer, RingBuffer};

use super::link_snapshot::LinkSnapshot;

/// A snapshot, and the tick in which it was taken.
pub type LinkSample = (u64, LinkSnapshot);

/// Snapshots that may wait: of 16 lines with 16 boards each, more than there are.
const ROOM: usize = 272;

/// The tick's end of a ring of snapshots; one that finds no room is dropped, since newer will come.
#[derive(Debug)]
pub(crate) struct LinkMonitor {
    samples: Producer<LinkSample>,
    /// The line or board that is next, lines first.
    place: usize,
    /// The tick from which on it is looked at.
    due: u64,
    /// Ticks between two rounds.
    every: u64,
}

impl LinkMonitor {
    /// Returns a monitor for ticks at `tick_hz` (1/s), and the other end of its ring.
    pub(crate) fn new(tick_hz: u32) -> (Self, Consumer<LinkSample>) {
        let (samples, seen) = RingBuffer::new(ROOM);
        (Self { samples, place: 0, due: 0, every: tick_hz.into() }, seen)
    }

    /// Takes a snapshot of the next line or board of which `snapshot` knows, if one is due.
    ///
    /// # Real-time
    /// One call of `snapshot`.
    pub(crate) fn take(&mut self, tick: u64, snapshot: impl FnOnce(usize) -> Option<LinkSnapshot>) {
        if tick < self.due {
            return;
        }
        if let Some(snapshot) = snapshot(self.place) {
            let _full = self.samples.push((tick, snapshot));
            self.place += 1;
        } else {
            (self.place, self.due) = (0, tick + self.every);
        }
    }
}
