//! Turns that came too late: what of them is kept, and counted.

use scheduler::motion::KEYS;
use scheduler::port::TickOutput;
use scheduler::slot::Slot;
use scheduler::voice::{Events, VoiceOutput};

use super::WaitLimit;
use super::worker::{Batch, boxed_array};

/// What became of lanes, counted since the start.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct LaneCounters {
    /// Ticks of a lane that were not ready in time, or not all of them.
    pub late: u64,
    /// Shares that came late and took more CPU time than a punctual tick has.
    pub late_own_work: u64,
    /// Shares that were not run at all, because their tick had passed.
    pub passed: u64,
}

/// What must not be lost of a key's turns that came too late to be felt.
#[derive(Clone, Debug, Default)]
pub struct LateResult {
    events: Events,
    fresh: bool,
}

impl LateResult {
    /// Keeps what `turn`, which came too late, says.
    pub fn keep(&mut self, turn: &VoiceOutput) {
        self.events.extend(&turn.events);
        self.fresh |= turn.fresh || turn.fault.is_some();
    }

    /// Puts what was kept before the events of `turn`.
    pub fn hand_over(&mut self, turn: &mut VoiceOutput) {
        let mut events = std::mem::take(&mut self.events);
        events.extend(&turn.events);
        turn.events = events;
        // A force that is held is the old one; the next that is not will be fresh.
        turn.fresh |= self.fresh && !turn.late;
        self.fresh &= turn.late;
    }

    fn is_empty(&self) -> bool {
        !self.fresh && self.events.is_empty()
    }
}

/// What is kept of all keys.
#[derive(Debug)]
pub(super) struct LateResults {
    kept: Box<[LateResult; KEYS]>,
    /// In which of the ticks before this one they were run, of those that came back since the last.
    ran: Box<[Option<u32>; KEYS]>,
    any: bool,
    pub(super) counters: LaneCounters,
}

impl LateResults {
    pub(super) fn new() -> Self {
        Self {
            kept: boxed_array(),
            ran: boxed_array(),
            any: false,
            counters: LaneCounters::default(),
        }
    }

    /// Keeps what `batch`, which came back too late for `tick` or before, says of its keys.
    pub(super) fn keep(&mut self, tick: u64, batch: &Batch) {
        self.any = true;
        for slot in &batch.slots {
            self.ran[slot.key()] = Some(slot.ran_before(tick));
        }
        let Some(cpu) = batch.ran else {
            self.counters.passed += 1;
            return;
        };
        match batch.lane_rules.patience {
            WaitLimit::Until { share, .. } if share < cpu => self.counters.late_own_work += 1,
            WaitLimit::Until { .. } | WaitLimit::Endless => {}
        }
        for key in batch.slots.iter().map(Slot::key) {
            self.kept[key].keep(&batch.turns[key]);
        }
    }

    /// Puts what was kept before the events of this tick, and says of late turns what is known.
    pub(super) fn hand_over(&mut self, output: &mut TickOutput<'_>) {
        if !self.any {
            return;
        }
        self.any = false;
        for (key, turn) in output.turns.iter_mut().enumerate() {
            self.kept[key].hand_over(turn);
            self.any |= !self.kept[key].is_empty();
            if let Some(ran) = self.ran[key].take().filter(|_| turn.late) {
                output.observed[key].pass(ran);
            }
        }
    }
}
