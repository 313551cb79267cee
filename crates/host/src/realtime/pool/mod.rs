//! Voices on one or several threads.
//!
//! Lane 0 runs on the tick's own thread; every other lane on a thread of its own, started at
//! set-up, that owns its voices. With one lane no thread, clock or atomic is involved.
//!
//! ```text
//! tick's thread                                lane n's thread
//!   give batch ──── ring ──── unpark ─────────▶ park
//!   run lane 0                                  swap voices, run slots
//!   collect    ◀──────────── ring ───────────── batch with turns
//! ```
//!
//! Collecting spins until all lanes are done or the time for it is over. A lane that is not
//! done keeps its previous forces, marked late. When its turns arrive later, their forces are
//! dropped, by tick number, but what happened to the notes is passed on with the next tick:
//! a lost damper would leave a note hanging.

mod fence;
mod swap;
mod worker;

#[cfg(test)]
mod tests;

use std::io;
use std::num::NonZeroUsize;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::thread;

use scheduler::motion::{KEYS, KeySample};
use scheduler::port::Lanes;
use scheduler::slot::{Slot, lane_of};
use scheduler::time::Nanos;
use scheduler::voice::{Events, Turn, VoiceFault};

pub use fence::BoxedVoice;
pub use swap::{Refused, VoiceSwaps};

use super::clock;
use super::thread::Standing;
use fence::Fenced;
use worker::{Batch, Lane, Remote, Shared, boxed_array};

/// Looks at the rings between two offers of the processor to others.
const LOOKS_PER_YIELD: u32 = 64;

/// What became of lanes, counted since the start.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct LaneCounters {
    /// A lane's share of a tick that was not ready in time.
    pub late: u64,
    /// Of these, ones that took more CPU time than they had; known when they arrive.
    pub late_own_work: u64,
    /// Shares that were not run at all, because their tick had passed.
    pub passed: u64,
}

/// Fills the scheduler's `Lanes` port with threads.
#[derive(Debug)]
pub struct ThreadedLanes {
    inline: Lane,
    remotes: Vec<RemoteLane>,
    shared: Arc<Shared>,
    until: Option<Nanos>,
    late_turns: LateTurns,
    counters: LaneCounters,
    times: LaneTimes,
}

/// A lane on another thread, and how it stands in this tick.
#[derive(Debug)]
struct RemoteLane {
    remote: Remote,
    stands: Stands,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Stands {
    Running,
    Done,
    /// It was not given this tick: it still has two others.
    Behind,
    Lost,
}

/// CPU times of the last tick that concern more than its own thread.
#[derive(Clone, Copy, Debug, Default)]
struct LaneTimes {
    inline: Nanos,
    waiting: Nanos,
    slowest: Nanos,
}

impl ThreadedLanes {
    /// Shares `voices`, each with its key, among `n_lanes` and starts their threads at
    /// `priority`.
    ///
    /// The second value is the way to put in other voices later.
    ///
    /// # Errors
    /// If the system gives no thread.
    ///
    /// # Panics
    /// If there is no such key.
    pub fn start(
        voices: Vec<(usize, BoxedVoice)>,
        n_lanes: NonZeroUsize,
        priority: Option<u8>,
    ) -> io::Result<(Self, VoiceSwaps)> {
        let n_lanes = n_lanes.get();
        let mut has_voice = [false; KEYS];
        voices.iter().for_each(|(key, _voice)| has_voice[*key] = true);
        let (outer_ends, inner_ends) = swap::rings(n_lanes, has_voice);
        let mut lanes: Vec<_> =
            inner_ends.into_iter().map(|swaps| Lane { slots: Vec::new(), swaps }).collect();
        for (key, voice) in voices {
            lanes[lane_of(key, n_lanes)].slots.push(Slot::new(key, Fenced::new(voice)));
        }
        let inline = lanes.remove(0);
        let mut pool = Self {
            inline,
            remotes: Vec::with_capacity(lanes.len()),
            shared: Arc::default(),
            until: None,
            late_turns: LateTurns::new(),
            counters: LaneCounters::default(),
            times: LaneTimes::default(),
        };
        for (number, lane) in (1..).zip(lanes) {
            let remote = Remote::start(number, lane, Arc::clone(&pool.shared), priority)?;
            pool.remotes.push(RemoteLane { remote, stands: Stands::Done });
        }
        Ok((pool, outer_ends))
    }

    /// Waits for lanes at most until host time is `until`; `None` for as long as it takes.
    ///
    /// Without a limit no clock decides anything, which virtual time needs.
    pub const fn wait_until(&mut self, until: Option<Nanos>) {
        self.until = until;
    }

    /// CPU time that the last tick needed, if its own thread used `cpu`.
    ///
    /// Time spent waiting for lanes does not count; a lane that took longer than lane 0 does.
    pub const fn work_of_tick(&self, cpu: Nanos) -> Nanos {
        let overhang = self.times.slowest.since(self.times.inline);
        cpu.since(self.times.waiting).after(overhang)
    }

    /// What became of lanes so far.
    pub const fn counters(&self) -> LaneCounters {
        self.counters
    }

    /// How the system schedules the other lanes' threads.
    pub fn standings(&self) -> impl Iterator<Item = &Standing> {
        self.remotes.iter().map(|lane| &lane.remote.standing)
    }

    fn give(&mut self, tick: u64, samples: &[KeySample; KEYS], turns: &mut [Turn; KEYS]) {
        self.shared.current.store(tick, Ordering::Release);
        let now = clock::monotonic();
        let allowed = self.until.map(|until| until.since(now));
        for lane in &mut self.remotes {
            lane.take_back(tick, turns, &mut self.late_turns, &mut self.counters);
            lane.stands = if lane.remote.give(tick, samples, allowed) {
                Stands::Running
            } else {
                Stands::Behind
            };
        }
    }

    /// Spins until all lanes are done or the time for it is over.
    fn collect(&mut self, tick: u64, turns: &mut [Turn; KEYS]) {
        for look in 1_u32.. {
            let mut running = false;
            for lane in &mut self.remotes {
                let ran = lane.take_back(tick, turns, &mut self.late_turns, &mut self.counters);
                self.times.slowest = self.times.slowest.max(ran);
                running |= lane.stands == Stands::Running;
            }
            let time_is_over = || self.until.is_some_and(|until| until <= clock::monotonic());
            if !running || time_is_over() {
                return;
            }
            if look.is_multiple_of(LOOKS_PER_YIELD) {
                // A lane of the same priority may be waiting for this very processor.
                thread::yield_now();
            } else {
                std::hint::spin_loop();
            }
        }
    }

    /// Holds the turns of lanes that are not done.
    fn hold_late(&mut self, turns: &mut [Turn; KEYS]) {
        for lane in &self.remotes {
            match lane.stands {
                Stands::Done => continue,
                Stands::Running | Stands::Behind => self.counters.late += 1,
                Stands::Lost => {}
            }
            for &key in &lane.remote.keys {
                turns[key] = match lane.stands {
                    Stands::Lost => Turn::faulty(VoiceFault::Panicked),
                    Stands::Done | Stands::Running | Stands::Behind => turns[key].held(),
                };
            }
        }
    }
}

impl Lanes for ThreadedLanes {
    fn run(&mut self, tick: u64, samples: &[KeySample; KEYS], turns: &mut [Turn; KEYS]) {
        if self.remotes.is_empty() {
            self.inline.run(tick, samples, turns);
            return;
        }
        self.times = LaneTimes::default();
        self.give(tick, samples, turns);

        let before = clock::thread_cpu();
        self.inline.run(tick, samples, turns);
        let between = clock::thread_cpu();
        self.collect(tick, turns);
        let after = clock::thread_cpu();

        self.times.inline = between.since(before);
        self.times.waiting = after.since(between);
        self.hold_late(turns);
        self.late_turns.hand_over(turns);
    }
}

impl RemoteLane {
    /// Takes back what the lane has finished; returns the CPU time of this tick's share.
    fn take_back(
        &mut self,
        tick: u64,
        turns: &mut [Turn; KEYS],
        late_turns: &mut LateTurns,
        counters: &mut LaneCounters,
    ) -> Nanos {
        let mut this_tick = Nanos::ZERO;
        while let Some(batch) = self.remote.take() {
            match batch.ran {
                Some(cpu) if batch.tick == tick => {
                    self.remote.keys.iter().for_each(|&key| turns[key] = batch.turns[key]);
                    self.stands = Stands::Done;
                    this_tick = cpu;
                }
                Some(cpu) => {
                    late_turns.keep(&self.remote.keys, &batch);
                    let own = batch.allowed.is_some_and(|allowed| allowed < cpu);
                    counters.late_own_work += u64::from(own);
                }
                None => counters.passed += 1,
            }
            self.remote.keep(batch);
        }
        if self.remote.is_lost() {
            self.stands = Stands::Lost;
        }
        this_tick
    }
}

impl Drop for ThreadedLanes {
    /// Ends the lanes' threads and waits for them; not for the tick.
    fn drop(&mut self) {
        self.shared.stop.store(true, Ordering::Release);
        for lane in self.remotes.drain(..) {
            // One that panicked has been reported as faulty voices all along.
            let _ended_well = lane.remote.join();
        }
    }
}

/// What must not be lost of turns that came too late to be felt.
#[derive(Debug)]
struct LateTurns {
    events: Box<[Events; KEYS]>,
    fresh: [bool; KEYS],
    any: bool,
}

impl LateTurns {
    fn new() -> Self {
        Self { events: boxed_array(), fresh: [false; KEYS], any: false }
    }

    fn keep(&mut self, keys: &[usize], batch: &Batch) {
        for &key in keys {
            let turn = &batch.turns[key];
            self.events[key].extend(&turn.events);
            self.fresh[key] |= turn.fresh || turn.fault.is_some();
            self.any |= self.fresh[key] || !self.events[key].is_empty();
        }
    }

    /// Puts what was kept before the events of this tick.
    fn hand_over(&mut self, turns: &mut [Turn; KEYS]) {
        if !self.any {
            return;
        }
        self.any = false;
        for (key, turn) in turns.iter_mut().enumerate() {
            let mut events = std::mem::take(&mut self.events[key]);
            events.extend(&turn.events);
            turn.events = events;
            // A force that is held is the old one; the next that is not will be fresh.
            let fresh = self.fresh[key];
            turn.fresh |= fresh && !turn.late;
            self.fresh[key] = fresh && turn.late;
            self.any |= self.fresh[key];
        }
    }
}
