//! From samples to a model's input: estimate, then continue over the tick.

use haptics::{BackwardDifference, Estimator as _, Kalman, Motion as KeyMotion};
use pode::input::{Cubic, Reconstruction, Reconstructor};
use scheduler::motion::KeySample;

/// Which estimator of a key's motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AnyEstimator {
    /// First and second backward differences.
    BackwardDifference(BackwardDifference),
    /// Constant-acceleration Kalman filter.
    Kalman(Kalman),
}

impl AnyEstimator {
    fn update(&mut self, position: f64, elapsed: f64) -> KeyMotion {
        match self {
            Self::BackwardDifference(it) => it.update(position, elapsed),
            Self::Kalman(it) => it.update(position, elapsed),
        }
    }

    fn reset(&mut self, position: f64) {
        match self {
            Self::BackwardDifference(it) => it.reset(position),
            Self::Kalman(it) => it.reset(position),
        }
    }
}

/// How the motion goes on over the tick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Continuation {
    /// With the estimated velocity and acceleration.
    Estimate,
    /// From the samples alone.
    Samples(Reconstruction, Reconstructor),
}

/// The way from samples to the input of one voice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InputPath {
    estimator: AnyEstimator,
    continuation: Continuation,
    /// Model input per metre.
    scale: f64,
    /// Tick [s].
    h: f64,
    /// The motion at the newest sample.
    last: KeyMotion,
    /// The tick that was asked for last, if there was one.
    tick: Option<u64>,
    /// How long before that tick this sample was taken [ticks].
    since: f64,
}

/// The input over one tick.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Followed {
    /// Of the model.
    pub signal: Cubic,
    /// Where the key is at the start of the tick [m].
    pub position: f64,
    /// How much after the usual its newest sample was taken before that [s].
    pub late: f64,
}

/// Samples closer than this are one and the same [ticks].
const NEWS: f64 = 1e-3;

/// How far motion goes on without a sample [ticks]; then the key is taken to stay where it is.
const MOST_AHEAD: f64 = 1.0;

impl InputPath {
    /// A path with ticks of `h` [s] for a model whose input is `scale` per metre.
    pub fn new(
        estimator: AnyEstimator,
        reconstruction: Option<Reconstruction>,
        scale: f64,
        h: f64,
    ) -> Self {
        let continuation = reconstruction.map_or(Continuation::Estimate, |kind| {
            Continuation::Samples(kind, Reconstructor::new(kind, 0.0, h))
        });
        let last = KeyMotion::at_rest(0.0);
        Self { estimator, continuation, scale, h, last, tick: None, since: 0.0 }
    }

    /// At rest at `position` [m] since the next tick; returns the input there.
    pub fn reset(&mut self, position: f64) -> pode::Motion {
        self.estimator.reset(position);
        if let Continuation::Samples(kind, reconstructor) = &mut self.continuation {
            *reconstructor = Reconstructor::new(*kind, position * self.scale, self.h);
        }
        self.last = KeyMotion::at_rest(position);
        self.tick = None;
        pode::Motion { position: position * self.scale, ..pode::Motion::default() }
    }

    /// Goes on to `tick`; says how long after the one before `sample` was taken [ticks], if it is
    /// a new one.
    pub fn go_on(&mut self, tick: u64, sample: &KeySample) -> Option<f64> {
        let Some(before) = self.tick.replace(tick) else {
            self.since = sample.taken;
            return Some(1.0);
        };
        let passed = tick.saturating_sub(before) as f64;
        let elapsed = self.since + passed - sample.taken;
        let is_news = NEWS < elapsed;
        self.since = if is_news { sample.taken } else { self.since + passed };
        is_news.then_some(elapsed)
    }

    /// The input over `tick`, at whose start `sample` is the newest.
    pub fn follow(&mut self, tick: u64, sample: &KeySample) -> Followed {
        if let Some(elapsed) = self.go_on(tick, sample) {
            self.last = self.estimator.update(sample.position, elapsed * self.h);
        }
        let (motion, position) = if self.since == 0.0 {
            (self.last, sample.position)
        } else {
            let motion = self.last.after(self.since.min(MOST_AHEAD) * self.h);
            let is_over = MOST_AHEAD < self.since;
            let motion = if is_over { KeyMotion::at_rest(motion.position) } else { motion };
            (motion, motion.position)
        };
        let signal = match &mut self.continuation {
            Continuation::Estimate => Cubic::ballistic(
                motion.position * self.scale,
                motion.velocity * self.scale,
                motion.acceleration * self.scale,
                self.h,
            ),
            Continuation::Samples(_, reconstructor) => reconstructor.push(position * self.scale),
        };
        Followed { signal, position, late: self.since.min(MOST_AHEAD) * self.h }
    }
}
