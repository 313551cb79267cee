//! One worker's voices and their share of the tick.

use crate::overload::LaneBudget;
use crate::port::{Lanes, TickInput, TickOutput};
use crate::slot::Slot;
use crate::voice::{Voice, VoiceOutput, VoiceWork};

/// What voices did in one tick, in numbers.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct LaneReport {
    pub idle: u32,
    /// Voices without a trusted force.
    pub faults: u32,
    /// Voices whose lane was not done in time.
    pub late: u32,
    /// Voices that had to wait, since they or their lane took more evaluations than they may.
    pub waited: u32,
    /// Work of all voices together.
    pub work: VoiceWork,
    /// Most work of a single voice, each count by itself.
    pub most: VoiceWork,
}

impl LaneReport {
    /// Adds one voice's turn.
    #[inline]
    fn count(&mut self, turn: &VoiceOutput) {
        self.idle += u32::from(turn.idle);
        self.faults += u32::from(turn.fault.is_some());
        self.late += u32::from(turn.late && !turn.waited);
        self.waited += u32::from(turn.waited);
        self.work = self.work.plus(turn.work);
        self.most = self.most.largest(turn.work);
    }

    /// Returns what `turns` add up to.
    pub fn of(turns: &[VoiceOutput]) -> Self {
        turns.iter().fold(Self::default(), |mut report, turn| {
            report.count(turn);
            report
        })
    }
}

/// Runs each slot's voice, in the order of the slots, and writes its turn and what is seen of it.
///
/// Where `budget` is spent the voices that are left wait; they become the first ones of the next
/// tick. Of other keys nothing is written, and no voice but the slot's own is called.
pub fn run_slots<V: Voice>(
    slots: &mut [Slot<V>],
    mut budget: LaneBudget,
    input: &TickInput<'_>,
    output: &mut TickOutput<'_>,
) {
    let mut n_run = 0;
    for slot in &mut *slots {
        let key = slot.key();
        let turn = &mut output.turns[key];
        if budget.is_spent() {
            slot.wait(input.tick, turn);
        } else {
            slot.allow(input.allowance);
            slot.tick(input.tick, &input.samples[key], turn);
            budget.spend(turn.work.evaluations());
            n_run += 1;
        }
        if input.followed.contains(key) {
            slot.observe(input.followed, turn, &mut output.observed[key]);
        }
    }
    slots.rotate_left(n_run);
}

/// The plainest lanes: one, run where it is called.
#[derive(Debug)]
pub struct Inline<'a, V> {
    pub slots: &'a mut [Slot<V>],
}

impl<V: Voice> Lanes for Inline<'_, V> {
    fn run(&mut self, input: &TickInput<'_>, output: &mut TickOutput<'_>) {
        run_slots(self.slots, LaneBudget::UNLIMITED, input, output);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::{KEYS, KeySample};
    use crate::observation::{FollowedKeys, VoiceObservation};
    use crate::overload::WorkAllowance;
    use crate::voice::VoiceFault;

    /// Rests at even positions, works at odd ones, fails at negative ones.
    struct Parity;

    impl Voice for Parity {
        fn tick(&mut self, _tick: u64, sample: &KeySample, turn: &mut VoiceOutput) {
            if sample.position < 0.0 {
                return turn.fail(VoiceFault::Capped { handled: 3 });
            }
            turn.idle = sample.position % 2.0 == 0.0;
            let derivatives = if turn.idle { 0 } else { 10 * sample.age };
            turn.work = VoiceWork { derivatives, guards: 1, events: 0, ..VoiceWork::NONE };
        }

        fn observe(&self, seen: &mut VoiceObservation) {
            seen.snapshot.mode += 1;
        }

        fn reset(&mut self, _sample: &KeySample) {}
    }

    #[expect(clippy::large_stack_arrays, reason = "all turns; a test has the stack")]
    #[test]
    fn a_report_adds_up_what_voices_did() {
        let mut slots = [40, 2, 7, 8].map(|key| Slot::new(key, Parity));
        let mut samples = [KeySample::default(); KEYS];
        samples[2] = KeySample { age: 1, ..KeySample::fresh(1.0) };
        samples[7] = KeySample { age: 4, ..KeySample::fresh(1.0) };
        samples[8] = KeySample::fresh(-1.0);
        let mut turns = [VoiceOutput::default(); KEYS];
        let mut observed = [VoiceObservation::default(); KEYS];
        let followed = FollowedKeys::new(1 << 2 | 1 << 7 | 1 << 9, 0);
        let allowance = WorkAllowance::ALL;
        let input = TickInput { tick: 0, samples: &samples, followed, allowance };
        run_slots(
            &mut slots,
            LaneBudget::UNLIMITED,
            &input,
            &mut TickOutput { turns: &mut turns, observed: &mut observed },
        );
        let expected = LaneReport {
            idle: 1,
            faults: 1,
            late: 0,
            waited: 0,
            work: VoiceWork { derivatives: 50, guards: 3, events: 0, ..VoiceWork::NONE },
            most: VoiceWork { derivatives: 40, guards: 1, events: 0, ..VoiceWork::NONE },
        };
        assert_eq!(LaneReport::of(&turns), expected);
        let seen = |key: &usize| observed[*key].snapshot.mode == 1;
        assert_eq!((0..KEYS).filter(seen).count(), 2, "slots whose key is followed are looked at");
    }

    /// Takes ten evaluations in each tick.
    struct Ten;

    impl Voice for Ten {
        fn tick(&mut self, tick: u64, _sample: &KeySample, turn: &mut VoiceOutput) {
            (turn.force, turn.work.derivatives) = (tick as f64, 10);
        }

        fn reset(&mut self, _sample: &KeySample) {}
    }

    /// Returns which of seven keys are run in each of four ticks, a bit each, where a lane may take
    /// so many evaluations.
    #[expect(clippy::large_stack_arrays, reason = "all turns; a test has the stack")]
    fn keys_run(evaluations: u32) -> [u8; 4] {
        let mut slots = [0, 1, 2, 3, 4, 5, 6].map(|key| Slot::new(key, Ten));
        let samples = [KeySample::default(); KEYS];
        let mut turns = [VoiceOutput::default(); KEYS];
        let mut observed = [VoiceObservation::default(); KEYS];
        let (followed, allowance) = (FollowedKeys::ALL, WorkAllowance::ALL);
        [0, 1, 2, 3].map(|tick| {
            let input = TickInput { tick, samples: &samples, followed, allowance };
            let mut output = TickOutput { turns: &mut turns, observed: &mut observed };
            run_slots(&mut slots, LaneBudget::of(evaluations), &input, &mut output);
            (0..7).fold(0, |keys, key| {
                let (turn, seen) = (&turns[key], &observed[key]);
                assert!(turn.waited == turn.late && seen.ran & 1 == 1, "what was run is known");
                keys | u8::from(!turn.waited) << key
            })
        })
    }

    #[test]
    fn voices_for_which_a_lane_has_no_time_wait_and_are_first_in_the_next_tick() {
        assert_eq!(keys_run(30), [0b000_0111, 0b011_1000, 0b100_0011, 0b001_1100]);
        assert_eq!(keys_run(1), [1, 2, 4, 8], "one is always run");
        assert_eq!(keys_run(70), [0b111_1111; 4]);
    }
}
