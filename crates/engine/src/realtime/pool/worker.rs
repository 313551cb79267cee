//! Lane on its own thread: batches of a tick travel there and back, with their voices.
//!
//! Each lane has two batches, allocated at set-up: the moving voices, and those at rest. The tick
//! fills and sends them; the lane runs them in this order and sends each back when it is done, so a
//! lane that misses its time has computed moving voices first. A batch with a past tick is sent
//! back unrun, so that a delayed lane joins the present instead of running after it.

use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc;
use std::thread::{self, JoinHandle};

use rtrb::{Consumer, Producer, RingBuffer};
use scheduler::lane::run_slots;
use scheduler::motion::{KEYS, KeySample};
use scheduler::observation::{FollowedKeys, VoiceObservation};
use scheduler::overload::Simplifications;
use scheduler::port::{TickInput, TickOutput, TickRules};
use scheduler::slot::Slot;
use scheduler::time::Nanos;
use scheduler::voice::VoiceOutput;
use scheduler::work::WorkCosts;

use super::WaitLimit;
use super::cost;
use super::fence::PanicGuard;
use crate::realtime::thread::{SchedulingPolicy, ThreadPlan};
use crate::realtime::{clock, memory};

/// Shares of a lane: [`AWAKE`], and the voices at rest.
pub(super) const SHARES: usize = 2;

pub(super) const AWAKE: usize = 0;

/// Stack of a lane's thread; all of it is locked into memory.
const STACK_BYTES: usize = 1024 * 1024;

#[derive(Debug)]
pub(super) struct Batch {
    pub(super) share: usize,
    /// Voices, with room for all keys.
    pub(super) slots: Vec<Slot<PanicGuard>>,
    pub(super) tick: u64,
    samples: [KeySample; KEYS],
    followed: FollowedKeys,
    rules: TickRules,
    /// Turns, valid for the lane's keys if the batch was run.
    pub(super) turns: Box<[VoiceOutput; KEYS]>,
    /// Observations, valid for keys observed in this tick.
    observed: Box<[VoiceObservation; KEYS]>,
    /// CPU time of the lane; `None` if the batch came too late to be run.
    pub(super) ran: Option<Nanos>,
    pub(super) lane_rules: LaneRules,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct LaneRules {
    pub(super) patience: WaitLimit,
    pub(super) costs: WorkCosts,
    /// Time of the lane (ns).
    pub(super) time: f64,
}

impl Batch {
    pub(super) fn new(share: usize, mut slots: Vec<Slot<PanicGuard>>) -> Box<Self> {
        slots.reserve_exact(KEYS - slots.len());
        Box::new(Self {
            share,
            slots,
            tick: 0,
            samples: [KeySample::default(); KEYS],
            followed: FollowedKeys::NONE,
            rules: TickRules { simplified: Simplifications::NONE, hz: 1000 },
            turns: boxed_array(),
            observed: boxed_array(),
            ran: None,
            lane_rules: LaneRules {
                patience: WaitLimit::Endless,
                costs: WorkCosts::unknown(),
                time: f64::INFINITY,
            },
        })
    }

    /// Runs each voice for the batch's tick, which began when the thread's clock read `began`.
    fn run(&mut self, began: Nanos) {
        let Self { tick, samples, followed, rules, slots, turns, observed, lane_rules, .. } = self;
        let input = TickInput { tick: *tick, samples, followed: *followed, rules: *rules };
        let LaneRules { patience, costs, time } = lane_rules;
        let budget = cost::budget(costs, (*patience, self.share == AWAKE), *time, began);
        run_slots(slots, budget, &input, &mut TickOutput { turns, observed });
    }

    pub(super) fn write(&self, output: &mut TickOutput<'_>) {
        for key in self.slots.iter().map(Slot::key) {
            let (turn, seen) = (&self.turns[key], &self.observed[key]);
            output.turns[key] = *turn;
            if turn.is_seen(key, self.followed) {
                output.observed[key] = *seen;
            } else {
                output.observed[key].pass(seen.ran);
            }
        }
    }
}

/// State shared by the tick's thread and all lanes, besides the rings.
#[derive(Debug, Default)]
pub(super) struct PoolState {
    pub(super) current: AtomicU64,
    /// `true` if lanes shall end at their next check.
    pub(super) stop: AtomicBool,
}

#[derive(Debug)]
pub(super) struct Remote {
    pub(super) standing: SchedulingPolicy,
    todo: Producer<Box<Batch>>,
    done: Consumer<Box<Batch>>,
    thread: JoinHandle<()>,
}

impl Remote {
    pub(super) fn start(
        number: usize,
        shared: Arc<PoolState>,
        plan: ThreadPlan,
    ) -> io::Result<Self> {
        let (todo, received) = RingBuffer::new(SHARES);
        let (finished, done) = RingBuffer::new(SHARES);
        let (say, standing) = mpsc::channel();
        let builder = thread::Builder::new().name(format!("letoff-lane-{number}"));
        let thread = builder.stack_size(STACK_BYTES).spawn(move || {
            let standing = plan.ask(number);
            memory::prefault_stack();
            // Without a receiver, `shared` is set to stop as well.
            say.send(standing).unwrap_or_default();
            work(received, finished, &shared);
        })?;
        let standing = standing.recv().map_err(io::Error::other)?;
        Ok(Self { standing, todo, done, thread })
    }

    pub(super) fn send(
        &mut self,
        mut batch: Box<Batch>,
        input: &TickInput<'_>,
        lane_rules: &LaneRules,
    ) {
        (batch.tick, batch.samples, batch.followed) = (input.tick, *input.samples, input.followed);
        (batch.rules, batch.lane_rules) = (input.rules, *lane_rules);
        let sent = self.todo.push(batch);
        debug_assert!(sent.is_ok(), "the ring has room for all batches there are");
        self.thread.thread().unpark();
    }

    pub(super) fn take(&mut self) -> Option<Box<Batch>> {
        self.done.pop().ok()
    }

    /// Returns `true` if the lane's thread ended, which only a bug can cause, and no batch is left.
    pub(super) fn is_lost(&self) -> bool {
        self.done.is_abandoned() && self.done.is_empty()
    }

    /// Waits for the thread, which has been stopped; returns `false` if it panicked.
    pub(super) fn join(self) -> bool {
        self.thread.thread().unpark();
        self.thread.join().is_ok()
    }
}

/// Runs the batches that arrive on the lane's thread, which sleeps without one.
fn work(mut todo: Consumer<Box<Batch>>, mut done: Producer<Box<Batch>>, shared: &PoolState) {
    while !shared.stop.load(Ordering::Acquire) {
        let Ok(mut batch) = todo.pop() else {
            // An unpark between the check and this call makes it return at once.
            thread::park();
            continue;
        };
        batch.ran = (batch.tick == shared.current.load(Ordering::Acquire)).then(|| {
            let before = clock::thread_cpu();
            batch.run(before);
            clock::thread_cpu().since(before)
        });
        let sent = done.push(batch);
        debug_assert!(sent.is_ok(), "the ring has room for all batches there are");
    }
}

/// Returns an array of defaults that was never on the stack.
pub(super) fn boxed_array<T: Clone + Default>() -> Box<[T; KEYS]> {
    vec![T::default(); KEYS]
        .into_boxed_slice()
        .try_into()
        .unwrap_or_else(|_| unreachable!("KEYS long"))
}
