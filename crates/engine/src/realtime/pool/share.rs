use scheduler::motion::KEYS;
use scheduler::port::{TickInput, TickOutput};
use scheduler::slot::Slot;
use scheduler::time::Nanos;
use scheduler::voice::{VoiceFault, VoiceOutput};

use super::WaitLimit;
use super::balance::MeasuredWork;
use super::cost::LaneWork;
use super::fence::PanicGuard;
use super::latecomers::LateResults;
use super::worker::{AWAKE, Batch, LaneRules, Remote, SHARES};

/// Lane on another thread as the tick sees it, in two shares.
#[derive(Debug)]
pub(super) struct RemoteLane {
    pub(super) remote: Remote,
    shares: [Share; SHARES],
}

#[derive(Debug)]
struct Share {
    /// Present between ticks; away with the lane while it is run.
    batch: Option<Box<Batch>>,
    keys: Vec<usize>,
    stands: ShareState,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum ShareState {
    /// Nothing to run, or not sent in this tick yet.
    Home,
    Running,
    Done {
        cpu: Nanos,
    },
    /// The lane still has a batch of an earlier tick, and has had it for so many.
    Behind {
        ticks: u32,
    },
    Lost,
}

pub(super) enum SlotPlace<'a> {
    Here(&'a mut Slot<PanicGuard>),
    /// With the lane, or lost with it.
    Away {
        lost: bool,
    },
}

impl RemoteLane {
    pub(super) fn new(remote: Remote, batches: [Box<Batch>; SHARES]) -> Self {
        let shares = batches.map(|batch| {
            let keys = Vec::with_capacity(batch.slots.capacity());
            Share { batch: Some(batch), keys, stands: ShareState::Home }
        });
        Self { remote, shares }
    }

    /// Receives late batches, and marks every share as not sent in `tick`.
    pub(super) fn begin(
        &mut self,
        tick: u64,
        output: &mut TickOutput<'_>,
        latecomers: &mut LateResults,
    ) {
        self.take_back(tick, output, latecomers);
        for share in &mut self.shares {
            share.stands = match share.stands {
                ShareState::Home | ShareState::Done { .. } => ShareState::Home,
                ShareState::Running => ShareState::Behind { ticks: 1 },
                ShareState::Behind { ticks } => {
                    ShareState::Behind { ticks: ticks.saturating_add(1) }
                }
                ShareState::Lost => ShareState::Lost,
            };
        }
    }

    /// Moves voices that rest into the share that is run last, and those that woke into the first.
    pub(super) fn sort(&mut self, measured: &MeasuredWork) {
        let [Some(awake), Some(asleep)] = self.shares.each_mut().map(|it| it.batch.as_mut()) else {
            return;
        };
        sift(&mut awake.slots, &mut asleep.slots, |key| measured.is_asleep(key));
        sift(&mut asleep.slots, &mut awake.slots, |key| !measured.is_asleep(key));
    }

    /// Returns the lane's work, if all of it is at home and will be run.
    pub(super) fn load(&self, measured: &MeasuredWork) -> Option<u64> {
        let load = |share: &Share| {
            let batch = share.batch.as_ref().filter(|_| share.stands != ShareState::Lost)?;
            Some(measured.of(&batch.slots))
        };
        let voices: Option<u64> = self.shares.iter().map(load).sum();
        Some(voices? + measured.lag())
    }

    pub(super) fn awake(&mut self) -> Option<&mut Vec<Slot<PanicGuard>>> {
        self.shares[AWAKE].batch.as_mut().map(|batch| &mut batch.slots)
    }

    pub(super) fn place(&mut self, key: usize) -> Option<SlotPlace<'_>> {
        self.shares.iter_mut().find_map(|share| match &mut share.batch {
            Some(batch) => batch.slots.iter_mut().find(|it| it.key() == key).map(SlotPlace::Here),
            None => share
                .keys
                .contains(&key)
                .then_some(SlotPlace::Away { lost: share.stands == ShareState::Lost }),
        })
    }

    /// Sends the lane its shares of this tick that are at home and unsent, with their budgets.
    pub(super) fn give(&mut self, input: &TickInput<'_>, rules: &LaneRules) {
        let Self { remote, shares } = self;
        for share in shares.iter_mut().filter(|it| it.stands == ShareState::Home) {
            let Some(batch) = share.batch.take_if(|it| !it.slots.is_empty()) else { continue };
            share.keys.clear();
            // There is room for all keys, so it never grows.
            share.keys.extend(batch.slots.iter().map(Slot::key));
            remote.send(batch, input, rules);
            share.stands = ShareState::Running;
        }
    }

    pub(super) fn take_back(
        &mut self,
        tick: u64,
        output: &mut TickOutput<'_>,
        latecomers: &mut LateResults,
    ) {
        // Bounded by the lane's batches.
        while let Some(batch) = self.remote.take() {
            let share = &mut self.shares[batch.share];
            share.stands = match batch.ran {
                Some(cpu) if batch.tick == tick => {
                    batch.write(output);
                    ShareState::Done { cpu }
                }
                Some(_) | None => {
                    latecomers.keep(tick, &batch);
                    ShareState::Home
                }
            };
            share.batch = Some(batch);
        }
        if self.remote.is_lost() {
            self.shares.iter_mut().for_each(|it| it.stands = ShareState::Lost);
        }
    }

    /// Returns `true` if the lane is worth waiting for: one far behind only if there is no limit.
    pub(super) fn is_awaited(&self, patience: WaitLimit) -> bool {
        self.shares.iter().any(|share| match share.stands {
            ShareState::Running => true,
            ShareState::Behind { ticks } => patience == WaitLimit::Endless || ticks == 1,
            ShareState::Home | ShareState::Done { .. } | ShareState::Lost => false,
        })
    }

    pub(super) fn cpu(&self) -> Nanos {
        self.shares.iter().fold(Nanos::ZERO, |sum, share| match share.stands {
            ShareState::Done { cpu } => sum.after(cpu),
            ShareState::Home
            | ShareState::Running
            | ShareState::Behind { .. }
            | ShareState::Lost => sum,
        })
    }

    pub(super) fn work(&mut self, turns: &[VoiceOutput; KEYS]) -> LaneWork {
        let mut work = LaneWork::NONE;
        let is_done = |share: &&mut Share| matches!(share.stands, ShareState::Done { .. });
        for batch in self.shares.iter_mut().filter(is_done).filter_map(|it| it.batch.as_mut()) {
            work.add(&mut batch.slots, turns);
        }
        work
    }

    /// Holds the forces of unfinished shares; returns `true` if there are any.
    pub(super) fn hold_late(&self, output: &mut TickOutput<'_>) -> bool {
        let mut any = false;
        for share in &self.shares {
            let instead: fn(&mut VoiceOutput) = match share.stands {
                ShareState::Home | ShareState::Done { .. } => continue,
                ShareState::Running | ShareState::Behind { .. } => {
                    any = true;
                    VoiceOutput::hold
                }
                ShareState::Lost => |turn| turn.fail(VoiceFault::Panicked),
            };
            for &key in &share.keys {
                instead(&mut output.turns[key]);
                output.observed[key].pass(0);
            }
        }
        any
    }
}

fn sift(
    from: &mut Vec<Slot<PanicGuard>>,
    to: &mut Vec<Slot<PanicGuard>>,
    belongs: impl Fn(usize) -> bool,
) {
    let mut index = 0;
    while let Some(slot) = from.get(index) {
        if belongs(slot.key()) {
            // There is room for all keys in each, so neither grows.
            to.push(from.swap_remove(index));
        } else {
            index += 1;
        }
    }
}
