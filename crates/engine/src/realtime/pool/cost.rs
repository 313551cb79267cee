//! Cost of work, learned from the lanes.
//!
//! Each tick of each lane compares the expected cost of its turns with their processor time. A tick
//! moves a cost by a bounded step, so that an outlier counts no more than a usual tick. Steps are
//! fractions of the time since a cost was last learned, so that an old cost is soon given up.

use scheduler::slot::Slot;
use scheduler::time::Nanos;
use scheduler::voice::{Voice, VoiceOutput};
use scheduler::work::{
    LaneBudget, LaneClock, MAX_KINDS, NOMINAL_UNIT_NS, TURN_FRACTION, VoiceKind, WorkCosts,
};

use super::WaitLimit;
use crate::realtime::clock;

/// Time in which a cost that is off by a factor of e is given up (s).
const MEMORY: f64 = 20e-3;

/// Largest change of a cost in one tick, however long ago it was learned.
const MAX_STEP: f64 = 0.5;

/// Smallest cost of a unit or a turn (ns).
const MIN_COST: f64 = 0.1;

/// Fraction of a lane's time for voices at rest that wake up, beside those that move.
const AT_REST: f64 = 0.125;

/// Fraction of its time that lane 0 keeps, whatever a tick takes beside its lanes.
const MIN_INLINE: f64 = 0.25;

#[derive(Clone, Copy, Debug)]
pub(super) struct LaneWork {
    turns: u32,
    units: [(VoiceKind, u32); MAX_KINDS],
    n_kinds: usize,
}

impl LaneWork {
    pub(super) const NONE: Self =
        Self { turns: 0, units: [(VoiceKind(0), 0); MAX_KINDS], n_kinds: 0 };

    pub(super) fn add<V: Voice>(&mut self, slots: &mut [Slot<V>], turns: &[VoiceOutput]) {
        for slot in slots {
            let turn = &turns[slot.key()];
            self.turns += u32::from(!turn.waited);
            if 0 < turn.work.units {
                self.add_units(slot.kind(), turn.work.units);
            }
        }
    }

    /// Adds `units` of a kind, unless there is no room for another kind.
    fn add_units(&mut self, kind: VoiceKind, units: u32) {
        let known = self.units[..self.n_kinds].iter_mut().find(|(it, _)| *it == kind);
        if let Some((_, sum)) = known {
            *sum = sum.saturating_add(units);
        } else if let Some(entry) = self.units.get_mut(self.n_kinds) {
            *entry = (kind, units);
            self.n_kinds += 1;
        }
    }

    fn kinds(&self) -> &[(VoiceKind, u32)] {
        &self.units[..self.n_kinds]
    }
}

/// Learned time (ns).
#[derive(Clone, Copy, Debug)]
struct LearnedTime {
    ns: f64,
    tick: u64,
    samples: u32,
}

impl LearnedTime {
    const fn new(ns: f64, tick: u64) -> Self {
        Self { ns, tick, samples: 1 }
    }

    /// Moves towards a measurement in `tick` of `period` (s): the whole took `ratio` times the
    /// expected time, and this time is the fraction `weight` of it.
    fn follow(&mut self, ratio: f64, weight: f64, (tick, period): (u64, f64)) {
        let passed = tick.saturating_sub(self.tick).max(1) as f64 * period;
        let early = 1.0 / f64::from(self.samples.saturating_add(1));
        let step = (passed / MEMORY).max(early).min(MAX_STEP);
        let change = ratio.clamp(1.0 / (1.0 + step), 1.0 + step) - 1.0;
        self.ns = (self.ns * (1.0 + weight * change)).max(MIN_COST);
        (self.tick, self.samples) = (tick, self.samples.saturating_add(1));
    }
}

#[derive(Debug)]
pub(super) struct CostModel {
    learned: WorkCosts,
    /// Costs for virtual time, where no clock decides.
    constant: WorkCosts,
    turn: Option<LearnedTime>,
    /// Unit of work of each kind, in the order of `learned`.
    units: [Option<(VoiceKind, LearnedTime)>; MAX_KINDS],
    beside: LearnedTime,
}

impl CostModel {
    pub(super) const fn new() -> Self {
        Self {
            learned: WorkCosts::unknown(),
            constant: WorkCosts::constant(NOMINAL_UNIT_NS),
            turn: None,
            units: [None; MAX_KINDS],
            beside: LearnedTime::new(MIN_COST, 0),
        }
    }

    /// Sets the initial cost of a unit of a kind (ns), before the first tick.
    pub(super) fn expect(&mut self, kind: VoiceKind, unit: f64) {
        self.begin(kind, LearnedTime::new(unit.max(MIN_COST), 0));
    }

    /// Sets the cost of a unit for virtual time (ns).
    pub(super) const fn set_constant(&mut self, unit: f64) {
        self.constant = WorkCosts::constant(unit);
    }

    pub(super) const fn costs(&self, patience: WaitLimit) -> &WorkCosts {
        match patience {
            WaitLimit::Endless => &self.constant,
            WaitLimit::Until { .. } => &self.learned,
        }
    }

    /// Learns from a lane that did `work` in `cpu`, in `tick` of `period` (s).
    pub(super) fn learn(&mut self, work: &LaneWork, cpu: Nanos, at: (u64, f64)) {
        if work.turns == 0 || cpu == Nanos::ZERO {
            return;
        }
        let cpu = cpu.as_u64() as f64;
        if work.kinds().is_empty() {
            self.learn_turns(work, cpu, at);
        } else if work.kinds().iter().any(|(kind, _)| self.learned.unit(*kind).is_none()) {
            self.begin_kinds(work, cpu, at);
        } else {
            self.learn_units(work, cpu, at);
        }
    }

    fn learn_turns(&mut self, work: &LaneWork, cpu: f64, at: (u64, f64)) {
        let each = cpu / f64::from(work.turns);
        let turn = self.turn.get_or_insert(LearnedTime::new(each, at.0));
        turn.follow(each / turn.ns, 1.0, at);
        self.learned.turn = turn.ns;
    }

    fn learn_units(&mut self, work: &LaneWork, cpu: f64, at: (u64, f64)) {
        let expected = self.expected(work);
        for (index, entry) in self.units.iter_mut().enumerate() {
            let Some((kind, unit)) = entry else { continue };
            let Some((_, units)) = work.kinds().iter().find(|(it, _)| it == kind) else { continue };
            unit.follow(cpu / expected, f64::from(*units) * unit.ns / expected, at);
            self.learned.set(index, *kind, unit.ns);
        }
    }

    /// Divides the cost of units of unknown kinds evenly, as their first value.
    fn begin_kinds(&mut self, work: &LaneWork, cpu: f64, at: (u64, f64)) {
        let expected = self.expected(work);
        let is_unknown = |(kind, _): &&(VoiceKind, u32)| self.learned.unit(*kind).is_none();
        let unknown = work.kinds().iter().filter(is_unknown);
        let units: f64 = unknown.clone().map(|(_, units)| f64::from(*units)).sum();
        let unit = ((cpu - expected) / units).max(MIN_COST);
        let mut kinds = [VoiceKind::default(); MAX_KINDS];
        let n_kinds =
            kinds.iter_mut().zip(unknown).map(|(place, (kind, _))| *place = *kind).count();
        for kind in &kinds[..n_kinds] {
            self.begin(*kind, LearnedTime::new(unit, at.0));
        }
    }

    /// Returns the expected cost of a lane's work (ns), as far as it is known.
    fn expected(&self, work: &LaneWork) -> f64 {
        let units = work.kinds().iter().filter_map(|(kind, units)| {
            self.learned.unit(*kind).map(|unit| f64::from(*units) * unit)
        });
        f64::from(work.turns) * self.learned.turn.max(MIN_COST) + units.sum::<f64>()
    }

    pub(super) fn learn_beside(&mut self, cpu: Nanos, at: (u64, f64)) {
        let ratio = cpu.as_u64() as f64 / self.beside.ns;
        self.beside.follow(ratio, 1.0, at);
    }

    /// Adds a kind; without room it replaces the kind that was learned longest ago.
    fn begin(&mut self, kind: VoiceKind, unit: LearnedTime) {
        let free = self.units.iter().position(Option::is_none);
        let index = free.or_else(|| {
            let learned = |index: &usize| self.units[*index].map(|(_, unit)| unit.tick);
            (0..MAX_KINDS).min_by_key(learned)
        });
        let Some(index) = index else { return };
        self.units[index] = Some((kind, unit));
        self.learned.set(index, kind, unit.ns);
    }

    /// Returns lane 0's time (ns): a lane's, less that beside the lanes where a clock decides.
    pub(super) fn inline_time(&self, patience: WaitLimit, hz: u32) -> f64 {
        let time = patience.lane_time(hz);
        match patience {
            WaitLimit::Endless => time,
            WaitLimit::Until { .. } => (time - self.beside.ns).max(MIN_INLINE * time),
        }
    }
}

/// A lane's time in a tick by its thread's clock.
#[derive(Clone, Copy, Debug)]
pub(super) struct CpuClock {
    began: Nanos,
    /// Time of the lane (ns); infinite where no clock decides.
    time: f64,
}

impl LaneClock for CpuClock {
    fn left(&mut self) -> f64 {
        if self.time < f64::INFINITY {
            self.time - clock::thread_cpu().since(self.began).as_u64() as f64
        } else {
            self.time
        }
    }
}

/// Returns the budget of a lane's moving or resting voices: `time` (ns) from the reading `began`.
pub(super) fn budget(
    costs: &WorkCosts,
    (patience, is_moving): (WaitLimit, bool),
    time: f64,
    began: Nanos,
) -> LaneBudget<'_, CpuClock> {
    let of_share = match patience.share() {
        None => f64::INFINITY,
        Some(_) if is_moving => time,
        Some(_) => AT_REST * time,
    };
    LaneBudget::new(costs, CpuClock { began, time: of_share }, of_share, TURN_FRACTION * time)
}
