//! Evaluates the sequence numbers of one sender: new and missing frames.

use firmware_protocol::sequence::{FrameOrder, SequenceNumber};

/// Ticks of silence after which any number is new: 127 frames can be ordered, two per tick.
const FORGET_TICKS: u64 = 60;

/// The newest frame of one sender, and counts of all others.
#[derive(Clone, Copy, Debug, Default)]
pub struct Loss {
    newest: Option<(SequenceNumber, u64)>,
    counts: LossCounts,
}

/// Counts over the sequence numbers of one sender.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct LossCounts {
    /// Frames that were newer than all before.
    pub frames: u64,
    pub gaps: u64,
    pub missing: u64,
    pub repeated: u64,
    pub overtaken: u64,
}

impl Loss {
    /// Counts a frame that arrived in `tick`. Returns `true` if it is newer than all before.
    ///
    /// # Real-time
    /// A few comparisons.
    pub fn accept(&mut self, sequence: SequenceNumber, tick: u64) -> bool {
        let news = match self.remembered(tick).map(|newest| sequence.after(newest)) {
            None | Some(FrameOrder::Newer { missing: 0 }) => true,
            Some(FrameOrder::Newer { missing }) => {
                self.counts.gaps += 1;
                self.counts.missing += u64::from(missing);
                true
            }
            Some(FrameOrder::Repeated) => {
                self.counts.repeated += 1;
                false
            }
            Some(FrameOrder::Older) => {
                self.counts.overtaken += 1;
                false
            }
        };
        if news {
            self.counts.frames += 1;
            self.newest = Some((sequence, tick));
        }
        news
    }

    /// Returns `true` if a frame in `tick` would directly follow the newest.
    pub fn is_next(&self, sequence: SequenceNumber, tick: u64) -> bool {
        let arrival = self.remembered(tick).map(|newest| sequence.after(newest));
        matches!(arrival, Some(FrameOrder::Newer { missing: 0 }))
    }

    pub const fn counts(&self) -> LossCounts {
        self.counts
    }

    /// Forgets the newest frame, for a sender that restarts; the counts stay.
    pub const fn forget(&mut self) {
        self.newest = None;
    }

    fn remembered(&self, tick: u64) -> Option<SequenceNumber> {
        let (sequence, at) = self.newest?;
        (tick.saturating_sub(at) < FORGET_TICKS).then_some(sequence)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(frames: &[(u8, u64)], news: &[bool]) -> LossCounts {
        let mut loss = Loss::default();
        let got: Vec<_> = frames
            .iter()
            .map(|(number, tick)| loss.accept(SequenceNumber(*number), *tick))
            .collect();
        assert_eq!(got, news);
        loss.counts()
    }

    #[test]
    fn frames_in_order_leave_no_gap_across_the_wrap() {
        let counts = check(&[(254, 0), (255, 1), (0, 2)], &[true; 3]);
        assert_eq!(counts, LossCounts { frames: 3, ..LossCounts::default() });
    }

    #[test]
    fn a_repeated_and_an_overtaken_frame_are_no_news() {
        let counts = check(&[(7, 0), (7, 0), (6, 1)], &[true, false, false]);
        assert_eq!((counts.frames, counts.repeated, counts.overtaken), (1, 1, 1));
    }

    #[test]
    fn a_sender_that_restarts_after_a_silence_is_heard() {
        let counts = check(&[(200, 0), (0, 60)], &[true; 2]);
        assert_eq!((counts.frames, counts.gaps), (2, 0));
    }
}
