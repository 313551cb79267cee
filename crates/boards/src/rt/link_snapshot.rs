use super::board::BoardStatistics;
use super::bus::{KeybedBus, LineStatistics};
use crate::plan::LinkMeter;

pub use super::board_supervisor::BoardStatus;

/// State of a line or a board, cheap enough for a tick; counts are since the start.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum LinkSnapshot {
    Line(usize, LineSnapshot),
    Board(usize, BoardSnapshot),
}

/// State of a line.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LineSnapshot {
    pub statistics: LineStatistics,
    pub meter: Option<LinkMeter>,
}

/// State of a board.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BoardSnapshot {
    pub statistics: BoardStatistics,
    pub status: Option<BoardStatus>,
}

impl KeybedBus {
    /// Returns the line or board at index `place`, lines first; `None` behind the last.
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
