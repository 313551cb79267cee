//! Snapshots of lines and boards during a run: one per tick, all once a second, at equal cost.

use rtrb::{Consumer, Producer, RingBuffer};

use super::link_snapshot::LinkSnapshot;

/// A tick and the snapshot that was taken in it.
pub type LinkSample = (u64, LinkSnapshot);

/// Snapshots that may wait: more than 16 lines with 16 boards each.
const ROOM: usize = 272;

/// The tick's end of a ring of snapshots; those without room are dropped, since newer ones follow.
#[derive(Debug)]
pub(crate) struct LinkMonitor {
    samples: Producer<LinkSample>,
    /// Index of the next line or board, lines first.
    place: usize,
    /// Tick from which it is due.
    due: u64,
    every: u64,
}

impl LinkMonitor {
    pub(crate) fn new(tick_hz: u32) -> (Self, Consumer<LinkSample>) {
        let (samples, seen) = RingBuffer::new(ROOM);
        (Self { samples, place: 0, due: 0, every: tick_hz.into() }, seen)
    }

    /// Takes a snapshot of the next line or board, if one is due.
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
