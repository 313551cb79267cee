//! A key with its action, to rehearse strokes on: the very loop that will run later.

use std::fmt;
use std::sync::Arc;

use haptics::{Gesture, HandCommand, RigParameters};
use hardware::sim::key::SimulatedKey;
use performance::{PlayOutcome, Rehearsal, Strike};
use scene::KeyVoice;
use scheduler::motion::{KeyEvent, KeySample, Moment};
use scheduler::safety::KeyGate;
use scheduler::slot::Slot;
use scheduler::time::Period;
use scheduler::voice::{Voice, VoiceOutput};
use scheduler::work::TurnLimit;

use voice::{BuildError, RehearsableVoice, VoiceBuilder};

/// Why a key of a scene cannot be rehearsed.
#[derive(Debug, thiserror::Error)]
pub enum RehearsalError {
    /// The scene's values make no voice.
    #[error(transparent)]
    Voice(#[from] BuildError),
    /// The simulated keybed refuses the scene's period.
    #[error("the simulated keybed cannot run the scene: {0}")]
    Keybed(#[from] hardware::Error),
}

/// One key of the simulated keybed and its voice, in virtual time.
///
/// Sample, voice, safety and wire are those of the running host, in the same order, so
/// what was rehearsed happens to the last bit.
pub struct RehearsedKey {
    key: SimulatedKey,
    slot: Slot<Copied>,
    gate: KeyGate,
    tick: u64,
    period: f64,
}

/// A boxed voice that can be cloned with its slot.
struct Copied(Box<dyn RehearsableVoice>);

impl Clone for Copied {
    fn clone(&self) -> Self {
        Self(self.0.copy())
    }
}

impl Voice for Copied {
    fn tick(&mut self, tick: u64, sample: &KeySample, turn: &mut VoiceOutput) {
        self.0.tick(tick, sample, turn);
    }

    fn limit_work(&mut self, limit: TurnLimit) {
        self.0.limit_work(limit);
    }

    fn reset(&mut self, sample: &KeySample) {
        self.0.reset(sample);
    }
}

impl RehearsedKey {
    /// A key at rest before tick 0, in ticks of a period and with a slew limit (N/s).
    pub fn new(
        number: usize,
        key: SimulatedKey,
        voice: Box<dyn RehearsableVoice>,
        (period, slew): (Period, f64),
    ) -> Self {
        Self {
            key,
            slot: Slot::new(number, Copied(voice)),
            gate: KeyGate::new(period, slew),
            tick: 0,
            period: period.as_secs_f64(),
        }
    }
}

impl RehearsedKey {
    /// Returns one key of a scene with its voice, on the simulated keybed's rig.
    ///
    /// # Errors
    /// If the voice or the keybed are refused.
    pub fn of_scene(
        builder: &VoiceBuilder<'_>,
        key: usize,
        voice: &KeyVoice,
    ) -> Result<Self, RehearsalError> {
        Self::on_rig(builder, (key, voice), builder.rig())
    }

    /// Returns the same on another rig.
    ///
    /// # Errors
    /// If the voice or the keybed are refused.
    pub fn on_rig(
        builder: &VoiceBuilder<'_>,
        (key, voice): (usize, &KeyVoice),
        rig: RigParameters,
    ) -> Result<Self, RehearsalError> {
        let period = builder.period();
        let sim = SimulatedKey::new(period.as_secs_f64(), rig)?;
        let voice = builder.voice(voice, Arc::default())?;
        Ok(Self::new(key, sim, voice, (period, builder.slew_limit())))
    }

    /// Takes the gestures that are played from now on instead of those before.
    pub fn take(&mut self, gestures: Vec<Gesture>) {
        self.key.play(gestures);
    }

    /// Lets a hand press on the key or grip it from now on.
    pub fn press(&mut self, hand: HandCommand) {
        self.key.press(hand);
    }

    /// Returns the start of the next tick (s).
    pub fn now(&self) -> f64 {
        self.tick as f64 * self.period
    }

    /// Returns the position of the key's front (m), down positive.
    pub fn position(&self) -> f64 {
        self.key.rig().position()
    }

    /// Runs the next tick; returns what the voice did in it.
    pub fn step(&mut self) -> VoiceOutput {
        let mut turn = VoiceOutput::default();
        let sample = self.key.receive(self.tick);
        self.slot.tick(self.tick, &sample, &mut turn);
        let force = self.gate.apply(&turn, &sample);
        self.key.send(force, &self.gate.slope(&turn));
        self.tick += 1;
        turn
    }

    fn note(&self, (at, event): &(Moment, KeyEvent), outcome: &mut PlayOutcome) {
        let at = at.seconds(self.period);
        match *event {
            KeyEvent::Strike { loudness, .. } => {
                outcome.strikes.push(Strike { at, speed: loudness.hammer_speed });
            }
            KeyEvent::DamperFall { .. } => outcome.damper_fall = Some(at),
            KeyEvent::DamperLift | KeyEvent::Pressure { .. } => {}
        }
    }
}

impl Clone for RehearsedKey {
    fn clone(&self) -> Self {
        Self {
            key: self.key.clone(),
            slot: self.slot.clone(),
            gate: self.gate,
            tick: self.tick,
            period: self.period,
        }
    }
}

impl fmt::Debug for RehearsedKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RehearsedKey").field("tick", &self.tick).finish_non_exhaustive()
    }
}

impl Rehearsal for RehearsedKey {
    fn play(&mut self, gestures: &[Gesture], until: f64) -> PlayOutcome {
        self.take(gestures.to_vec());
        let mut outcome = PlayOutcome::default();
        while self.now() < until {
            let turn = self.step();
            turn.events.as_slice().iter().for_each(|it| self.note(it, &mut outcome));
        }
        outcome
    }

    fn depth(&self) -> f64 {
        self.position()
    }
}
