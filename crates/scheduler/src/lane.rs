//! One worker's voices and their share of the tick.

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
    /// Voices that had to wait, since they took more evaluations than they may.
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
/// Of other keys nothing is written, and no voice but the slot's own is called.
pub fn run_slots<V: Voice>(
    slots: &mut [Slot<V>],
    input: &TickInput<'_>,
    output: &mut TickOutput<'_>,
) {
    for slot in slots {
        let key = slot.key();
        let turn = &mut output.turns[key];
        slot.allow(input.allowance);
        slot.tick(input.tick, &input.samples[key], turn);
        if input.followed.contains(key) {
            slot.observe(input.followed, turn, &mut output.observed[key]);
        }
    }
}

/// The plainest lanes: one, run where it is called.
#[derive(Debug)]
pub struct Inline<'a, V> {
    pub slots: &'a mut [Slot<V>],
}

impl<V: Voice> Lanes for Inline<'_, V> {
    fn run(&mut self, input: &TickInput<'_>, output: &mut TickOutput<'_>) {
        run_slots(self.slots, input, output);
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
}
