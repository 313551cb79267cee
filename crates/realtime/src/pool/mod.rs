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
mod latecomers;
mod swap;
mod worker;

#[cfg(test)]
mod tests;

use std::io;
use std::num::NonZeroUsize;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::thread;

use scheduler::motion::KEYS;
use scheduler::port::{Lanes, TickInput, TickOutput};
use scheduler::slot::{Slot, lane_of};
use scheduler::time::Nanos;
use scheduler::voice::{VoiceFault, VoiceOutput};

pub use fence::{BoxedVoice, PanicGuard};
pub use latecomers::{LaneCounters, LateResult};
pub use swap::{Refused, VoiceChange, VoiceSwaps};

use super::clock;
use super::thread::SchedulingPolicy;
use latecomers::LateResults;
use worker::{Lane, PoolState, Remote};

/// Looks at the rings between two offers of the processor to others.
const LOOKS_PER_YIELD: u64 = 64;

/// How long the tick waits for lanes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum WaitLimit {
    /// As long as it takes. No clock decides anything then, which virtual time needs.
    Endless,
    /// Until host time is `time`; a tick that begins when it is due has `share` of it.
    Until {
        /// When forces must be on their way.
        time: Nanos,
        /// What lanes have in a punctual tick.
        share: Nanos,
    },
}

impl WaitLimit {
    fn is_over(self) -> bool {
        match self {
            Self::Endless => false,
            Self::Until { time, .. } => time <= clock::monotonic(),
        }
    }
}

/// Runs voices on threads.
///
/// # Real-time
/// A tick allocates, locks and frees nothing, unless a voice panics, and ends by its patience.
#[derive(Debug)]
pub struct ThreadedLanes {
    inline: Lane,
    remotes: Vec<RemoteLane>,
    shared: Arc<PoolState>,
    patience: WaitLimit,
    latecomers: LateResults,
    times: LaneTimes,
}

/// A lane on another thread, and how it stands in this tick.
#[derive(Debug)]
struct RemoteLane {
    remote: Remote,
    stands: LaneState,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum LaneState {
    Running,
    Done {
        cpu: Nanos,
    },
    /// It was not given this tick yet: it still has two others.
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
        for (key, _voice) in &voices {
            has_voice[*key] = true;
        }
        let (outer_ends, inner_ends) = swap::rings(n_lanes, has_voice);
        let mut lanes: Vec<_> =
            inner_ends.into_iter().map(|swaps| Lane { slots: Vec::new(), swaps }).collect();
        for (key, voice) in voices {
            lanes[lane_of(key, n_lanes)].slots.push(Slot::new(key, PanicGuard::new(voice)));
        }
        let inline = lanes.remove(0);
        let mut pool = Self {
            inline,
            remotes: Vec::with_capacity(lanes.len()),
            shared: Arc::default(),
            patience: WaitLimit::Endless,
            latecomers: LateResults::new(),
            times: LaneTimes::default(),
        };
        for (number, lane) in (1..).zip(lanes) {
            let remote = Remote::start(number, lane, Arc::clone(&pool.shared), priority)?;
            pool.remotes.push(RemoteLane { remote, stands: LaneState::Behind });
        }
        Ok((pool, outer_ends))
    }

    /// Sets how long ticks wait for lanes from now on.
    pub const fn set_patience(&mut self, patience: WaitLimit) {
        self.patience = patience;
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
        self.latecomers.counters
    }

    /// How the system schedules the other lanes' threads.
    pub fn standings(&self) -> impl Iterator<Item = &SchedulingPolicy> {
        self.remotes.iter().map(|lane| &lane.remote.standing)
    }

    fn give(&mut self, input: &TickInput<'_>, output: &mut TickOutput<'_>) {
        self.shared.current.store(input.tick, Ordering::Release);
        for lane in &mut self.remotes {
            lane.stands = LaneState::Behind;
            lane.take_back(input.tick, output, &mut self.latecomers);
            lane.give(input, self.patience);
        }
    }

    /// Spins until all lanes are done or the time for it is over.
    fn collect(&mut self, input: &TickInput<'_>, output: &mut TickOutput<'_>) {
        for look in 1_u64.. {
            let waiting = self.look(input, output);
            if !waiting || self.patience.is_over() {
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

    /// Takes what is there; says whether a lane is still worth waiting for.
    ///
    /// One that is behind with earlier ticks is, only if there is no limit.
    fn look(&mut self, input: &TickInput<'_>, output: &mut TickOutput<'_>) -> bool {
        let mut waiting = false;
        for lane in &mut self.remotes {
            lane.take_back(input.tick, output, &mut self.latecomers);
            if lane.stands == LaneState::Behind && self.patience == WaitLimit::Endless {
                lane.give(input, self.patience);
                waiting = true;
            }
            waiting |= lane.stands == LaneState::Running;
        }
        waiting
    }

    /// Holds the forces of lanes that are not done.
    fn hold_late(&mut self, output: &mut TickOutput<'_>) {
        for lane in &self.remotes {
            let instead: fn(&mut VoiceOutput) = match lane.stands {
                LaneState::Done { cpu } => {
                    self.times.slowest = self.times.slowest.max(cpu);
                    continue;
                }
                LaneState::Running | LaneState::Behind => {
                    self.latecomers.counters.late += 1;
                    VoiceOutput::hold
                }
                LaneState::Lost => |turn| turn.fail(VoiceFault::Panicked),
            };
            for &key in &lane.remote.keys {
                instead(&mut output.turns[key]);
                output.observed[key].pass(0);
            }
        }
    }
}

impl Lanes for ThreadedLanes {
    fn run(&mut self, input: &TickInput<'_>, output: &mut TickOutput<'_>) {
        if self.remotes.is_empty() {
            self.inline.run(input, output);
            return;
        }
        self.times = LaneTimes::default();
        self.give(input, output);

        let before = clock::thread_cpu();
        self.inline.run(input, output);
        let between = clock::thread_cpu();
        self.collect(input, output);
        let after = clock::thread_cpu();

        self.times.inline = between.since(before);
        self.times.waiting = after.since(between);
        self.hold_late(output);
        self.latecomers.hand_over(output.turns);
    }
}

impl RemoteLane {
    /// Gives the lane this tick, if it has a batch free; it is behind until then.
    fn give(&mut self, input: &TickInput<'_>, patience: WaitLimit) {
        if self.remote.give(input, patience) {
            self.stands = LaneState::Running;
        }
    }

    /// Takes back what the lane has finished.
    fn take_back(&mut self, tick: u64, output: &mut TickOutput<'_>, latecomers: &mut LateResults) {
        // Bounded by the lane's batches.
        while let Some(batch) = self.remote.take() {
            match batch.ran {
                Some(cpu) if batch.tick == tick => {
                    batch.write(&self.remote.keys, output);
                    self.stands = LaneState::Done { cpu };
                }
                Some(_) | None => latecomers.keep(&self.remote.keys, &batch),
            }
            self.remote.keep(batch);
        }
        if self.remote.is_lost() {
            self.stands = LaneState::Lost;
        }
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
