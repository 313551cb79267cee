//! From samples to a model's input: estimate, then continue over the tick.

use haptics::{BackwardDifference, Estimator as _, Kalman, Motion as KeyMotion};
use pode::input::{Cubic, Reconstruction, Reconstructor};

/// Which estimator of a key's motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AnyEstimator {
    /// First and second backward differences.
    BackwardDifference(BackwardDifference),
    /// Constant-acceleration Kalman filter.
    Kalman(Kalman),
}

impl AnyEstimator {
    fn update(&mut self, position: f64) -> KeyMotion {
        match self {
            Self::BackwardDifference(it) => it.update(position),
            Self::Kalman(it) => it.update(position),
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
    last: KeyMotion,
}

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
        let last = KeyMotion { position: 0.0, velocity: 0.0, acceleration: 0.0 };
        Self { estimator, continuation, scale, h, last }
    }

    /// At rest at `position` [m]; returns the input there.
    pub fn reset(&mut self, position: f64) -> pode::Motion {
        self.estimator.reset(position);
        if let Continuation::Samples(kind, reconstructor) = &mut self.continuation {
            *reconstructor = Reconstructor::new(*kind, position * self.scale, self.h);
        }
        self.last = KeyMotion { position, velocity: 0.0, acceleration: 0.0 };
        pode::Motion { position: position * self.scale, ..pode::Motion::default() }
    }

    /// Where the key should be now if nothing changed since the last sample [m].
    pub fn expected(&self) -> f64 {
        let KeyMotion { position, velocity, acceleration } = self.last;
        position + self.h * (velocity + 0.5 * self.h * acceleration)
    }

    /// Takes the position [m] at the start of a tick; returns the input over that tick.
    pub fn push(&mut self, position: f64) -> Cubic {
        let motion = self.estimator.update(position);
        self.last = motion;
        match &mut self.continuation {
            Continuation::Estimate => Cubic::ballistic(
                motion.position * self.scale,
                motion.velocity * self.scale,
                motion.acceleration * self.scale,
                self.h,
            ),
            Continuation::Samples(_, reconstructor) => reconstructor.push(position * self.scale),
        }
    }
}
