use std::fmt;

use haptics::EstimatorName;
use keyboard::KeyIndex;
use scene::{KeyVoice, PassivityMode, Scene};

use super::trial::first_unstable;
use crate::rehearsal::RehearsalError;

/// Rates that boards can keep (Hz).
const RATES: [u32; 6] = [250, 500, 1000, 2000, 4000, 10_000];

/// Densities of jerk, from a slow filter to a fast one (m²/s⁵).
const DENSITIES: [f64; 5] = [10.0, 300.0, 1e4, 1e5, 1e6];

/// Settings that make keys stable.
#[derive(Clone, PartialEq, Debug)]
pub struct Remedy {
    pub tick_hz: Option<u32>,
    pub jerk_density: Option<f64>,
    pub passivity: Option<PassivityMode>,
}

impl fmt::Display for Remedy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rate = self.tick_hz.map(|hz| format!("tick_hz={hz}"));
        let density = self.jerk_density.map(|it| format!("render.jerk_density={it}"));
        let passivity = self.passivity.map(|it| format!("render.passivity={:?}", it.name()));
        let all: Vec<_> = rate.into_iter().chain(density).chain(passivity).collect();
        f.write_str(&all.join(" and "))
    }
}

/// Returns the settings nearest to those of `scene` with which all of `voices` are stable: another
/// filter, or the next faster rates. `key` is the unstable one.
pub(super) fn nearest(
    scene: &Scene,
    voices: &[(KeyIndex, &KeyVoice)],
    key: KeyIndex,
) -> Result<Option<Remedy>, RehearsalError> {
    // Try the unstable key first: it rejects most candidates.
    let mut voices = voices.to_vec();
    voices.sort_by_key(|it| it.0 != key);
    for remedy in candidates(scene) {
        let mut other = scene.clone();
        other.tick_hz = remedy.tick_hz.unwrap_or(scene.tick_hz);
        other.render.jerk_density = remedy.jerk_density.unwrap_or(scene.render.jerk_density);
        other.render.passivity = remedy.passivity.unwrap_or(scene.render.passivity);
        if first_unstable(&other, &voices)?.is_none() {
            return Ok(Some(remedy));
        }
    }
    Ok(None)
}

fn candidates(scene: &Scene) -> Vec<Remedy> {
    let is_controlled = scene.render.passivity == PassivityMode::Control;
    let control = (!is_controlled).then_some(Remedy {
        tick_hz: None,
        jerk_density: None,
        passivity: Some(PassivityMode::Control),
    });
    let faster = RATES.into_iter().filter(|hz| scene.tick_hz < *hz).map(Some);
    let densities = || {
        let is_kalman = scene.render.estimator == EstimatorName::Kalman;
        let others = DENSITIES.into_iter().filter(move |_| is_kalman).map(Some);
        std::iter::once(None).chain(others)
    };
    let all = std::iter::once(None)
        .chain(faster)
        .flat_map(|tick_hz| densities().map(move |jerk_density| (tick_hz, jerk_density)));
    let all = all.map(|(tick_hz, jerk_density)| Remedy { tick_hz, jerk_density, passivity: None });
    control.into_iter().chain(all.skip(1)).collect()
}
