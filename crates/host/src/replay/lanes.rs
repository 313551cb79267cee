//! Lanes that repeat the recorded ones: in time, late, or not at all.

use std::collections::BTreeMap;

use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::{KeyBus, Lanes, TickInput, TickOutput, TickRules};
use scheduler::{
    observation::VoiceObservation, slot::Slot, values::ModelValues, voice::VoiceOutput,
};

use super::ReplayError;
use super::feed::{KeyTick, LaneStatus};
use engine::realtime::pool::{LateResult, PanicGuard};
use engine::voice::{AnyVoice, VoiceBuilder};
use scene::{KeyVoice, Render, Scene};

#[derive(Clone, Debug)]
pub(super) struct RecordedVoice {
    pub(super) voice: KeyVoice,
    /// `true` if it takes over the state of the one before.
    pub(super) kept: bool,
    pub(super) render: Render,
}

struct ReplaySlot {
    slot: Slot<PanicGuard>,
    render: Render,
    revision: u32,
    /// Ticks in which its lane was not done.
    pending: Vec<(u64, KeySample, TickRules)>,
    late: LateResult,
    /// `true` if its lane was late for longer than the recording contains.
    is_unknown: bool,
}

type RecordedVoices = BTreeMap<(usize, u32), RecordedVoice>;

pub(super) struct ReplayLanes {
    slots: Vec<Option<ReplaySlot>>,
    voices: RecordedVoices,
    scene: Scene,
    fed: Vec<KeyTick>,
    pub(super) failed: Option<ReplayError>,
}

impl ReplayLanes {
    pub(super) fn new(scene: Scene) -> Self {
        let slots = (0..KEYS).map(|_| None).collect();
        Self { slots, voices: BTreeMap::new(), scene, fed: Vec::new(), failed: None }
    }

    /// Adds a voice that may play from now on; the first one of a key begins.
    pub(super) fn learn(
        &mut self,
        key: u32,
        revision: u32,
        recorded: RecordedVoice,
    ) -> Result<(), ReplayError> {
        let key = usize::try_from(key).unwrap_or(usize::MAX);
        let Some(slot) = self.slots.get_mut(key) else { return Ok(()) };
        if slot.is_none() {
            *slot = Some(ReplaySlot::begin(&self.scene, key, &recorded, revision)?);
        }
        self.voices.insert((key, revision), recorded);
        Ok(())
    }

    pub(super) fn is_unknown(&self) -> bool {
        self.slots.iter().flatten().any(|slot| slot.is_unknown)
    }

    pub(super) fn feed(&mut self, fed: Vec<KeyTick>) {
        self.fed = fed;
    }
}

fn build(scene: &Scene, recorded: &RecordedVoice, revision: u32) -> Result<AnyVoice, ReplayError> {
    let failed = |error: engine::voice::BuildError| ReplayError::Voice(error.to_string());
    let scene = Scene { render: recorded.render, ..scene.clone() };
    let builder = VoiceBuilder::new(&scene).map_err(failed)?;
    builder.numbered(&recorded.voice, std::sync::Arc::default(), revision).map_err(failed)
}

impl ReplaySlot {
    fn begin(
        scene: &Scene,
        key: usize,
        recorded: &RecordedVoice,
        revision: u32,
    ) -> Result<Self, ReplayError> {
        let voice = build(scene, recorded, revision)?;
        Ok(Self {
            slot: Slot::new(key, PanicGuard::new(voice)),
            render: recorded.render,
            revision,
            pending: Vec::new(),
            late: LateResult::default(),
            is_unknown: false,
        })
    }

    /// Applies the key's changes up to `revision`, as before a tick of the run.
    fn change(
        &mut self,
        revision: u32,
        (voices, scene): (&RecordedVoices, &Scene),
        seen: &mut VoiceObservation,
    ) -> Result<(), ReplayError> {
        if revision <= self.revision {
            return Ok(());
        }
        let key = self.slot.key();
        if !voices.contains_key(&(key, revision)) {
            return Err(ReplayError::Voice(format!("nothing is told of voice {revision}")));
        }
        for ((_, revision), recorded) in voices.range((key, self.revision + 1)..=(key, revision)) {
            self.make(recorded, *revision, scene)?;
        }
        self.revision = revision;
        self.slot.show(seen);
        Ok(())
    }

    fn make(
        &mut self,
        recorded: &RecordedVoice,
        revision: u32,
        scene: &Scene,
    ) -> Result<(), ReplayError> {
        let KeyVoice { model, values, .. } = &recorded.voice;
        let values = ModelValues::new(model.id(), revision, values);
        let is_set_as = self.render == recorded.render;
        self.render = recorded.render;
        let values = values.filter(|_| recorded.kept && is_set_as);
        if !values.is_some_and(|values| self.slot.retune(&values)) {
            let voice = PanicGuard::new(build(scene, recorded, revision)?);
            // A state that is kept without new values is of another version or computed otherwise.
            let put_in = if recorded.kept { Slot::succeed } else { Slot::replace };
            let _old = put_in(&mut self.slot, voice);
        }
        Ok(())
    }

    fn run(
        &mut self,
        &TickInput { tick, followed, rules, .. }: &TickInput<'_>,
        fed: &KeyTick,
        changes: (&RecordedVoices, &Scene),
        (turn, seen): (&mut VoiceOutput, &mut VoiceObservation),
    ) -> Result<(), ReplayError> {
        match fed.lane {
            LaneStatus::Late => {
                turn.hold();
                let mut ran = 0;
                if fed.unrun & 1 == 0 {
                    self.catch_up(tick, fed);
                    self.late.hand_over(turn);
                    ran = self.slot.ran_before(tick);
                }
                self.change(fed.revision, changes, seen)?;
                seen.pass(ran);
                self.pending.push((tick, fed.sample, rules));
            }
            LaneStatus::Waited => {
                self.catch_up(tick, fed);
                self.change(fed.revision, changes, seen)?;
                self.slot.wait(tick, turn);
                self.slot.observe(followed, turn, seen);
                self.late.hand_over(turn);
                self.pending.push((tick, fed.sample, rules));
            }
            LaneStatus::Done => {
                self.catch_up(tick, fed);
                self.change(fed.revision, changes, seen)?;
                self.slot.allow_recorded(rules, fed.limit);
                self.slot.tick(tick, &fed.sample, turn);
                self.slot.observe(followed, turn, seen);
                self.late.hand_over(turn);
            }
        }
        Ok(())
    }

    /// Runs the late ticks that were run: at most one, since a voice is away with its lane.
    fn catch_up(&mut self, tick: u64, &KeyTick { unrun, late_limit, .. }: &KeyTick) {
        for (late, sample, rules) in std::mem::take(&mut self.pending) {
            let before = u32::try_from(tick - late).unwrap_or(u32::MAX);
            match unrun.checked_shr(before) {
                Some(bit) if bit & 1 == 0 => {
                    let mut turn = VoiceOutput::default();
                    self.slot.allow_recorded(rules, late_limit);
                    self.slot.tick(late, &sample, &mut turn);
                    self.late.keep(&turn);
                }
                Some(_was_not) => {}
                None => self.is_unknown = true,
            }
        }
    }
}

impl Lanes for ReplayLanes {
    fn run(&mut self, input: &TickInput<'_>, output: &mut TickOutput<'_>) {
        let keys = self.slots.iter_mut().zip(&self.fed);
        let keys = keys.zip(output.turns.iter_mut().zip(output.observed.iter_mut()));
        let changes = (&self.voices, &self.scene);
        for ((slot, fed), seen) in keys {
            let Some(slot) = slot else { continue };
            if let Err(error) = slot.run(input, fed, changes, seen) {
                self.failed.get_or_insert(error);
            }
        }
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;
    use scheduler::{overload::Simplifications, voice::Voice};

    struct Still;

    impl Voice for Still {
        fn tick(&mut self, _tick: u64, _sample: &KeySample, _turn: &mut VoiceOutput) {}

        fn reset(&mut self, _sample: &KeySample) {}
    }

    fn caught_up(late: &[u64], unrun: u32) -> ReplaySlot {
        let mut slot = ReplaySlot {
            slot: Slot::new(3, PanicGuard::new(Box::new(Still))),
            render: Scene::load(&scene::Library::default(), "springs", &[])
                .expect("a scene of ours")
                .render,
            revision: 0,
            pending: Vec::new(),
            late: LateResult::default(),
            is_unknown: false,
        };
        let rules = TickRules { simplified: Simplifications::NONE, hz: 1000 };
        let at = |tick: &u64| (*tick, KeySample::fresh(0.0), rules);
        slot.pending = late.iter().map(at).collect();
        let fed = KeyTick {
            sample: KeySample::fresh(0.0),
            revision: 0,
            lane: LaneStatus::Done,
            unrun,
            limit: None,
            late_limit: None,
        };
        slot.catch_up(38, &fed);
        assert!(slot.pending.is_empty());
        slot
    }

    #[test]
    fn late_ticks_are_run_as_they_were_and_one_that_is_too_long_ago_is_unknown() {
        let slot = caught_up(&[7, 9, 36, 37], !(1 << 31 | 1 << 2));
        assert_eq!(slot.slot.ran_before(38), 1 << 31 | 1 << 2 | 1);
        assert!(!slot.is_unknown);
        assert!(caught_up(&[6, 36], !(1 << 2)).is_unknown);
    }
}
