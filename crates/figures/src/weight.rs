//! Weights that move a key, or make it sound at a velocity, found on a key in its loop.

use std::fmt;

use engine::voice::VoiceBuilder;
use haptics::HandCommand;
use keyboard::KeyIndex;
use midi::Velocity;
use scene::Scene;
use scheduler::motion::KeyEvent;

use crate::rehearsal::{RehearsalError, RehearsedKey};

/// Largest weight of a finger (N).
pub const HEAVIEST: f64 = 50.0;

/// Bisections between no weight and the largest: to a twentieth of a millinewton.
const HALVINGS: u32 = 20;

/// Travels of touch weights, as fractions of the dip: 2 and 4.5 of 10.16 mm.
const WEIGHED: [f64; 2] = [0.197, 0.443];

/// Largest tried touch weight (N).
const MOST_WEIGHED: f64 = 10.0;

/// Change of a touch weight (N/s): a key that falls through takes 0.1 s, 1 gf.
const WEIGHING_RATE: f64 = 0.1;

/// Rest of the key before the press, and time in which it must sound (s).
const STILL: f64 = 0.02;
const SOUNDS: f64 = 1.0;

/// Error in a search for a weight.
#[derive(Debug, thiserror::Error)]
pub enum WeightError {
    #[error("{0} has no voice in this scene")]
    NoVoice(KeyIndex),
    #[error(
        "{key} does not sound at velocity {wanted} under the weight of a finger: {HEAVIEST} N give \
         {most}; give a smaller velocity, or --force"
    )]
    TooFast {
        key: KeyIndex,
        wanted: u8,
        /// Velocity at the largest weight; 0 if the key does not sound.
        most: u8,
    },
    #[error(transparent)]
    Rehearsal(#[from] RehearsalError),
}

/// Returns the smallest weight (N) that makes the resting `key` sound at `velocity` or more.
///
/// # Errors
/// If the key has no voice, or the largest weight is too small.
pub fn weight_for(scene: &Scene, key: KeyIndex, velocity: Velocity) -> Result<f64, WeightError> {
    let builder = VoiceBuilder::new(scene).map_err(RehearsalError::from)?;
    let still = still(&builder, scene, key)?;
    let heard = |newtons| {
        let speed = hammer_speed(still.clone(), newtons);
        speed.map_or(0, |speed| scene.midi.curve.velocity(speed).get())
    };
    let (wanted, most) = (velocity.get(), heard(HEAVIEST));
    if most < wanted {
        return Err(WeightError::TooFast { key, wanted, most });
    }
    let (mut too_light, mut enough) = (0.0, HEAVIEST);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (too_light + enough);
        *if heard(middle) < wanted { &mut too_light } else { &mut enough } = middle;
    }
    Ok(enough)
}

/// Touch weights of a technician, at the front of a key in its loop.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct TouchWeights {
    /// Least weight under which the key goes down (N).
    pub down: f64,
    /// Largest weight that the key lifts (N).
    pub up: f64,
}

impl fmt::Display for TouchWeights {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        /// Force of a gram's weight (N).
        const GF: f64 = 9.806_65e-3;
        let [down, up] = [self.down, self.up].map(|newtons| newtons / GF);
        write!(f, "{down:.0} gf down, {up:.0} gf up")
    }
}

/// Returns the weights that move `key`; `None` if 10 N do not, or if it is not lifted again.
///
/// The weight grows by 0.1 N/s until the key passes 4.5 mm of a grand's 10.16 mm, and shrinks from
/// there until it returns to 2 mm: before the damper and the let-off, as technicians measure.
pub fn touch_weights(scene: &Scene, key: KeyIndex) -> Result<Option<TouchWeights>, WeightError> {
    let builder = VoiceBuilder::new(scene).map_err(RehearsalError::from)?;
    let mut still = still(&builder, scene, key)?;
    let [high, low] = WEIGHED.map(|part| part * builder.rig().key.bottom_stop.position);
    let down = weighed(&mut still, (0.0, MOST_WEIGHED), |at| low < at);
    let up = down.and_then(|down| weighed(&mut still, (down, 0.0), |at| at < high));
    Ok(down.zip(up).map(|(down, up)| TouchWeights { down, up }))
}

fn weighed(
    key: &mut RehearsedKey,
    (from, to): (f64, f64),
    is_there: impl Fn(f64) -> bool,
) -> Option<f64> {
    let start = key.now();
    loop {
        let change = WEIGHING_RATE * (key.now() - start);
        if (to - from).abs() < change {
            return None;
        }
        let newtons = from + change.copysign(to - from);
        key.press(HandCommand::Weight(newtons));
        key.step();
        if is_there(key.position()) {
            return Some(newtons);
        }
    }
}

fn still(
    builder: &VoiceBuilder<'_>,
    scene: &Scene,
    key: KeyIndex,
) -> Result<RehearsedKey, WeightError> {
    let voice = scene.keys.get(key.index()).and_then(Option::as_ref);
    let voice = voice.ok_or(WeightError::NoVoice(key))?;
    let mut rehearsed = RehearsedKey::of_scene(builder, key.index(), voice)?;
    while rehearsed.now() < STILL {
        rehearsed.step();
    }
    Ok(rehearsed)
}

/// Returns the speed of the hammer of `key` under a weight (m/s), if it strikes.
fn hammer_speed(mut key: RehearsedKey, newtons: f64) -> Option<f64> {
    key.press(HandCommand::Weight(newtons));
    let end = key.now() + SOUNDS;
    while key.now() < end {
        let turn = key.step();
        let strike = turn.events.as_slice().iter().find_map(|(_at, event)| match event {
            KeyEvent::Strike { loudness, .. } => Some(loudness.hammer_speed),
            KeyEvent::DamperLift | KeyEvent::DamperFall { .. } | KeyEvent::Pressure { .. } => None,
        });
        if strike.is_some() {
            return strike;
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_weight_gives_the_velocity_that_was_wanted_and_less_does_not() {
        let scene =
            Scene::load(&scene::Library::default(), "springs", &[]).expect("a scene of ours");
        let builder = VoiceBuilder::new(&scene).expect("a scene of ours");
        let key = KeyIndex::new(39).expect("C4");
        let heard = |newtons| {
            let still = still(&builder, &scene, key).expect("a key");
            hammer_speed(still, newtons).map_or(0, |it| scene.midi.curve.velocity(it).get())
        };
        let mut last = 0.0;
        for wanted in [60, 70] {
            let velocity = Velocity::new(wanted).expect("a velocity");
            let newtons = weight_for(&scene, key, velocity).expect("a weight");
            assert!(last < newtons && newtons < HEAVIEST, "{wanted}: {newtons} N");
            let velocity = heard(newtons);
            assert!((wanted..=wanted + 2).contains(&velocity), "{wanted}: {velocity}");
            assert!(heard(0.7 * newtons) < wanted, "{wanted}");
            last = newtons;
        }
    }

    #[test]
    fn a_stiffer_spring_weighs_more_by_hookes_law_and_lifts_what_presses_it() {
        let mut scene =
            Scene::load(&scene::Library::default(), "springs", &[]).expect("a scene of ours");
        let key = KeyIndex::new(39).expect("C4");
        let model =
            scene.library.find("spring", std::path::Path::new("")).expect("a model of ours");
        let mut weighed = |stiffness: f64| {
            scene.keys[39] =
                Some(scene::KeyVoice { model: model.clone(), values: vec![stiffness], file: None });
            let weights = touch_weights(&scene, key).expect("a key").expect("it moves");
            (weights, VoiceBuilder::new(&scene).expect("a scene").rig().key.bottom_stop.position)
        };
        let [(soft, dip), (stiff, _)] = [100.0, 200.0].map(&mut weighed);
        // The rig's bearing sticks and slips by 0.1 mm: 0.02 N of the stiff spring.
        for (more, part) in [(stiff.down - soft.down, 0.443), (stiff.up - soft.up, 0.197)] {
            assert!((more - 100.0 * part * dip).abs() < 0.02, "{more} N at {part} of the dip");
        }
    }

    #[test]
    fn a_key_without_a_voice_and_a_velocity_beyond_a_finger_are_refused() {
        let mut scene =
            Scene::load(&scene::Library::default(), "springs", &[]).expect("a scene of ours");
        let key = KeyIndex::new(39).expect("C4");
        let most = Velocity::new(127).expect("a velocity");
        if let Err(refused) = weight_for(&scene, key, most) {
            assert!(refused.to_string().contains("C4 does not sound at velocity 127"), "{refused}");
        }
        scene.keys[39] = None;
        let refused = weight_for(&scene, key, most).expect_err("it is silent").to_string();
        assert_eq!(refused, "C4 has no voice in this scene");
    }
}
