//! Late turns: their notes are kept, and they are counted.

use scheduler::motion::KEYS;
use scheduler::port::TickOutput;
use scheduler::slot::Slot;
use scheduler::voice::{Events, VoiceOutput};

use super::WaitLimit;
use super::worker::{Batch, boxed_array};

/// Counts of late shares since the start.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct LaneCounters {
    /// Ticks of a lane with a share that was not ready in time.
    pub late: u64,
    /// Late shares that took more CPU time than a punctual tick has.
    pub late_own_work: u64,
    /// Shares that were not run because their tick had passed.
    pub passed: u64,
}

/// Note events and limit of a key's late turn, and whether its force must count as fresh.
#[derive(Clone, Debug, Default)]
pub struct LateResult {
    events: Events,
    fresh: bool,
    limit: u32,
}

impl LateResult {
    pub fn keep(&mut self, turn: &VoiceOutput) {
        self.events.extend(&turn.events);
        self.fresh |= turn.fresh || turn.fault.is_some();
        self.limit = turn.limit;
    }

    /// Inserts the kept events before those of `turn`.
    pub fn hand_over(&mut self, turn: &mut VoiceOutput) {
        let mut events = std::mem::take(&mut self.events);
        events.extend(&turn.events);
        turn.events = events;
        turn.late_limit = std::mem::take(&mut self.limit);
        // A held force is the old one; the next force that is not held will be fresh.
        turn.fresh |= self.fresh && !turn.late;
        self.fresh &= turn.late;
    }

    fn is_empty(&self) -> bool {
        !self.fresh && self.limit == 0 && self.events.is_empty()
    }
}

#[derive(Debug)]
pub(super) struct LateResults {
    kept: Box<[LateResult; KEYS]>,
    /// For keys that came back since the last tick: the earlier ticks in which they were run.
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

    /// Keeps the results of `batch`, which came back too late for `tick` or earlier.
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

    /// Inserts the kept events before those of this tick, and completes the late turns.
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
