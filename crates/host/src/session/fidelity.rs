//! Chooses fidelities: as much of each action as this machine can compute within the budget.

use std::f64::consts::TAU;
use std::sync::Arc;

use engine::realtime::clock;
use engine::voice::{BuildError, VoiceBuilder};
use keyboard::KeyRange;
use scene::{FidelityLevel, KeyVoice, Scene};
use scheduler::motion::KeySample;
use scheduler::time::Nanos;
use scheduler::voice::VoiceOutput;

use crate::report::{ChosenFidelity, RefusedFidelity};

/// One of so many neighbouring keys is timed.
const SAMPLED: usize = 11;
/// Number of rounds. The shortest one counts, because the machine may disturb the others.
const ROUNDS: u64 = 3;
/// Length of a round (s), in which the key goes down and up once.
const ROUND: f64 = 0.35;
/// Depth of the motion (m): to the bed of most instruments.
const DEPTH: f64 = 10.5e-3;

/// Gives each range of `scene` without a fixed fidelity the highest level with which all keys
/// together keep the scene's budget, or else the lowest; returns the choices.
///
/// Times voices on the calling thread. In virtual time, without deadlines and with equal runs,
/// every range keeps its highest level instead.
pub fn choose_fidelity(scene: &mut Scene) -> Result<Vec<ChosenFidelity>, BuildError> {
    let ranges = std::mem::take(&mut scene.fidelity.ranges);
    if ranges.is_empty() {
        return Ok(Vec::new());
    }
    let is_auto = |key: usize| {
        ranges.iter().any(|range| range.keys.numbers().any(|number| usize::from(number) == key))
    };
    let rest: Vec<_> = (0..scene.keys.len()).filter(|key| !is_auto(*key)).collect();
    let rest = share(scene, &rest)?;
    let mut shares = Vec::new();
    for range in &ranges {
        shares.push(vec![level_share(scene, range.keys, &range.levels[0])?]);
    }
    let taken = |shares: &[Vec<f64>]| rest + shares.iter().filter_map(|it| it.last()).sum::<f64>();
    while scene.fidelity.budget < taken(&shares) {
        let Some(costliest) = costliest(&shares, |at, n| n < ranges[at].levels.len()) else {
            break;
        };
        let range = &ranges[costliest];
        let level = &range.levels[shares[costliest].len()];
        shares[costliest].push(level_share(scene, range.keys, level)?);
    }
    let chosen = ranges.iter().zip(&shares).map(|(range, shares)| {
        let (level, above) = (&range.levels[shares.len() - 1], &shares[..shares.len() - 1]);
        scene.set_fidelity(range.keys, level);
        let refused = range.levels.iter().zip(above);
        let refused = refused
            .map(|(it, share)| RefusedFidelity { fidelity: it.fidelity.name(), share: *share });
        ChosenFidelity {
            keys: range.keys.to_string(),
            fidelity: level.fidelity.name(),
            instrument: level.instrument.clone(),
            share: shares[shares.len() - 1],
            refused: refused.collect(),
        }
    });
    Ok(chosen.collect())
}

/// Returns the range with the largest share that has another level; `has_more` gets its index
/// and the number of levels that it has tried.
fn costliest(shares: &[Vec<f64>], has_more: impl Fn(usize, usize) -> bool) -> Option<usize> {
    let share = |at: &usize| shares[*at].last().copied().unwrap_or(0.0);
    let lower = (0..shares.len()).filter(|at| has_more(*at, shares[*at].len()));
    lower.max_by(|a, b| share(a).total_cmp(&share(b)))
}

fn level_share(scene: &Scene, range: KeyRange, level: &FidelityLevel) -> Result<f64, BuildError> {
    let mut tried = scene.clone();
    tried.set_fidelity(range, level);
    let keys: Vec<_> = range.numbers().map(usize::from).collect();
    share(&tried, &keys)
}

/// Returns the share of each lane's time for `keys` of a scene when they all move.
fn share(scene: &Scene, keys: &[usize]) -> Result<f64, BuildError> {
    let builder = VoiceBuilder::new(scene)?;
    let voices: Vec<_> = keys.iter().filter_map(|key| scene.keys[*key].as_ref()).collect();
    let (mut sum, mut timed) = (0.0, 0.0);
    for voice in voices.iter().step_by(SAMPLED) {
        sum += tick_cost(&builder, voice)?;
        timed += 1.0;
    }
    let lanes = super::threads::lanes(scene).get() as f64;
    Ok(if timed > 0.0 {
        sum / timed * voices.len() as f64 / (lanes * builder.period().as_secs_f64())
    } else {
        0.0
    })
}

/// Returns the mean CPU time for a tick of `voice` while its key goes down and up (s).
fn tick_cost(builder: &VoiceBuilder<'_>, voice: &KeyVoice) -> Result<f64, BuildError> {
    let period = builder.period().as_secs_f64();
    let mut voice = builder.voice(voice, Arc::default())?;
    voice.reset(&KeySample::fresh(0.0));
    let ticks = clock::nearest_integer(ROUND / period).max(1);
    let mut output = VoiceOutput::default();
    let mut round = |first: u64| {
        let begun = clock::thread_cpu();
        for tick in 0..ticks {
            let angle = TAU * tick as f64 / ticks as f64;
            let sample = KeySample::fresh(0.5 * DEPTH * (1.0 - angle.cos()));
            output.begin();
            voice.tick(first + tick, &sample, &mut output);
        }
        clock::thread_cpu().since(begun)
    };
    // The first round warms the caches.
    let shortest = (0..=ROUNDS).map(|it| round(it * ticks)).skip(1).min();
    Ok(shortest.unwrap_or(Nanos::ZERO).as_u64() as f64 * 1e-9 / ticks as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_range_that_takes_most_goes_down_first() {
        let shares = [vec![0.3], vec![0.5, 0.2], vec![0.1]];
        assert_eq!(costliest(&shares, |_, _| true), Some(0));
        assert_eq!(costliest(&shares, |at, _| at != 0), Some(1));
        assert_eq!(costliest(&shares, |_, _| false), None);
    }
}
