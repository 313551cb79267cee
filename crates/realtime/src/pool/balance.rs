//! Which lane runs which key: each is to compute as much as the others.

use scheduler::motion::KEYS;
use scheduler::slot::Slot;
use scheduler::voice::VoiceOutput;

use super::worker::boxed_array;

/// What a turn costs beside its evaluations, in evaluations.
const TURN: u64 = 4;

/// Turns over which work is averaged.
const SPAN: u64 = 16;

/// A difference between lanes that is not worth a move is this part of the larger load.
const WORTH: u64 = 8;

/// What voices took of late, in counted evaluations: no clock decides who runs where.
#[derive(Debug)]
pub(super) struct MeasuredWork {
    /// The moving average, times [`SPAN`].
    work: Box<[u64; KEYS]>,
    /// Keys whose voices rested in their last turn, a bit each.
    asleep: u128,
}

impl MeasuredWork {
    pub(super) fn new() -> Self {
        Self { work: boxed_array(), asleep: 0 }
    }

    /// Takes note of a tick; what was held says nothing.
    pub(super) fn learn(&mut self, turns: &[VoiceOutput; KEYS]) {
        for (key, (average, turn)) in self.work.iter_mut().zip(turns).enumerate() {
            if turn.late {
                continue;
            }
            let evaluations = u64::from(turn.work.derivatives) + u64::from(turn.work.guards);
            *average = *average - *average / SPAN + evaluations + TURN;
            let bit = 1_u128 << key;
            self.asleep = if turn.idle { self.asleep | bit } else { self.asleep & !bit };
        }
    }

    /// Whether the voice of `key` rested in its last turn.
    pub(super) const fn is_asleep(&self, key: usize) -> bool {
        self.asleep >> key & 1 == 1
    }

    /// What all of `slots` take together.
    pub(super) fn of<V>(&self, slots: &[Slot<V>]) -> u64 {
        slots.iter().map(|slot| self.work[slot.key()]).sum()
    }

    /// Which of `slots`, of a lane with load `most`, goes to one with load `least`: the one that
    /// leaves them most equal, if that is worth it.
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

    /// What is known after many ticks in which each key did `work` evaluations.
    fn after(work: impl Fn(usize) -> u32) -> MeasuredWork {
        let mut measured = MeasuredWork::new();
        let mut turns = boxed_array::<VoiceOutput>();
        for (key, turn) in turns.iter_mut().enumerate() {
            turn.work = VoiceWork { derivatives: work(key), ..VoiceWork::NONE };
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
