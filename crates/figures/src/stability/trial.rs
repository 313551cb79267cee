//! One key under one finger: stable while played, and quiet afterwards.

use engine::voice::VoiceBuilder;
use haptics::plant::{Gesture, Touch};
use haptics::{FingerParameters, Grasp, RigParameters, Swing};
use keyboard::KeyIndex;
use scene::{KeyVoice, Scene};
use scheduler::voice::VoiceFault;

use crate::rehearsal::{RehearsalError, RehearsedKey};

/// Symptom of an unstable loop.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Instability {
    Fault(VoiceFault),
    Untouched,
    Chatters,
    Shakes,
}

impl Instability {
    /// Returns the end of a sentence that begins with the key's name.
    pub(super) const fn what(self) -> &'static str {
        match self {
            Self::Fault(VoiceFault::MakesEnergy) => "makes energy",
            Self::Fault(_) => "fails while it is played",
            Self::Untouched => "sounds with nobody at it",
            Self::Chatters => "sounds again and again while it is held",
            Self::Shakes => "shakes when it is let go",
        }
    }
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct UnstableTrial {
    pub(super) key: KeyIndex,
    pub(super) finger: &'static str,
    /// Delay of the rig (s).
    pub(super) delay: f64,
    pub(super) instability: Instability,
}

const FINGERS: [(&str, FingerParameters); 3] = [
    ("an ordinary", FingerParameters::ORDINARY),
    ("a stiff", FingerParameters::STIFF),
    ("a limp", FingerParameters::LIMP),
];

/// Time without a finger before the first stroke (s).
const UNTOUCHED: f64 = 0.1;

/// Strokes of a trial: start and release (s), speed (m/s), touch.
const STROKES: [(f64, f64, f64, Touch); 3] = [
    (UNTOUCHED, 0.25, 0.2, Touch::Pressed),
    (0.45, 0.6, 1.0, Touch::Pressed),
    (0.8, 0.95, 2.5, Touch::Struck),
];

/// Tried delays, as fractions of the rig's.
const DELAYS: [f64; 3] = [1.0, 0.5, 0.0];

/// Length of a trial (s).
const LENGTH: f64 = 1.6;

/// End of a trial, compared in two halves (s).
const QUIET: f64 = 0.3;

/// Maximum strikes of one stroke: a pendulum on a cart bounces that often.
const CHATTER: usize = 6;

/// Tries `voices` of a scene; returns the first trial with an unstable key.
///
/// A link delays some samples less, so shorter delays than the rig's are tried too. A loop that
/// shakes without a delay and is quiet with one has a limit cycle whose phase happens to fit.
pub(super) fn first_unstable(
    scene: &Scene,
    voices: &[(KeyIndex, &KeyVoice)],
) -> Result<Option<UnstableTrial>, RehearsalError> {
    let mut tried = scene.clone();
    for part in if 0.0 < scene.rig.delay { &DELAYS[..] } else { &DELAYS[..1] } {
        let delay = part * scene.rig.delay;
        tried.rig.delay = delay;
        let builder = VoiceBuilder::new(&tried)?;
        for &(key, voice) in voices {
            if let Some((finger, instability)) = worst(&builder, (key.index(), voice))? {
                return Ok(Some(UnstableTrial { key, finger, delay, instability }));
            }
        }
    }
    Ok(None)
}

/// Tries all fingers on a key, or its gripping hand; returns the first unstable one and symptom.
fn worst(
    builder: &VoiceBuilder<'_>,
    key: (usize, &KeyVoice),
) -> Result<Option<(&'static str, Instability)>, RehearsalError> {
    let hand = builder.rig().finger;
    let hands = match hand.grasp {
        Grasp::Pushes => FINGERS.to_vec(),
        Grasp::Grips => vec![("a gripping", hand)],
    };
    for (name, finger) in hands {
        let rig = RigParameters { finger, ..builder.rig() };
        let rehearsed = RehearsedKey::on_rig(builder, key, rig)?;
        if let Some(found) = play(rehearsed, rig.key.bottom_stop.position) {
            return Ok(Some((name, found)));
        }
    }
    Ok(None)
}

/// Plays the strokes on a key with a dip of `dip` (m).
fn play(mut key: RehearsedKey, dip: f64) -> Option<Instability> {
    let hold = Gesture::hold_of(dip);
    let gesture = |(start, release, speed, touch)| Gesture {
        start,
        release,
        touch,
        speed,
        hold,
        ..Gesture::USUAL
    };
    key.take(STROKES.map(gesture).into());
    let mut seen = TrialLog::default();
    while key.now() < LENGTH {
        if let Some(found) = seen.tick(&mut key) {
            return Some(found);
        }
    }
    seen.shakes(dip).then_some(Instability::Shakes)
}

#[derive(Clone, Copy, Debug, Default)]
struct TrialLog {
    strikes: usize,
    stroke: usize,
    end: [Swing; 2],
    position: f64,
}

impl TrialLog {
    /// Advances by a tick; returns a symptom of instability.
    fn tick(&mut self, key: &mut RehearsedKey) -> Option<Instability> {
        let now = key.now();
        let turn = key.step();
        let fault = turn.fault.map(Instability::Fault);
        let strikes = turn.events.strikes();
        let stroke = STROKES.iter().filter(|it| it.0 <= now).count();
        self.strikes = if stroke == self.stroke { self.strikes + strikes } else { strikes };
        self.stroke = stroke;
        let position = key.position();
        if LENGTH - QUIET <= now {
            let half = &mut self.end[usize::from(LENGTH - 0.5 * QUIET <= now)];
            half.add(position - self.position);
        }
        self.position = position;
        let is_alone = !(UNTOUCHED..LENGTH - QUIET).contains(&now);
        let alone = (is_alone && 0 < strikes).then_some(Instability::Untouched);
        let chatters = (CHATTER < self.strikes).then_some(Instability::Chatters);
        fault.or(alone).or(chatters)
    }

    /// Returns `true` if a key with a dip of `dip` (m) swung at the end without decay.
    fn shakes(&self, dip: f64) -> bool {
        let [first, second] = self.end.map(|it| it.to_and_fro() / dip);
        Swing::SHAKING < second || Swing::grows(first, second)
    }
}
