//! A key with its action for rehearsals, in the loop of the running host.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use boards::sim::key::SimulatedKey;
use engine::realtime::clock;
use haptics::{Gesture, HandCommand, RigParameters};
use midi::velocity::release_velocity;
use pianist::{
    Assessment, Damped, DamperFall, Performance, Pianist, PlayOutcome, Rehearsal, Score, Strike,
    Struck, assess,
};
use scene::KeyVoice;
use scheduler::motion::{KeyEvent, Moment};
use scheduler::safety::KeyGate;
use scheduler::slot::Slot;
use scheduler::time::Period;
use scheduler::voice::VoiceOutput;

use engine::voice::{BuildError, CopiedVoice, RehearsableVoice, VoiceBuilder};

/// Error in the rehearsal of a scene's key.
#[derive(Debug, thiserror::Error)]
pub enum RehearsalError {
    #[error(transparent)]
    Voice(#[from] BuildError),
    /// The simulated keybed rejects the scene's period.
    #[error("the simulated keybed cannot run the scene: {0}")]
    Keybed(#[from] boards::Error),
    /// The pieces need more ticks than [`MAX_REHEARSED_TICKS`].
    #[error(
        "the pieces take too long to rehearse, more than {MAX_REHEARSED_TICKS} ticks of all keys \
         together: play fewer or shorter ones, or a part of them with --duration"
    )]
    TooLong,
    #[error("the rehearsal was cancelled before its end")]
    Cancelled,
}

/// Maximum work of a rehearsal: ticks of all keys and trials. An hour at 1 kHz needs a third.
pub const MAX_REHEARSED_TICKS: u64 = 1_000_000_000;

/// Ticks of a rehearsal, counted by all its keys and their copies.
#[derive(Debug)]
pub struct RehearsalWork {
    left: AtomicU64,
    evaluations: AtomicU64,
    is_cancelled: Arc<AtomicBool>,
}

impl RehearsalWork {
    /// Returns a budget of `ticks`, which ends early once `is_cancelled` is set.
    pub const fn new(ticks: u64, is_cancelled: Arc<AtomicBool>) -> Self {
        Self { left: AtomicU64::new(ticks), evaluations: AtomicU64::new(0), is_cancelled }
    }

    /// Returns the evaluations of the models' derivatives so far.
    pub fn evaluations(&self) -> u64 {
        self.evaluations.load(Ordering::Relaxed)
    }

    /// Returns the error of a rehearsal that took too long or was cancelled.
    pub fn verdict(&self) -> Result<(), RehearsalError> {
        if self.is_cancelled.load(Ordering::Relaxed) {
            Err(RehearsalError::Cancelled)
        } else if self.left.load(Ordering::Relaxed) == 0 {
            Err(RehearsalError::TooLong)
        } else {
            Ok(())
        }
    }

    fn spend(&self, ticks: u64, evaluations: u64) -> bool {
        self.evaluations.fetch_add(evaluations, Ordering::Relaxed);
        let less = |left: u64| Some(left.saturating_sub(ticks));
        let _before = self.left.fetch_update(Ordering::Relaxed, Ordering::Relaxed, less);
        self.verdict().is_ok()
    }
}

const PACE: u64 = 256;

/// Time after the last finger in which dampers still fall (s), and time between two looks (s): a
/// damper falls once in it.
const SILENCE: f64 = 0.5;
const LOOK: f64 = 10e-3;

/// One key of the simulated keybed and its voice, in virtual time.
///
/// Its parts are the running host's, so rehearsed output equals played output bit for bit.
pub struct RehearsedKey {
    key: SimulatedKey,
    slot: Slot<CopiedVoice>,
    gate: KeyGate,
    tick: u64,
    period: f64,
    work: Option<Arc<RehearsalWork>>,
}

impl RehearsedKey {
    /// Returns a key at rest before tick 0, with ticks of a period and a slew limit (N/s).
    pub fn new(
        number: usize,
        key: SimulatedKey,
        mut voice: Box<dyn RehearsableVoice>,
        (period, slew): (Period, f64),
    ) -> Self {
        voice.end_audit();
        Self {
            key,
            slot: Slot::new(number, CopiedVoice(voice)),
            gate: KeyGate::new(period, slew),
            tick: 0,
            period: period.as_secs_f64(),
            work: None,
        }
    }

    /// Counts the ticks of the key and its copies in `work` from now on.
    pub fn count_by(&mut self, work: Arc<RehearsalWork>) {
        self.work = Some(work);
    }
}

impl RehearsedKey {
    /// Returns one key of a scene with its voice, on the simulated keybed's rig.
    pub fn of_scene(
        builder: &VoiceBuilder<'_>,
        key: usize,
        voice: &KeyVoice,
    ) -> Result<Self, RehearsalError> {
        Self::on_rig(builder, (key, voice), builder.rig())
    }

    /// Like [`Self::of_scene`], but on another rig.
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

    /// Replaces the gestures from now on.
    pub fn take(&mut self, gestures: Vec<Gesture>) {
        self.key.play(gestures);
    }

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

    /// Runs the next tick; returns the voice's output.
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
            KeyEvent::DamperFall { speed } => outcome.damper_fall = Some(DamperFall { at, speed }),
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
            work: self.work.clone(),
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
            let (first, mut evaluations) = (self.tick, 0);
            while self.now() < until && self.tick - first < PACE {
                let turn = self.step();
                evaluations += u64::from(turn.work.derivatives);
                turn.events.as_slice().iter().for_each(|it| self.note(it, &mut outcome));
            }
            let ticks = self.tick - first;
            if self.work.as_ref().is_some_and(|work| !work.spend(ticks, evaluations)) {
                // The outcome no longer counts, but the time of the key must advance.
                self.tick = self.tick.max(clock::nearest_integer((until / self.period).ceil()));
                break;
            }
        }
        outcome
    }

    fn depth(&self) -> f64 {
        self.position()
    }

    fn period(&self) -> f64 {
        self.period
    }
}

/// A performance that was rehearsed and then played on the same keys.
#[derive(Clone, Debug)]
pub struct PlayedScore {
    pub performance: Performance,
    pub assessment: Assessment,
    /// Evaluations of the models' derivatives: of the rehearsal, and of the playing.
    pub evaluations: [u64; 2],
}

/// Rehearses `score` on the keys of `builder` and plays it, in virtual time.
pub fn perform(
    builder: &VoiceBuilder<'_>,
    pianist: &Pianist,
    score: &Score,
) -> Result<PlayedScore, RehearsalError> {
    let work = [(); 2].map(|()| Arc::new(RehearsalWork::new(MAX_REHEARSED_TICKS, Arc::default())));
    let [rehearsed, played] = &work;
    let mut keys = BTreeMap::new();
    for (key, voice) in builder.keys() {
        keys.insert(key, RehearsedKey::of_scene(builder, key, voice)?);
    }
    let keys = Mutex::new(keys);
    let new_key = |number: u8, work: &Arc<RehearsalWork>| {
        let mut key = keys.lock().unwrap_or_else(PoisonError::into_inner)[&number.into()].clone();
        key.count_by(Arc::clone(work));
        key
    };
    let performance = pianist.prepare(score, |key| new_key(key, rehearsed), |_| ());
    let (mut struck, mut damped) = (Vec::new(), Vec::new());
    for (key, gestures) in (0..).zip(&performance.gestures).filter(|it| !it.1.is_empty()) {
        let mut playing = new_key(key, played);
        while playing.now() < performance.end() + SILENCE {
            let outcome = playing.play(gestures, playing.now() + LOOK);
            let velocity = |strike: &Strike| pianist.curve.velocity(strike.speed).get();
            let strike = |it: &Strike| Struck { key, at: it.at, velocity: velocity(it) };
            struck.extend(outcome.strikes.iter().map(strike));
            let release = |fall: DamperFall| release_velocity(fall.speed).get();
            let fall = |it: DamperFall| Damped { key, at: it.at, release: release(it) };
            damped.extend(outcome.damper_fall.map(fall));
        }
    }
    let assessment = assess(&performance.expected, &struck, &damped);
    rehearsed.verdict()?;
    let evaluations = work.map(|work| work.evaluations());
    Ok(PlayedScore { performance, assessment, evaluations })
}

#[cfg(test)]
mod tests {
    use scene::Scene;

    use super::*;

    #[test]
    fn a_rehearsal_ends_where_its_work_ends_however_long_the_piece() {
        let springs = Scene::load(&scene::Library::default(), "springs", &[]).unwrap();
        let builder = VoiceBuilder::new(&springs).unwrap();
        let (key, voice) = builder.keys().next().unwrap();
        let counted_by = |work: &Arc<RehearsalWork>| {
            let mut key = RehearsedKey::of_scene(&builder, key, voice).unwrap();
            key.count_by(Arc::clone(work));
            key
        };
        let work = Arc::new(RehearsalWork::new(10_000, Arc::default()));
        let mut counted = counted_by(&work);
        counted.play(&[], 9.0);
        assert!(work.verdict().is_ok());
        counted.clone().play(&[], 1e9);
        assert!(matches!(work.verdict(), Err(RehearsalError::TooLong)));
        let is_cancelled = Arc::new(AtomicBool::new(true));
        let work = Arc::new(RehearsalWork::new(10_000, is_cancelled));
        counted_by(&work).play(&[], 1e9);
        assert!(matches!(work.verdict(), Err(RehearsalError::Cancelled)));
    }
}
