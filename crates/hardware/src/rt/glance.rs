//! What a run shows of its lines and boards while it goes on: one of them at a time, so that a
//! tick that looks costs the same as any other.

use super::board::BoardStatistics;
use super::bus::{KeybedBus, LineStatistics};
use super::steward::ArmState;
use crate::plan::LinkMeter;

/// A line or a board as it is now; counts are since the start.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum LinkSnapshot {
    /// A line, by its number.
    Line(usize, LineGlance),
    /// A board, by its place among all boards.
    Board(usize, BoardGlance),
}

/// A line as it is now.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LineGlance {
    /// What it has carried beside the boards' own counts.
    pub statistics: LineStatistics,
    /// What it has carried, if its medium is known.
    pub meter: Option<LinkMeter>,
}

/// A board as it is now.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BoardGlance {
    /// What it has sent and was sent.
    pub statistics: BoardStatistics,
    /// How it is looked after, if somebody does.
    pub care: Option<BoardStatus>,
}

/// How a board is looked after.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BoardStatus {
    /// How far it has been brought up.
    pub stage: ArmState,
    /// Times that it was armed.
    pub armings: u64,
    /// Median of the latest round trips (us), if there were any.
    pub round_trip_us: Option<u32>,
}

impl KeybedBus {
    /// The line or board at `place`, lines first; nothing behind the last.
    ///
    /// # Real-time
    /// Copies; no heap.
    pub fn glance(&self, place: usize) -> Option<LinkSnapshot> {
        let Some(board) = place.checked_sub(self.n_lines()) else {
            let (statistics, meter) = (self.line(place), self.line_meter(place));
            return Some(LinkSnapshot::Line(place, LineGlance { statistics, meter }));
        };
        let statistics = self.boards().get(board)?.statistics();
        Some(LinkSnapshot::Board(board, BoardGlance { statistics, care: None }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sim::keybed::SimulatedKeybed;
    use haptics::plant::RigParameters;

    #[test]
    fn lines_come_before_boards_and_then_nothing() {
        let keybed = SimulatedKeybed::new(1e-3, RigParameters::default()).unwrap();
        let seen: Vec<_> = (0..17).map(|place| keybed.glance(place)).collect();
        assert!(matches!(seen[7], Some(LinkSnapshot::Line(7, _))), "{:?}", seen[7]);
        assert!(matches!(seen[8], Some(LinkSnapshot::Board(0, _))), "{:?}", seen[8]);
        assert!(matches!(seen[15], Some(LinkSnapshot::Board(7, _))), "{:?}", seen[15]);
        assert_eq!(seen[16], None);
    }
}
