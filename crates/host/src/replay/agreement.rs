//! Forces of a replay that began anew behind a hole in its recording, beside the recorded ones.

use std::collections::BTreeMap;

use serde::Serialize;
use telemetry::{KeyBlock, Update};

use super::compare::Said;

/// Forces agree if they differ by no more (N): less than what a finger tells apart, which is 7 % of
/// half a newton.
const AGREE: f64 = 0.01;

/// Ticks that were run again behind a hole, every voice anew.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct ResumedTicks {
    /// How many there are.
    pub ticks: u64,
    /// Forces that were compared, one for each key and tick.
    pub compared: u64,
    /// How many of these agree within 10 mN.
    pub agreeing: u64,
    /// The largest difference; none if there is none at all.
    pub largest: Option<ForceDifference>,
    /// The tick from which on all of them agree within 10 mN; none if they do not at the end.
    pub agree_from: Option<u64>,
    /// When it began \[s\].
    pub agree_from_s: Option<f64>,
}

/// A force of a replay beside the recorded one.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct ForceDifference {
    /// By how much they differ \[N\].
    pub newtons: f64,
    pub tick: u64,
    /// Counted from 0, which is A0.
    pub key: u32,
}

/// Compares forces, key by key and tick by tick.
#[derive(Debug, Default)]
pub(super) struct Agreement {
    /// Recorded forces by tick and key (N).
    recorded: BTreeMap<(u64, u32), f64>,
    /// The first tick that was run.
    first: Option<u64>,
    ticks: u64,
    compared: u64,
    agreeing: u64,
    largest: Option<ForceDifference>,
    /// The last tick in which forces were compared.
    last: Option<u64>,
    /// The last tick in which they did not agree.
    off: Option<u64>,
}

impl Agreement {
    /// One more block of the recording.
    pub(super) fn expect(&mut self, block: &KeyBlock) {
        self.recorded.extend(forces(block));
    }

    /// Notes that `tick` was run.
    pub(super) fn run(&mut self, tick: u64) {
        self.first.get_or_insert(tick);
        self.ticks += 1;
    }

    /// Compares what was said by both.
    pub(super) fn window(&mut self, said: &Said) {
        for update in said.take_all() {
            let Update::Block(block) = update else { continue };
            forces(&block).for_each(|(at, force)| self.compare(at, force));
        }
        self.recorded.clear();
    }

    fn compare(&mut self, at: (u64, u32), force: f64) {
        let Some(recorded) = self.recorded.remove(&at) else { return };
        self.compared += 1;
        self.last = self.last.max(Some(at.0));
        let newtons = (force - recorded).abs();
        let largest = self.largest.map_or(0.0, |it| it.newtons);
        if largest < newtons {
            self.largest = Some(ForceDifference { newtons, tick: at.0, key: at.1 });
        }
        // What is no number agrees with nothing.
        if newtons <= AGREE {
            self.agreeing += 1;
        } else {
            self.off = self.off.max(Some(at.0));
        }
    }

    /// Says what came of it, with ticks of `period` seconds.
    pub(super) fn result(&self, period: f64) -> ResumedTicks {
        let agrees = self.off.is_none() || self.off < self.last;
        let from = self.off.map_or(self.first, |off| Some(off + 1)).filter(|_| agrees);
        ResumedTicks {
            ticks: self.ticks,
            compared: self.compared,
            agreeing: self.agreeing,
            largest: self.largest,
            agree_from: from,
            agree_from_s: from.map(|tick| tick as f64 * period),
        }
    }
}

/// Returns the forces that were sent to a key, by tick and key (N).
fn forces(block: &KeyBlock) -> impl Iterator<Item = ((u64, u32), f64)> {
    let at = block.after.iter().map(|after| block.tick.saturating_add(u64::from(*after)));
    at.map(|tick| (tick, block.key)).zip(block.sent.iter().copied())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observe::MessageSink as _;

    fn block(tick: u64, sent: &[f64]) -> KeyBlock {
        let after = (0..).take(sent.len()).collect();
        KeyBlock { tick, key: 39, after, sent: sent.to_vec(), ..KeyBlock::default() }
    }

    /// What comes of recorded and replayed forces from tick 100 on, at 1 kHz.
    fn compared(recorded: &[f64], replayed: &[f64]) -> ResumedTicks {
        let (mut agreement, mut said) = (Agreement::default(), Said::default());
        (100..).take(recorded.len()).for_each(|tick| agreement.run(tick));
        agreement.expect(&block(100, recorded));
        said.take(0, &Update::Block(block(100, replayed)));
        agreement.window(&said);
        agreement.result(1e-3)
    }

    #[test]
    fn forces_agree_from_behind_the_last_tick_in_which_they_do_not() {
        let from = |recorded: &[f64], replayed| {
            let behind = compared(recorded, replayed);
            assert_eq!((behind.ticks, behind.compared), (4, 4));
            assert_eq!(behind.agree_from_s, behind.agree_from.map(|tick| tick as f64 * 1e-3));
            behind.agree_from
        };
        assert_eq!(from(&[1.0; 4], &[1.0, 1.009, 0.991, 1.0]), Some(100));
        assert_eq!(from(&[1.0; 4], &[1.5, 1.011, 1.0, 1.0]), Some(102));
        assert_eq!(from(&[1.0; 4], &[1.0, 1.0, 1.0, 0.9]), None);
        assert_eq!(from(&[1.0, 1.0, 1.0, f64::NAN], &[1.0; 4]), None);
    }

    #[test]
    fn the_largest_difference_is_told_with_its_key_and_tick() {
        let behind = compared(&[1.0; 4], &[1.0, 1.25, 1.005, 0.875]);
        assert_eq!(behind.agreeing, 2);
        let largest = ForceDifference { newtons: 0.25, tick: 101, key: 39 };
        assert_eq!(behind.largest, Some(largest));
        let same = compared(&[1.0; 4], &[1.0; 4]);
        assert_eq!((same.agreeing, same.largest), (4, None));
    }

    #[test]
    fn what_only_one_of_both_has_is_not_compared() {
        let one = compared(&[1.0; 4], &[1.0]);
        assert_eq!((one.ticks, one.compared, one.agree_from), (4, 1, Some(100)));
        let none = compared(&[1.0; 4], &[]);
        assert_eq!((none.compared, none.agree_from), (0, Some(100)));
    }
}
