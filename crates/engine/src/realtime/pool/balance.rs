//! Balance of the lanes: each is to compute as much as the others.

use scheduler::motion::KEYS;
use scheduler::slot::Slot;
use scheduler::time::Nanos;
use scheduler::voice::VoiceOutput;

use super::worker::boxed_array;

/// Cost of a turn beside its units of work, in units.
const TURN: u64 = 4;

const SPAN: u64 = 16;

/// Inverse of the fraction of the larger load by which lanes must differ for a move.
const WORTH: u64 = 8;

/// Inverse of the fraction of lane 0's time that it may wait before the others count as slower.
const WAIT: u64 = 16;

/// Inverse of the fraction of all work by which the lag of other lanes changes in a tick.
const LAG_STEP: u64 = 256;

/// Recent work of voices in units, and the lag of the other lanes.
#[derive(Debug)]
pub(super) struct MeasuredWork {
    /// Moving average, times [`SPAN`].
    work: Box<[u64; KEYS]>,
    /// Keys whose voices rested in their last turn, a bit each.
    asleep: u128,
    /// Work of lane 0 while the others wake up, in the unit of `work`.
    lag: u64,
}

impl MeasuredWork {
    pub(super) fn new() -> Self {
        Self { work: boxed_array(), asleep: 0, lag: 0 }
    }

    /// Learns from a tick; held turns do not count.
    pub(super) fn learn(&mut self, turns: &[VoiceOutput; KEYS]) {
        for (key, (average, turn)) in self.work.iter_mut().zip(turns).enumerate() {
            if turn.late {
                continue;
            }
            *average = *average - *average / SPAN + u64::from(turn.work.units) + TURN;
            let bit = 1_u128 << key;
            self.asleep = if turn.idle { self.asleep | bit } else { self.asleep & !bit };
        }
    }

    /// Learns from the time of lane 0's voices, and its wait for those of the others.
    pub(super) fn learn_lag(&mut self, inline: Nanos, waiting: Nanos) {
        let all: u64 = self.work.iter().sum();
        let step = all / LAG_STEP;
        self.lag = if inline.as_u64() < WAIT * waiting.as_u64() {
            (self.lag + step).min(all / 2)
        } else {
            self.lag.saturating_sub(step)
        };
    }

    pub(super) const fn lag(&self) -> u64 {
        self.lag
    }

    pub(super) const fn is_asleep(&self, key: usize) -> bool {
        self.asleep >> key & 1 == 1
    }

    pub(super) fn of<V>(&self, slots: &[Slot<V>]) -> u64 {
        slots.iter().map(|slot| self.work[slot.key()]).sum()
    }

    /// Returns the slot whose move best balances loads `most` and `least`, if it is worth a move.
    pub(super) fn to_move<V>(&self, slots: &[Slot<V>], most: u64, least: u64) -> Option<usize> {
        let gap = most.checked_sub(least).filter(|gap| most < WORTH * gap)?;
        let work = |index: &usize| self.work[slots[*index].key()];
        let helps = |index: &usize| (1..gap).contains(&work(index));
        (0..slots.len()).filter(helps).min_by_key(|index| gap.abs_diff(2 * work(index)))
    }
}

#[cfg(test)]
mod tests {
    use scheduler::voice::VoiceWork;

    use super::*;

    fn after(work: impl Fn(usize) -> u32) -> MeasuredWork {
        let mut measured = MeasuredWork::new();
        let mut turns = boxed_array::<VoiceOutput>();
        for (key, turn) in turns.iter_mut().enumerate() {
            turn.work = VoiceWork { units: work(key), ..VoiceWork::NONE };
            turn.idle = work(key) == 0;
        }
        for _ in 0..200 {
            measured.learn(&turns);
        }
        measured
    }

    fn slots(keys: impl IntoIterator<Item = usize>) -> Vec<Slot<()>> {
        keys.into_iter().map(|key| Slot::new(key, ())).collect()
    }

    #[test]
    fn the_slot_that_is_moved_makes_two_lanes_most_equal() {
        let measured = after(|key| [0, 100, 300, 700][key % 4]);
        // 1200 against 0: 700 leaves 500 and 700, 300 would leave 900 and 300.
        let heavy = slots([4, 5, 6, 7, 9]);
        let load = measured.of(&heavy);
        assert_eq!(measured.to_move(&heavy, load, 0), Some(3));
    }

    #[test]
    fn nothing_is_moved_for_little_nor_where_it_would_only_change_sides() {
        let measured = after(|_key| 100);
        let ten = slots(0..10);
        let load = measured.of(&ten);
        assert_eq!(measured.to_move(&ten, load, load), None);
        assert_eq!(measured.to_move(&ten, load, measured.of(&slots(0..9))), None);
        let one = slots([3]);
        assert_eq!(measured.to_move(&one, measured.of(&one), 0), None);
        assert_eq!(measured.to_move(&ten, 0, load), None);
    }

    #[test]
    fn lanes_for_which_lane_0_waits_have_less_to_do_until_it_waits_no_more() {
        let mut measured = after(|_key| 100);
        let (inline, long, short) = (Nanos::new(1600), Nanos::new(101), Nanos::new(99));
        let all: u64 = measured.work.iter().sum();
        let mut lag_after = |waiting| {
            (0..64).for_each(|_| measured.learn_lag(inline, waiting));
            measured.lag()
        };
        assert_eq!(lag_after(long), 64 * (all / 256));
        assert_eq!(
            (lag_after(long), lag_after(long), lag_after(long)),
            (all / 256 * 128, all / 2, all / 2)
        );
        assert_eq!(lag_after(short), all / 2 - 64 * (all / 256));
        for _ in 0..4 {
            lag_after(short);
        }
        assert_eq!(lag_after(short), 0);
    }

    #[test]
    fn a_voice_that_was_late_is_taken_for_what_it_was() {
        let mut measured = after(|key| if key == 7 { 0 } else { 50 });
        let before = measured.work.clone();
        let mut turns = boxed_array::<VoiceOutput>();
        turns.iter_mut().for_each(VoiceOutput::hold);
        measured.learn(&turns);
        assert_eq!(measured.work, before);
        assert!(measured.is_asleep(7) && !measured.is_asleep(8));
    }
}
