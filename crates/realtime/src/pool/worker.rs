//! A lane on a thread of its own: batches of a tick travel there and back.
//!
//! Each lane has two batches, made at set-up. The tick fills one and sends it; the lane runs
//! it and sends it back. While the lane is late with one, the other can wait for it. A batch
//! whose tick has passed before the lane came to it is sent back as it is, so that a lane
//! that was held up joins the present instead of running after it.

use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc;
use std::thread::{self, JoinHandle};

use rtrb::{Consumer, Producer, RingBuffer};
use scheduler::lane::run_slots;
use scheduler::motion::{KEYS, KeySample};
use scheduler::observation::{FollowedKeys, VoiceObservation};
use scheduler::port::{TickInput, TickOutput};
use scheduler::slot::Slot;
use scheduler::time::Nanos;
use scheduler::voice::VoiceOutput;

use super::WaitLimit;
use super::fence::PanicGuard;
use super::swap::InnerEnd;
use crate::thread::{SchedulingPolicy, ask_for_fifo};
use crate::{clock, memory};

/// Batches of a lane: one being run, one waiting.
const BATCHES: usize = 2;

/// Stack of a lane's thread; all of it is locked into memory.
const STACK_BYTES: usize = 1024 * 1024;

/// The voices of one lane and the end of their swaps, wherever it runs.
#[derive(Debug)]
pub(super) struct Lane {
    pub(super) slots: Vec<Slot<PanicGuard>>,
    pub(super) swaps: InnerEnd,
}

impl Lane {
    /// Runs the lane's share of `tick`.
    pub(super) fn run(&mut self, input: &TickInput<'_>, output: &mut TickOutput<'_>) {
        self.swaps.apply(&mut self.slots);
        run_slots(&mut self.slots, input, output);
    }
}

/// One tick on its way to a lane and back.
#[derive(Debug)]
pub(super) struct Batch {
    pub(super) tick: u64,
    samples: [KeySample; KEYS],
    followed: FollowedKeys,
    /// Valid for the lane's keys if the batch was run.
    pub(super) turns: Box<[VoiceOutput; KEYS]>,
    /// Valid for those keys that were looked at in this tick.
    observed: Box<[VoiceObservation; KEYS]>,
    /// CPU time that the lane took; none if the batch came too late to be run.
    pub(super) ran: Option<Nanos>,
    /// How long it was waited for.
    pub(super) patience: WaitLimit,
}

impl Batch {
    /// Runs the batch on `lane`.
    fn run(&mut self, lane: &mut Lane) {
        let Self { tick, samples, followed, turns, observed, .. } = self;
        lane.run(
            &TickInput { tick: *tick, samples, followed: *followed },
            &mut TickOutput { turns, observed },
        );
    }

    /// Copies what voices of `keys` did, which must be those of the lane that ran them, and what
    /// is new of what is seen of them.
    pub(super) fn write(&self, keys: &[usize], output: &mut TickOutput<'_>) {
        for &key in keys {
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

/// What the tick's thread and all lanes see of each other besides the rings.
#[derive(Debug, Default)]
pub(super) struct PoolState {
    /// The tick that is being run.
    pub(super) current: AtomicU64,
    /// Lanes end at the next look.
    pub(super) stop: AtomicBool,
}

/// The tick's end of a lane on another thread.
#[derive(Debug)]
pub(super) struct Remote {
    pub(super) keys: Vec<usize>,
    pub(super) standing: SchedulingPolicy,
    #[expect(clippy::vec_box, reason = "the boxes travel, the batches stay where they are")]
    spare: Vec<Box<Batch>>,
    todo: Producer<Box<Batch>>,
    done: Consumer<Box<Batch>>,
    thread: JoinHandle<()>,
}

impl Remote {
    /// Starts a thread for `lane`.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub(super) fn start(
        number: usize,
        lane: Lane,
        shared: Arc<PoolState>,
        priority: Option<u8>,
    ) -> io::Result<Self> {
        let keys = lane.slots.iter().map(Slot::key).collect();
        let (todo, received) = RingBuffer::new(BATCHES);
        let (finished, done) = RingBuffer::new(BATCHES);
        let (say, standing) = mpsc::channel();
        let builder = thread::Builder::new().name(format!("letoff-lane-{number}"));
        let thread = builder.stack_size(STACK_BYTES).spawn(move || {
            let standing = ask_for_fifo(priority);
            memory::prefault_stack();
            // If the other end is gone, `shared` says stop as well.
            say.send(standing).unwrap_or_default();
            work(lane, received, finished, &shared);
        })?;
        let standing = standing.recv().map_err(io::Error::other)?;
        let spare = (0..BATCHES).map(|_| Box::new(empty_batch())).collect();
        Ok(Self { keys, standing, spare, todo, done, thread })
    }

    /// Sends the lane its share of `tick`; it has none if it still holds both batches.
    pub(super) fn give(&mut self, input: &TickInput<'_>, patience: WaitLimit) -> bool {
        let Some(mut batch) = self.spare.pop() else { return false };
        (batch.tick, batch.samples, batch.followed) = (input.tick, *input.samples, input.followed);
        batch.patience = patience;
        // The ring has room for all batches there are; a lane that ended takes none back.
        let given = self.todo.push(batch).is_ok();
        self.thread.thread().unpark();
        given
    }

    /// The next batch that came back; give it to [`Remote::keep`] when done with it.
    pub(super) fn take(&mut self) -> Option<Box<Batch>> {
        self.done.pop().ok()
    }

    /// Makes `batch` free for another tick.
    pub(super) fn keep(&mut self, batch: Box<Batch>) {
        // Never grows: room for all batches was made at the start.
        self.spare.push(batch);
    }

    /// The lane's thread has ended, which only a bug of ours can do, and nothing is left of it.
    pub(super) fn is_lost(&self) -> bool {
        self.done.is_abandoned() && self.done.is_empty()
    }

    /// Waits for the thread, which has been told to stop; `false` if it had panicked.
    pub(super) fn join(self) -> bool {
        self.thread.thread().unpark();
        self.thread.join().is_ok()
    }
}

/// The lane's thread: runs what comes, sleeps when nothing does.
fn work(
    mut lane: Lane,
    mut todo: Consumer<Box<Batch>>,
    mut done: Producer<Box<Batch>>,
    shared: &PoolState,
) {
    while !shared.stop.load(Ordering::Acquire) {
        let Ok(mut batch) = todo.pop() else {
            // An unpark between the look and here makes this return at once.
            thread::park();
            continue;
        };
        batch.ran = (batch.tick == shared.current.load(Ordering::Acquire)).then(|| {
            let before = clock::thread_cpu();
            batch.run(&mut lane);
            clock::thread_cpu().since(before)
        });
        let sent = done.push(batch);
        debug_assert!(sent.is_ok(), "the ring has room for all batches there are");
    }
}

fn empty_batch() -> Batch {
    Batch {
        tick: 0,
        samples: [KeySample::default(); KEYS],
        followed: FollowedKeys::NONE,
        turns: boxed_array(),
        observed: boxed_array(),
        ran: None,
        patience: WaitLimit::Endless,
    }
}

/// Returns an array of defaults that never was on the stack.
pub(super) fn boxed_array<T: Clone + Default>() -> Box<[T; KEYS]> {
    vec![T::default(); KEYS]
        .into_boxed_slice()
        .try_into()
        .unwrap_or_else(|_| unreachable!("KEYS long"))
}
