//! A line or a board as it is at one moment, cheap enough for a tick.

use super::board::BoardStatistics;
use super::bus::{KeybedBus, LineStatistics};
use crate::plan::LinkMeter;

pub use super::board_supervisor::BoardStatus;

/// A line or a board as it is now; counts are since the start.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum LinkSnapshot {
    /// A line, by its number.
    Line(usize, LineSnapshot),
    /// A board, by its place among all boards.
    Board(usize, BoardSnapshot),
}

/// A line as it is now.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LineSnapshot {
    /// What it has carried beside the boards' own counts.
    pub statistics: LineStatistics,
    /// What it has carried, if its medium is known.
    pub meter: Option<LinkMeter>,
}

/// A board as it is now.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BoardSnapshot {
    /// What it has sent and was sent.
    pub statistics: BoardStatistics,
    /// How it is supervised, if it is.
    pub status: Option<BoardStatus>,
}

impl KeybedBus {
    /// Returns the line or board at `place`, lines first; nothing behind the last.
    ///
    /// # Real-time
    /// Copies; no heap.
    pub fn snapshot(&self, place: usize) -> Option<LinkSnapshot> {
        let Some(board) = place.checked_sub(self.n_lines()) else {
            let (statistics, meter) = (self.line(place), self.line_meter(place));
            return Some(LinkSnapshot::Line(place, LineSnapshot { statistics, meter }));
        };
        let statistics = self.boards().get(board)?.statistics();
        Some(LinkSnapshot::Board(board, BoardSnapshot { statistics, status: None }))
    }
}
