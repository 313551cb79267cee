//! The tick's wait-free end of what is seen of lines and boards: one of them a tick, all of them
//! once a second; full is dropped, since newer will come.

use hardware::rt::link_snapshot::LinkSnapshot;
use rtrb::{Consumer, Producer, RingBuffer};

/// What was seen, and in which tick.
pub type LinkSample = (u64, LinkSnapshot);

/// Sightings that may wait: of 16 lines with 16 boards each, more than there are.
const ROOM: usize = 272;

/// Looks at lines and boards.
#[derive(Debug)]
pub struct LinkMonitor {
    out: Producer<LinkSample>,
    /// Which is looked at next, and from which tick on.
    place: usize,
    due: u64,
    /// Ticks between two rounds.
    every: u64,
}

impl LinkMonitor {
    /// One for ticks at `tick_hz` (1/s), and where it leads.
    pub fn new(tick_hz: u32) -> (Self, Consumer<LinkSample>) {
        let (out, seen) = RingBuffer::new(ROOM);
        (Self { out, place: 0, due: 0, every: tick_hz.into() }, seen)
    }

    /// Looks at the next line or board of which `glance` knows, if it is time.
    ///
    /// # Real-time
    /// One glance.
    pub fn take(&mut self, tick: u64, glance: impl FnOnce(usize) -> Option<LinkSnapshot>) {
        if tick < self.due {
            return;
        }
        if let Some(glance) = glance(self.place) {
            let _full = self.out.push((tick, glance));
            self.place += 1;
        } else {
            (self.place, self.due) = (0, tick + self.every);
        }
    }
}

#[cfg(test)]
mod tests {
    use hardware::rt::bus::LineStatistics;
    use hardware::rt::link_snapshot::LineSnapshot;

    use super::*;

    #[test]
    fn a_round_takes_a_tick_for_each_and_is_made_once_a_second() {
        let (mut lookout, mut seen) = LinkMonitor::new(100);
        let line = LineSnapshot { statistics: LineStatistics::default(), meter: None };
        let three = |place| (place < 3).then_some(LinkSnapshot::Line(place, line));
        (0..250).for_each(|tick| lookout.take(tick, three));
        let mut ticks = Vec::new();
        while let Ok((tick, LinkSnapshot::Line(line, _))) = seen.pop() {
            ticks.push((tick, line));
        }
        let rounds = [0, 103, 206];
        let wanted = rounds.iter().flat_map(|at| (0..3).map(move |n| (at + n as u64, n)));
        assert_eq!(ticks, wanted.collect::<Vec<_>>());
    }
}
