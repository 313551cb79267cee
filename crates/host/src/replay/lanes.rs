//! Lanes that do what the recorded ones did: in time, late, or not at all.

use std::collections::BTreeMap;

use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::observation::{FollowedKeys, VoiceObservation};
use scheduler::port::{KeyBus, Lanes, TickInput, TickOutput};
use scheduler::slot::Slot;
use scheduler::voice::VoiceOutput;

use super::ReplayError;
use super::feed::{KeyTick, LaneStatus};
use realtime::pool::{LateResult, PanicGuard};
use scene::{KeyVoice, Scene};
use voice::{AnyVoice, VoiceBuilder};

/// A voice of the recording.
#[derive(Clone, Debug)]
pub(super) struct RecordedVoice {
    pub(super) voice: KeyVoice,
    /// Whether it takes over the state of the one before.
    pub(super) kept: bool,
}

/// A key's voice, and what of it has not been seen.
struct ReplaySlot {
    slot: Slot<PanicGuard>,
    revision: u32,
    /// Ticks in which its lane was not done.
    pending: Vec<(u64, KeySample)>,
    /// What was made in them.
    late: LateResult,
}

/// The voices of a recording.
pub(super) struct ReplayLanes {
    desks: Vec<Option<ReplaySlot>>,
    parts: BTreeMap<u32, RecordedVoice>,
    scene: Scene,
    /// What decided in the tick that is run.
    fed: Vec<KeyTick>,
    /// Why a voice could not be built.
    pub(super) failed: Option<ReplayError>,
}

impl ReplayLanes {
    pub(super) fn new(scene: Scene) -> Self {
        let desks = (0..KEYS).map(|_| None).collect();
        Self { desks, parts: BTreeMap::new(), scene, fed: Vec::new(), failed: None }
    }

    /// A voice that may be put in from now on; the first one of a key begins.
    pub(super) fn learn(
        &mut self,
        key: u32,
        revision: u32,
        part: RecordedVoice,
    ) -> Result<(), ReplayError> {
        let Some(desk) = usize::try_from(key).ok().and_then(|key| self.desks.get_mut(key)) else {
            return Ok(());
        };
        if desk.is_none() {
            let voice = build(&self.scene, &part, revision)?;
            let key = usize::try_from(key).unwrap_or(usize::MAX);
            *desk = Some(ReplaySlot {
                slot: Slot::new(key, PanicGuard::new(voice)),
                revision,
                pending: Vec::new(),
                late: LateResult::default(),
            });
        }
        self.parts.insert(revision, part);
        Ok(())
    }

    /// What decides in the tick that is run next.
    pub(super) fn feed(&mut self, fed: Vec<KeyTick>) {
        self.fed = fed;
    }
}

fn build(scene: &Scene, part: &RecordedVoice, revision: u32) -> Result<AnyVoice, ReplayError> {
    let failed = |error: voice::BuildError| ReplayError::Voice(error.to_string());
    let builder = VoiceBuilder::new(scene).map_err(failed)?;
    builder.numbered(&part.voice, std::sync::Arc::default(), revision).map_err(failed)
}

impl ReplaySlot {
    /// Puts the voice of `revision` in, if it is another.
    fn change(
        &mut self,
        revision: u32,
        parts: &BTreeMap<u32, RecordedVoice>,
        scene: &Scene,
    ) -> Result<(), ReplayError> {
        if revision == 0 || revision == self.revision {
            return Ok(());
        }
        let Some(part) = parts.get(&revision) else {
            return Err(ReplayError::Voice(format!("nothing is told of voice {revision}")));
        };
        let voice = PanicGuard::new(build(scene, part, revision)?);
        let _old = if part.kept { self.slot.retune(voice) } else { self.slot.replace(voice) };
        self.revision = revision;
        Ok(())
    }

    fn run(
        &mut self,
        (tick, followed): (u64, FollowedKeys),
        fed: &KeyTick,
        turn: &mut VoiceOutput,
        seen: &mut VoiceObservation,
    ) {
        match fed.lane {
            LaneStatus::Late => {
                turn.hold();
                seen.pass(0);
                if 0 < fed.events {
                    self.catch_up(|_late| true);
                    self.late.hand_over(turn);
                }
                self.pending.push((tick, fed.sample));
            }
            LaneStatus::Done { unrun } => {
                self.catch_up(|late| was_run(unrun, tick - late));
                self.slot.tick(tick, &fed.sample, turn);
                self.slot.observe(followed, turn, seen);
                self.late.hand_over(turn);
            }
        }
    }

    /// Runs the ticks that came too late, of those that were run.
    fn catch_up(&mut self, was_run: impl Fn(u64) -> bool) {
        for (tick, sample) in std::mem::take(&mut self.pending) {
            if was_run(tick) {
                let mut turn = VoiceOutput::default();
                self.slot.tick(tick, &sample, &mut turn);
                self.late.keep(&turn);
            }
        }
    }
}

/// Whether the tick `before` this one was run; what is too long ago was not.
fn was_run(unrun: u32, before: u64) -> bool {
    u32::try_from(before).ok().and_then(|bit| unrun.checked_shr(bit)).is_some_and(|it| it & 1 == 0)
}

impl Lanes for ReplayLanes {
    fn run(&mut self, input: &TickInput<'_>, output: &mut TickOutput<'_>) {
        let keys = self.desks.iter_mut().zip(&self.fed);
        let keys = keys.zip(output.turns.iter_mut().zip(output.observed.iter_mut()));
        for ((desk, fed), (turn, seen)) in keys {
            let Some(desk) = desk else { continue };
            if fed.lane != LaneStatus::Late
                && let Err(error) = desk.change(fed.revision, &self.parts, &self.scene)
            {
                self.failed.get_or_insert(error);
            }
            desk.run((input.tick, input.followed), fed, turn, seen);
        }
    }
}

/// The recorded sensors.
#[derive(Debug)]
pub(super) struct ReplayBus {
    pub(super) samples: [KeySample; KEYS],
}

impl KeyBus for ReplayBus {
    fn receive(&mut self, _tick: u64, samples: &mut [KeySample; KEYS]) {
        *samples = self.samples;
    }

    fn send(&mut self, _tick: u64, _forces: &[f64; KEYS], _slopes: &[KeySlope; KEYS]) {}
}
