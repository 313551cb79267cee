//! One worker's voices and their share of the tick.

use crate::motion::{KEYS, KeySample};
use crate::port::Lanes;
use crate::slot::Slot;
use crate::voice::{Voice, VoiceOutput, VoiceWork};

/// What voices did in one tick.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct LaneReport {
    pub idle: u32,
    /// Voices without a trusted force.
    pub faults: u32,
    /// Voices whose lane was not done in time.
    pub late: u32,
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
        self.late += u32::from(turn.late);
        self.work = self.work.plus(turn.work);
        self.most = self.most.largest(turn.work);
    }

    /// Adds up `turns`.
    pub fn of(turns: &[VoiceOutput]) -> Self {
        turns.iter().fold(Self::default(), |mut report, turn| {
            report.count(turn);
            report
        })
    }
}

/// Runs each slot's voice for `tick`, in the order of the slots, and writes its turn.
///
/// Turns of other keys are left alone; so is every voice but the slot's own.
pub fn run_slots<V: Voice>(
    slots: &mut [Slot<V>],
    tick: u64,
    samples: &[KeySample; KEYS],
    turns: &mut [VoiceOutput; KEYS],
) {
    for slot in slots {
        let key = slot.key();
        slot.tick(tick, &samples[key], &mut turns[key]);
    }
}

/// The plainest lanes: one, run where it is called.
#[derive(Debug)]
pub struct Inline<'a, V> {
    /// The voices, each with its key.
    pub slots: &'a mut [Slot<V>],
}

impl<V: Voice> Lanes for Inline<'_, V> {
    fn run(&mut self, tick: u64, samples: &[KeySample; KEYS], turns: &mut [VoiceOutput; KEYS]) {
        run_slots(self.slots, tick, samples, turns);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::voice::VoiceFault;

    /// Rests at even positions, works at odd ones, fails at negative ones.
    struct Parity;

    impl Voice for Parity {
        fn tick(&mut self, _tick: u64, sample: &KeySample) -> VoiceOutput {
            if sample.position < 0.0 {
                return VoiceOutput::faulty(VoiceFault::Capped { handled: 3 });
            }
            let idle = sample.position % 2.0 == 0.0;
            let derivatives = if idle { 0 } else { 10 * sample.age };
            VoiceOutput {
                idle,
                work: VoiceWork { derivatives, guards: 1, events: 0 },
                ..VoiceOutput::default()
            }
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
        run_slots(&mut slots, 0, &samples, &mut turns);
        let expected = LaneReport {
            idle: 1,
            faults: 1,
            late: 0,
            work: VoiceWork { derivatives: 50, guards: 3, events: 0 },
            most: VoiceWork { derivatives: 40, guards: 1, events: 0 },
        };
        assert_eq!(LaneReport::of(&turns), expected);
    }
}
