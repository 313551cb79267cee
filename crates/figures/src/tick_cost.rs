//! Time that a key's ticks take on this machine.

use std::sync::Arc;
use std::{fmt, time::Instant};

use engine::voice::{BuildError, VoiceBuilder};
use haptics::quintic;
use scene::{KeyVoice, Scene};
use scheduler::motion::KeySample;
use scheduler::voice::VoiceOutput;

/// Number of strokes: of each tick the fastest one is reported.
const STROKES: usize = 10;

const PRESS: f64 = 0.043_125;

/// Times of a tick of one key (s), each the least over some strokes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct TickCost {
    /// Middle of the ticks in which the key goes down.
    pub moving: f64,
    /// Longest tick of a loud stroke.
    pub worst: f64,
    /// Period of the tick (s).
    pub period: f64,
}

impl fmt::Display for TickCost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { moving, worst, period } = self;
        let [moving, worst] = [moving, worst].map(|it| 1e6 * it);
        let part = moving / (1e4 * period);
        write!(f, "{moving:.1} us a tick while it moves ({part:.2} % of the period), ")?;
        write!(f, "{worst:.1} us in the longest of a loud stroke")
    }
}

/// Returns the ticks of half a second with the samples of a key that is pressed in 43 ms from 20 ms
/// on, held, and released from 0.3 s on.
pub fn loud_stroke(tick_hz: u32) -> impl Iterator<Item = (u64, KeySample)> {
    (0..tick_hz / 2).map(move |tick| {
        let t = f64::from(tick) / f64::from(tick_hz);
        let position = 11.5e-3 * (quintic((t - 0.02) / PRESS) - quintic((t - 0.3) / 0.08));
        (u64::from(tick), KeySample::fresh(position))
    })
}

/// Plays a loud stroke of half a second on one voice, and measures its ticks.
pub fn tick_cost(scene: &Scene, key: &KeyVoice) -> Result<TickCost, BuildError> {
    let mut voice = VoiceBuilder::new(scene)?.voice(key, Arc::default())?;
    let period = 1.0 / f64::from(scene.tick_hz);
    let mut least = vec![f64::INFINITY; (scene.tick_hz / 2) as usize];
    for _ in 0..STROKES {
        voice.reset(&KeySample::fresh(0.0));
        for ((tick, sample), time) in loud_stroke(scene.tick_hz).zip(&mut least) {
            let mut turn = VoiceOutput::default();
            let start = Instant::now();
            voice.tick(tick, &sample, &mut turn);
            *time = time.min(start.elapsed().as_secs_f64());
        }
    }
    let worst = least.iter().copied().fold(0.0, f64::max);
    let is_moving = |tick: u32| (0.022..0.02 + PRESS).contains(&(f64::from(tick) * period));
    let moving = (0_u32..).zip(&least).filter(|(tick, _)| is_moving(*tick));
    let mut moving: Vec<_> = moving.map(|(_, time)| *time).collect();
    moving.sort_by(f64::total_cmp);
    let moving = moving.get(moving.len() / 2).copied().unwrap_or(worst);
    Ok(TickCost { moving, worst, period })
}
