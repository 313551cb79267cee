//! Overview of all keys: ranges since the last one, so that no short event is lost.

use scheduler::motion::KEYS;
use telemetry::Overview;

use super::block::{fault_number, flag};
use super::short;
use crate::adapters::tick_recorder::KeyRow;

#[derive(Clone, Copy, Debug)]
struct KeyActivity {
    /// Present values (m), (N).
    now: (f64, f64),
    position: (f64, f64),
    force: (f64, f64),
    mode: u8,
    flags: u8,
    fault: u8,
}

impl KeyActivity {
    const NOTHING: Self = Self {
        now: (0.0, 0.0),
        position: (0.0, 0.0),
        force: (0.0, 0.0),
        mode: u8::MAX,
        flags: flag::IDLE,
        fault: 0,
    };

    const fn begin(&mut self) {
        (self.position, self.force) = ((self.now.0, self.now.0), (self.now.1, self.now.1));
        // A key stays asleep and faulty until a row changes it; the other flags were events.
        self.flags &= flag::IDLE;
        self.fault = 0;
    }
}

#[derive(Debug)]
pub(super) struct OverviewBuilder {
    keys: Box<[KeyActivity]>,
    last: u64,
    ticks: u32,
}

impl OverviewBuilder {
    pub(super) fn new() -> Self {
        Self { keys: vec![KeyActivity::NOTHING; KEYS].into(), last: 0, ticks: 0 }
    }

    pub(super) fn push(&mut self, row: &KeyRow, flags: u8, mode: u8) {
        let Some(span) = self.keys.get_mut(usize::from(row.key)) else { return };
        let wider = |(low, high): (f64, f64), value: f64| (value.min(low), value.max(high));
        span.now = (row.sample.position, row.sent);
        span.position = wider(span.position, row.sample.position);
        span.force = wider(span.force, row.sent);
        span.mode = mode;
        // Asleep only if it is asleep at the end.
        span.flags = (span.flags & !flag::IDLE) | flags;
        span.fault = span.fault.max(fault_number(row.fault));
    }

    pub(super) const fn tick(&mut self, tick: u64) {
        self.last = tick;
        self.ticks = self.ticks.saturating_add(1);
    }

    pub(super) fn take(&mut self, dropped: u64) -> Option<Overview> {
        if self.ticks == 0 {
            return None;
        }
        let column =
            |of: fn(&KeyActivity) -> f64| self.keys.iter().map(|key| short(of(key))).collect();
        let bytes = |of: fn(&KeyActivity) -> u8| self.keys.iter().map(of).collect();
        let overview = Overview {
            tick: self.last,
            ticks: self.ticks,
            position_min: column(|key| key.position.0),
            position_max: column(|key| key.position.1),
            force_min: column(|key| key.force.0),
            force_max: column(|key| key.force.1),
            mode: bytes(|key| key.mode),
            flags: bytes(|key| key.flags),
            fault: bytes(|key| key.fault),
            dropped,
        };
        self.keys.iter_mut().for_each(KeyActivity::begin);
        self.ticks = 0;
        Some(overview)
    }
}
