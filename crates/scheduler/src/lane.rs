//! One worker's voices, and their share of the tick.

use crate::port::{TickInput, TickOutput};
use crate::slot::Slot;
use crate::voice::{Voice, VoiceOutput, VoiceWork};
use crate::work::{LaneBudget, LaneClock};

/// Counts of the voices of one tick.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct LaneReport {
    pub idle: u32,
    /// Voices without a trusted force.
    pub faults: u32,
    /// Voices with a late lane.
    pub late: u32,
    /// Voices that waited because their lane had no time left.
    pub waited: u32,
    pub work: VoiceWork,
    /// Largest work of a single voice, each count separately.
    pub most: VoiceWork,
}

impl LaneReport {
    #[inline]
    fn count(&mut self, turn: &VoiceOutput) {
        self.idle += u32::from(turn.idle);
        self.faults += u32::from(turn.fault.is_some());
        self.late += u32::from(turn.late && !turn.waited);
        self.waited += u32::from(turn.waited);
        self.work = self.work.plus(turn.work);
        self.most = self.most.largest(turn.work);
    }

    pub fn of(turns: &[VoiceOutput]) -> Self {
        turns.iter().fold(Self::default(), |mut report, turn| {
            report.count(turn);
            report
        })
    }
}

/// Runs each slot's voice in the order of the slots, and writes its turn and observation.
///
/// When `budget` has no time left, the other voices wait and are the first of the next tick. One
/// voice is always run. Nothing is written for other keys, and no other voice is called.
pub fn run_slots<V: Voice, C: LaneClock>(
    slots: &mut [Slot<V>],
    mut budget: LaneBudget<'_, C>,
    input: &TickInput<'_>,
    output: &mut TickOutput<'_>,
) {
    let mut n_run = 0;
    let mut has_time = true;
    for slot in &mut *slots {
        let key = slot.key();
        let turn = &mut output.turns[key];
        let price = budget.price(slot.kind());
        has_time = has_time && (budget.has_time(price, slot.expected_units()) || n_run == 0);
        if has_time {
            slot.allow(input.rules, price.most);
            slot.tick(input.tick, &input.samples[key], turn);
            budget.spend(price, turn.work.units);
            n_run += 1;
        } else {
            slot.wait(input.tick, turn);
        }
        if input.followed.contains(key) {
            slot.observe(input.followed, turn, &mut output.observed[key]);
        }
    }
    slots.rotate_left(n_run);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::{KEYS, KeySample};
    use crate::observation::{FollowedKeys, VoiceObservation};
    use crate::overload::Simplifications;
    use crate::port::TickRules;
    use crate::voice::VoiceFault;
    use crate::work::{NoClock, VoiceKind, WorkCosts};

    const RULES: TickRules = TickRules { simplified: Simplifications::NONE, hz: 1000 };

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
        let input = TickInput { tick: 0, samples: &samples, followed, rules: RULES };
        run_slots(
            &mut slots,
            LaneBudget::unlimited(f64::INFINITY),
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

    /// Clock by which each turn of ten units takes `turn` (ns) of `time` (ns).
    struct TurnClock<'a> {
        time: f64,
        turn: f64,
        turns: &'a core::cell::Cell<u32>,
        looks: &'a core::cell::Cell<u32>,
    }

    impl LaneClock for TurnClock<'_> {
        fn left(&mut self) -> f64 {
            self.looks.set(self.looks.get() + 1);
            self.time - f64::from(self.turns.get()) * self.turn
        }
    }

    struct Counted<'a>(&'a core::cell::Cell<u32>);

    impl Voice for Counted<'_> {
        fn tick(&mut self, tick: u64, _sample: &KeySample, turn: &mut VoiceOutput) {
            self.0.set(self.0.get() + 1);
            (turn.force, turn.work.units) = (tick as f64, 10);
        }

        fn reset(&mut self, _sample: &KeySample) {}
    }

    /// Runs seven keys in ticks of 100 ns, with costs of `unit` (ns) and turns of `turn` (ns);
    /// returns the keys run in each tick, a bit each, and the reads of the clock.
    #[expect(clippy::large_stack_arrays, reason = "all turns; a test has the stack")]
    fn keys_run(unit: f64, turn: f64) -> ([u8; 4], u32) {
        let (turns_run, looks) = (core::cell::Cell::new(0), core::cell::Cell::new(0));
        let mut slots = [0, 1, 2, 3, 4, 5, 6].map(|key| Slot::new(key, Counted(&turns_run)));
        let samples = [KeySample::default(); KEYS];
        let mut turns = [VoiceOutput::default(); KEYS];
        let mut observed = [VoiceObservation::default(); KEYS];
        let costs = WorkCosts::constant(unit);
        let mut run = |tick, time| {
            turns_run.set(0);
            let clock = TurnClock { time, turn, turns: &turns_run, looks: &looks };
            let budget = LaneBudget::new(&costs, clock, time, time);
            let input =
                TickInput { tick, samples: &samples, followed: FollowedKeys::ALL, rules: RULES };
            let mut output = TickOutput { turns: &mut turns, observed: &mut observed };
            run_slots(&mut slots, budget, &input, &mut output);
            (0..7).fold(0, |keys, key| {
                let (turn, seen) = (&turns[key], &observed[key]);
                assert!(turn.waited == turn.late && seen.ran & 1 == 1, "what was run is known");
                keys | u8::from(!turn.waited) << key
            })
        };
        // The duration of a turn is known after the first.
        run(0, f64::INFINITY);
        let keys = [1, 2, 3, 4].map(|tick| run(tick, 100.0));
        (keys, looks.get())
    }

    #[test]
    fn voices_for_which_a_lane_has_no_time_wait_and_are_first_in_the_next_tick() {
        let (keys, _looks) = keys_run(3.0, 30.0);
        assert_eq!(keys, [0b000_0111, 0b011_1000, 0b100_0011, 0b001_1100]);
        assert_eq!(keys_run(20.0, 200.0).0, [1, 2, 4, 8], "one is always run");
    }

    #[test]
    fn a_cost_that_is_wrong_makes_no_voice_wait_while_there_is_time() {
        for unit in [1e-3, 1.0, 1e3, 1e6] {
            let (keys, looks) = keys_run(unit, 10.0);
            assert_eq!(keys, [0b111_1111; 4], "{unit} ns");
            assert!(looks <= 4 * 7, "{unit} ns: {looks} looks");
        }
        assert_eq!(
            keys_run(0.5, 5.0),
            ([0b111_1111; 4], 0),
            "a lane with little to do looks never"
        );
    }

    #[test]
    fn a_cost_that_is_too_low_is_noticed_at_half_of_the_time() {
        let (keys, looks) = keys_run(1.0, 25.0);
        assert_eq!(keys.map(u8::count_ones), [5; 4]);
        assert_eq!(looks, 4, "one in each tick");
    }

    #[test]
    fn a_turn_is_limited_by_its_cost() {
        let costs = WorkCosts::constant(2.0);
        let mut budget = LaneBudget::new(&costs, NoClock, 1e6, 1e3);
        assert_eq!(budget.price(VoiceKind(3)).most, 500);
    }
}
