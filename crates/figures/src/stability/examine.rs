//! Trials of a whole scene.

use std::fmt;

use keyboard::{KeyIndex, KeyRange};
use scene::{KeyVoice, Scene};

use super::remedy::{Remedy, nearest};
use super::trial::{UnstableTrial, first_unstable};
use crate::rehearsal::RehearsalError;
use crate::weight::{TouchWeights, WeightError, touch_weights};

/// Keys of a range that are tried: instruments are graded evenly over the compass.
const TRIED: u8 = 5;

/// Gains of the force that are tried beyond the scene's own.
const GAINS: [f64; 8] = [1.1, 1.25, 1.4, 1.6, 2.0, 2.5, 3.2, 4.0];

/// What trials say of the keys of one range.
#[derive(Clone, PartialEq, Debug)]
pub struct RangeStability {
    pub keys: KeyRange,
    /// The model that they play.
    pub model: &'static str,
    /// The first key that is not stable; none if all that were tried are.
    pub unstable: Option<UnstableKey>,
    /// How many times its force a key may have and is still stable, as far as it was tried; none
    /// where nobody asked, or where it is not stable.
    pub gain_margin: Option<f64>,
    /// The weights of the key in the middle of the range; none where nobody asked.
    pub weights: Option<TouchWeights>,
}

/// A key that is not stable, and what would make it so.
#[derive(Clone, PartialEq, Debug)]
pub struct UnstableKey {
    pub key: KeyIndex,
    pub model: &'static str,
    /// What the key does that shows it.
    pub does: &'static str,
    /// The finger under which it does so.
    pub finger: &'static str,
    pub tick_hz: u32,
    /// The rig's delay in that trial (s).
    pub delay: f64,
    /// The nearest settings with which it is stable.
    pub remedy: Option<Remedy>,
}

impl UnstableKey {
    /// Returns what is wrong, without the remedy.
    pub fn what(&self) -> String {
        let Self { key, model, does, finger, tick_hz, delay, .. } = self;
        let delay = if 0.0 < *delay {
            format!(" and {:.2} ms of delay", 1e3 * delay)
        } else {
            String::new()
        };
        format!("{key} with {model} {does} under {finger} finger at {tick_hz} Hz{delay}")
    }

    /// Returns what to do about it.
    pub fn help(&self) -> String {
        match &self.remedy {
            Some(remedy) => {
                format!("set {remedy} for the whole scene, or choose another instrument")
            }
            None => "choose another instrument, or a rig with less delay".to_owned(),
        }
    }
}

impl fmt::Display for UnstableKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}; {}", self.what(), self.help())
    }
}

impl fmt::Display for RangeStability {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(unstable) = &self.unstable {
            return unstable.fmt(f);
        }
        let (first, last) = (self.keys.first(), self.keys.last());
        write!(f, "{first}..{last} with {} stable", self.model)?;
        if let Some(margin) = self.gain_margin {
            write!(f, ", up to {margin} times its force")?;
        }
        match self.weights {
            Some(weights) => write!(f, "; the finger feels {weights}"),
            None => Ok(()),
        }
    }
}

/// Tries some keys of every range of `scene`.
///
/// # Errors
/// If voices or the keybed are refused.
pub fn examine(scene: &Scene) -> Result<Vec<RangeStability>, RehearsalError> {
    ranges(scene).into_iter().map(|keys| examine_keys(scene, keys)).collect()
}

/// Tries the same keys; returns a sentence on each range that is not stable.
///
/// # Errors
/// If voices or the keybed are refused.
pub fn instabilities(scene: &Scene) -> Result<Vec<String>, RehearsalError> {
    let unstable = examine(scene)?.into_iter().filter_map(|it| it.unstable);
    Ok(unstable.map(|it| it.to_string()).collect())
}

/// Tries some keys of a range, which all have a voice of one model.
///
/// # Errors
/// If voices or the keybed are refused.
pub fn examine_keys(scene: &Scene, keys: KeyRange) -> Result<RangeStability, RehearsalError> {
    let voices: Vec<_> = tried(keys).filter_map(|key| Some((key, voice(scene, key)?))).collect();
    let model = voices.first().map_or("", |(_key, voice)| voice.model.name);
    let unstable = match first_unstable(scene, &voices)? {
        None => None,
        Some(UnstableTrial { key, finger, delay, instability }) => Some(UnstableKey {
            key,
            model,
            does: instability.what(),
            finger,
            tick_hz: scene.tick_hz,
            delay,
            remedy: nearest(scene, &voices, key)?,
        }),
    };
    Ok(RangeStability { keys, model, unstable, gain_margin: None, weights: None })
}

impl RangeStability {
    /// Adds the gain margin and the weights of the key in the middle of the range.
    ///
    /// # Errors
    /// If voices or the keybed are refused.
    pub fn with_figures(mut self, scene: &Scene) -> Result<Self, WeightError> {
        let Some(key) = KeyIndex::new(self.keys.first().number() + len(self.keys) / 2) else {
            return Ok(self);
        };
        let Some(voice) = voice(scene, key).filter(|_| self.unstable.is_none()) else {
            return Ok(self);
        };
        let mut margin = 1.0;
        for gain in GAINS {
            let mut louder = scene.clone();
            louder.render.force_gain *= gain;
            if first_unstable(&louder, &[(key, voice)])?.is_some() {
                break;
            }
            margin = gain;
        }
        self.gain_margin = Some(margin);
        self.weights = touch_weights(scene, key)?;
        Ok(self)
    }
}

fn voice(scene: &Scene, key: KeyIndex) -> Option<&KeyVoice> {
    scene.keys.get(key.index())?.as_ref()
}

/// Ranges of neighbouring keys that play one model.
fn ranges(scene: &Scene) -> Vec<KeyRange> {
    let model = |key: KeyIndex| voice(scene, key).map(|it| it.model.name);
    let mut ranges: Vec<KeyRange> = Vec::new();
    for key in KeyIndex::all().filter(|key| model(*key).is_some()) {
        let longer = ranges.last().and_then(|last| {
            let is_next = last.last().number() + 1 == key.number();
            let goes_on = is_next && model(key) == model(last.first());
            KeyRange::new(last.first(), key).filter(|_| goes_on)
        });
        match (ranges.last_mut(), longer) {
            (Some(last), Some(longer)) => *last = longer,
            _ => ranges.extend(KeyRange::new(key, key)),
        }
    }
    ranges
}

/// The keys that are tried of `keys`, first and last among them.
fn tried(keys: KeyRange) -> impl Iterator<Item = KeyIndex> {
    let (start, steps) = (keys.first().number(), len(keys) - 1);
    let parts = TRIED.min(len(keys));
    let places = (0..parts)
        .map(move |part| u16::from(steps) * u16::from(part) / u16::from((parts - 1).max(1)));
    places.filter_map(move |place| KeyIndex::new(start + u8::try_from(place).ok()?))
}

/// How many keys there are in a range.
const fn len(keys: KeyRange) -> u8 {
    keys.last().number() - keys.first().number() + 1
}
