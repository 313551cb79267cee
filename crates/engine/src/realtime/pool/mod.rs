//! Voices on one or several threads.
//!
//! Lane 0 runs on the tick's own thread, every other lane on its own, started at set-up. With one
//! lane no thread, clock or atomic is involved.
//!
//! ```text
//! tick's thread                                lane n's thread
//!   swap voices, share them out
//!   give batches ─── ring ─── unpark ─────────▶ park
//!   run lane 0                                  run those awake, then those at rest
//!   collect     ◀─────────── ring ───────────── batches with turns
//! ```
//!
//! Voices travel with the batches and belong to the tick's thread between ticks. They are shared
//! out by their recent counted evaluations, one move in a tick, so that lanes end together: lanes
//! on other threads, which must wake up first, have less to do the longer lane 0 waits for them. A
//! voice's results do not depend on its lane.
//!
//! Collecting spins until all lanes are done or its time is over. Voices that are not done keep
//! their previous forces, marked late: those at rest first, since they are run last. When their
//! turns arrive later, the forces are dropped, by tick number, but the note events are passed on
//! with the next tick: a lost damper would leave a note hanging.

mod balance;
mod cost;
mod fence;
mod latecomers;
mod share;
mod swap;
mod worker;

#[cfg(test)]
mod tests;

use std::io;
use std::num::NonZeroUsize;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::thread;

use scheduler::lane::run_slots;
use scheduler::motion::KEYS;
use scheduler::port::{Lanes, TickInput, TickOutput};
use scheduler::slot::{Slot, lane_of};
use scheduler::time::Nanos;
use scheduler::voice::VoiceOutput;
use scheduler::work::VoiceKind;

pub use fence::{BoxedVoice, PanicGuard};
pub use latecomers::{LaneCounters, LateResult};
pub use swap::{Refused, VoiceChange, VoiceSwaps};

use super::clock;
use super::thread::{SchedulingPolicy, ThreadPlan};
use balance::MeasuredWork;
use cost::{CostModel, LaneWork};
use latecomers::LateResults;
use share::RemoteLane;
use swap::InnerEnd;
use worker::{AWAKE, Batch, LaneRules, PoolState, Remote};

/// Checks of the rings between two offers of the processor to other threads.
const LOOKS_PER_YIELD: u64 = 64;

/// Part of a period kept free after the lanes, for safety, sending and observing: a tenth.
pub(super) const RESERVE: u64 = 10;

/// Time that the tick waits for lanes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum WaitLimit {
    /// No limit. No clock decides anything then, as virtual time requires.
    Endless,
    /// Until host time `time`.
    Until { time: Nanos, share: Nanos },
}

impl WaitLimit {
    fn share(self) -> Option<Nanos> {
        match self {
            Self::Until { share, .. } => Some(share).filter(|share| *share != Nanos::ZERO),
            Self::Endless => None,
        }
    }

    /// Returns the time of a lane in a tick of a rate `hz` (ns).
    const fn lane_time(self, hz: u32) -> f64 {
        match self {
            Self::Until { share, .. } if share.as_u64() != 0 => share.as_u64() as f64,
            Self::Until { .. } | Self::Endless => (1.0 - 1.0 / RESERVE as f64) * 1e9 / hz as f64,
        }
    }

    fn is_over(self) -> bool {
        match self {
            Self::Endless => false,
            Self::Until { time, .. } => time <= clock::monotonic(),
        }
    }
}

/// Lanes of voices on one or several threads.
///
/// # Real-time
/// A tick allocates, locks and frees nothing, unless a voice panics, and ends by its patience.
#[derive(Debug)]
pub struct ThreadedLanes {
    inline: Vec<Slot<PanicGuard>>,
    remotes: Vec<RemoteLane>,
    swaps: InnerEnd,
    measured: MeasuredWork,
    cost: Box<CostModel>,
    shared: Arc<PoolState>,
    patience: WaitLimit,
    latecomers: LateResults,
    times: LaneTimes,
    /// Tick that is run, and its period (s).
    at: (u64, f64),
}

#[derive(Clone, Copy, Debug, Default)]
struct LaneTimes {
    inline: Nanos,
    waiting: Nanos,
    slowest: Nanos,
}

impl ThreadedLanes {
    /// Shares `voices`, each with its key, among `n_lanes` and starts their threads by `plan`.
    /// Returns the lanes and the means to change voices later.
    ///
    /// # Errors
    /// If the system provides no thread.
    ///
    /// # Panics
    /// If a key does not exist.
    pub fn start(
        voices: Vec<(usize, BoxedVoice)>,
        n_lanes: NonZeroUsize,
        plan: &ThreadPlan,
    ) -> io::Result<(Self, VoiceSwaps)> {
        let n_lanes = n_lanes.get();
        let mut has_voice = [false; KEYS];
        for (key, _voice) in &voices {
            has_voice[*key] = true;
        }
        let (outer, swaps) = swap::rings(has_voice);
        let mut lanes: Vec<_> = (0..n_lanes).map(|_| Vec::with_capacity(KEYS)).collect();
        for (key, voice) in voices {
            lanes[lane_of(key, n_lanes)].push(Slot::new(key, PanicGuard::new(voice)));
        }
        let mut pool = Self {
            inline: lanes.remove(0),
            remotes: Vec::with_capacity(lanes.len()),
            swaps,
            measured: MeasuredWork::new(),
            cost: Box::new(CostModel::new()),
            shared: Arc::default(),
            patience: WaitLimit::Endless,
            latecomers: LateResults::new(),
            times: LaneTimes::default(),
            at: (0, 1e-3),
        };
        for (number, slots) in (1..).zip(lanes) {
            let remote = Remote::start(number, Arc::clone(&pool.shared), plan.clone())?;
            let batches = [Batch::new(AWAKE, slots), Batch::new(AWAKE + 1, Vec::new())];
            pool.remotes.push(RemoteLane::new(remote, batches));
        }
        Ok((pool, outer))
    }

    /// Sets the cost of a unit of work where no clock decides (ns), as in virtual time.
    pub const fn set_constant_cost(&mut self, unit: f64) {
        self.cost.set_constant(unit);
    }

    /// Sets the initial, measured cost of a unit of work of a `kind` of voice (ns).
    pub fn expect_cost(&mut self, kind: VoiceKind, unit: f64) {
        self.cost.expect(kind, unit);
    }

    pub const fn set_patience(&mut self, patience: WaitLimit) {
        self.patience = patience;
    }

    /// Returns the CPU time of the last tick, with `cpu` that of its own thread; the part beside
    /// the lanes is kept for their budgets. Waiting for lanes does not count; the excess of a lane
    /// that took longer than lane 0 does.
    pub fn work_of_tick(&mut self, cpu: Nanos) -> Nanos {
        let LaneTimes { inline, waiting, slowest } = self.times;
        let own = cpu.since(waiting);
        self.cost.learn_beside(own.since(inline), self.at);
        own.after(slowest.since(inline))
    }

    pub const fn counters(&self) -> LaneCounters {
        self.latecomers.counters
    }

    pub fn standings(&self) -> impl Iterator<Item = &SchedulingPolicy> {
        self.remotes.iter().map(|lane| &lane.remote.standing)
    }

    fn run_inline(&mut self, input: &TickInput<'_>, output: &mut TickOutput<'_>) {
        let costs = self.cost.costs(self.patience);
        let time = self.cost.inline_time(self.patience, input.rules.hz);
        let is_clocked = !self.remotes.is_empty() || self.patience != WaitLimit::Endless;
        let before = if is_clocked { clock::thread_cpu() } else { Nanos::ZERO };
        let budget = cost::budget(costs, (self.patience, true), time, before);
        run_slots(&mut self.inline, budget, input, output);
        if is_clocked {
            self.times.inline = clock::thread_cpu().since(before);
        }
    }

    fn learn_costs(&mut self, turns: &[VoiceOutput; KEYS]) {
        if self.patience.share().is_none() {
            return;
        }
        let mut work = LaneWork::NONE;
        work.add(&mut self.inline, turns);
        self.cost.learn(&work, self.times.inline, self.at);
        for lane in &mut self.remotes {
            let cpu = lane.cpu();
            self.cost.learn(&lane.work(turns), cpu, self.at);
        }
    }

    /// Moves one voice from the busiest lane to the least busy one, of those that are not late.
    fn share_out(&mut self) {
        self.remotes.iter_mut().for_each(|lane| lane.sort(&self.measured));
        let others = self.remotes.iter().map(|lane| lane.load(&self.measured));
        let loads = std::iter::once(Some(self.measured.of(&self.inline))).chain(others);
        let loads = loads.enumerate().filter_map(|(lane, load)| Some((load?, lane)));
        let Some((most, from)) = loads.clone().max() else { return };
        let Some((least, to)) = loads.min() else { return };
        let measured = &self.measured;
        let choice = slots_of(&mut self.inline, &mut self.remotes, from)
            .and_then(|slots| Some(slots.swap_remove(measured.to_move(slots, most, least)?)));
        let Some(slot) = choice else { return };
        if let Some(slots) = slots_of(&mut self.inline, &mut self.remotes, to) {
            // There is room for all keys, so it never grows.
            slots.push(slot);
        }
    }

    fn give(&mut self, input: &TickInput<'_>) {
        self.shared.current.store(input.tick, Ordering::Release);
        let rules = self.lane_rules(input);
        for lane in &mut self.remotes {
            lane.give(input, &rules);
        }
    }

    const fn lane_rules(&self, input: &TickInput<'_>) -> LaneRules {
        LaneRules {
            patience: self.patience,
            costs: *self.cost.costs(self.patience),
            time: self.patience.lane_time(input.rules.hz),
        }
    }

    fn collect(&mut self, input: &TickInput<'_>, output: &mut TickOutput<'_>) {
        let rules = self.lane_rules(input);
        for look in 1_u64.. {
            let is_over = !self.look(input, &rules, output) || self.patience.is_over();
            if is_over {
                return;
            }
            if look.is_multiple_of(LOOKS_PER_YIELD) {
                // A lane of equal priority may be waiting for this processor.
                thread::yield_now();
            } else {
                std::hint::spin_loop();
            }
        }
    }

    /// Receives finished shares; returns `true` if a lane is still worth waiting for.
    fn look(
        &mut self,
        input: &TickInput<'_>,
        rules: &LaneRules,
        output: &mut TickOutput<'_>,
    ) -> bool {
        let mut waiting = false;
        for lane in &mut self.remotes {
            lane.take_back(input.tick, output, &mut self.latecomers);
            // A share that just came back from an earlier tick may still be in time for this one.
            lane.give(input, rules);
            waiting |= lane.is_awaited(self.patience);
        }
        waiting
    }

    fn hold_late(&mut self, output: &mut TickOutput<'_>) {
        for lane in &self.remotes {
            self.times.slowest = self.times.slowest.max(lane.cpu());
            self.latecomers.counters.late += u64::from(lane.hold_late(output));
        }
    }
}

/// Returns the first-run slots of lane `number`, if they are at home.
fn slots_of<'a>(
    inline: &'a mut Vec<Slot<PanicGuard>>,
    remotes: &'a mut [RemoteLane],
    number: usize,
) -> Option<&'a mut Vec<Slot<PanicGuard>>> {
    match number.checked_sub(1) {
        None => Some(inline),
        Some(remote) => remotes.get_mut(remote)?.awake(),
    }
}

impl Lanes for ThreadedLanes {
    fn run(&mut self, input: &TickInput<'_>, output: &mut TickOutput<'_>) {
        self.times = LaneTimes::default();
        self.at = (input.tick, 1.0 / f64::from(input.rules.hz));
        if self.remotes.is_empty() {
            self.swaps.apply(&mut self.inline, &mut [], output.observed);
            self.run_inline(input, output);
            self.learn_costs(output.turns);
            return;
        }
        for lane in &mut self.remotes {
            lane.begin(input.tick, output, &mut self.latecomers);
        }
        self.swaps.apply(&mut self.inline, &mut self.remotes, output.observed);
        self.share_out();
        self.give(input);

        self.run_inline(input, output);
        let before = clock::thread_cpu();
        self.collect(input, output);
        self.times.waiting = clock::thread_cpu().since(before);
        self.hold_late(output);
        self.learn_costs(output.turns);
        self.latecomers.hand_over(output);
        self.measured.learn(output.turns);
        if self.patience.share().is_some() {
            self.measured.learn_lag(self.times.inline, self.times.waiting);
        }
    }
}

impl Drop for ThreadedLanes {
    /// Ends the lanes' threads and waits for them; not for the tick.
    fn drop(&mut self) {
        self.shared.stop.store(true, Ordering::Release);
        for lane in self.remotes.drain(..) {
            // A lane that panicked has been reported as faulty voices already.
            let _ended_well = lane.remote.join();
        }
    }
}
