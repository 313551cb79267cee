use std::fmt;

use keyboard::{KeyIndex, KeyRange};
use scene::{KeyVoice, Scene};

use super::remedy::{Remedy, nearest};
use super::trial::{UnstableTrial, first_unstable};
use crate::rehearsal::RehearsalError;
use crate::tick_cost::{TickCost, tick_cost};
use crate::weight::{TouchWeights, WeightError, touch_weights};

/// Tried keys of a range: instruments are graded evenly over the compass.
const TRIED: u8 = 5;

/// Tried gains of the force beyond the scene's own.
const GAINS: [f64; 8] = [1.1, 1.25, 1.4, 1.6, 2.0, 2.5, 3.2, 4.0];

/// Stability of the keys of one range.
#[derive(Clone, PartialEq, Debug)]
pub struct RangeStability {
    pub keys: KeyRange,
    pub model: &'static str,
    /// First unstable key; `None` if all tried ones are stable.
    pub unstable: Option<UnstableKey>,
    /// Largest tried gain of the force that is stable; `None` if not measured or unstable.
    pub gain_margin: Option<f64>,
    /// Weights of the key in the middle of the range; `None` if not measured.
    pub weights: Option<TouchWeights>,
    /// Time of its ticks on this machine; `None` if not measured.
    pub cost: Option<TickCost>,
}

/// An unstable key with its remedy.
#[derive(Clone, PartialEq, Debug)]
pub struct UnstableKey {
    pub key: KeyIndex,
    pub model: &'static str,
    pub does: &'static str,
    pub finger: &'static str,
    pub tick_hz: u32,
    /// Delay of the rig in the trial (s).
    pub delay: f64,
    pub remedy: Option<Remedy>,
}

impl UnstableKey {
    pub fn what(&self) -> String {
        let Self { key, model, does, finger, tick_hz, delay, .. } = self;
        let delay = if 0.0 < *delay {
            format!(" and {:.2} ms of delay", 1e3 * delay)
        } else {
            String::new()
        };
        format!("{key} with {model} {does} under {finger} finger at {tick_hz} Hz{delay}")
    }

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
        if let Some(weights) = self.weights {
            write!(f, "; the finger feels {weights}")?;
        }
        self.cost.map_or(Ok(()), |cost| write!(f, "; {cost}"))
    }
}

/// Tries some keys of every range of `scene`.
pub fn examine(scene: &Scene) -> Result<Vec<RangeStability>, RehearsalError> {
    ranges(scene).into_iter().map(|keys| examine_keys(scene, keys)).collect()
}

/// Tries some keys of every range; returns a sentence on each unstable range.
pub fn instabilities(scene: &Scene) -> Result<Vec<String>, RehearsalError> {
    let unstable = examine(scene)?.into_iter().filter_map(|it| it.unstable);
    Ok(unstable.map(|it| it.to_string()).collect())
}

/// Tries some keys of a range, which all have a voice of one model.
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
    Ok(RangeStability { keys, model, unstable, gain_margin: None, weights: None, cost: None })
}

impl RangeStability {
    /// Adds the gain margin and the weights of the key in the middle of the range.
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
        self.cost = tick_cost(scene, voice).ok();
        Ok(self)
    }
}

fn voice(scene: &Scene, key: KeyIndex) -> Option<&KeyVoice> {
    scene.keys.get(key.index())?.as_ref()
}

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

fn tried(keys: KeyRange) -> impl Iterator<Item = KeyIndex> {
    let (start, steps) = (keys.first().number(), len(keys) - 1);
    let parts = TRIED.min(len(keys));
    let places = (0..parts)
        .map(move |part| u16::from(steps) * u16::from(part) / u16::from((parts - 1).max(1)));
    places.filter_map(move |place| KeyIndex::new(start + u8::try_from(place).ok()?))
}

const fn len(keys: KeyRange) -> u8 {
    keys.last().number() - keys.first().number() + 1
}
