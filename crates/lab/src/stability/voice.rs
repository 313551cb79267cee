//! What answers the key: a wall, or the voice of a model.

use haptics::{BackwardDifference, Estimator, Kalman};

use super::quantity::{FINEST_STEP, LoopQuantity, LoopValues};

/// What answers the key in a loop, tick by tick.
pub trait TrialVoice {
    /// Returns the answer to a key that reads `position` (m) at `tick`; ticks grow by one.
    fn answer(&mut self, tick: u64, position: f64) -> TrialAnswer;
}

/// What is answered in one tick.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum TrialAnswer {
    /// A force on the finger (N), up positive.
    Force(f64),
    /// The voice was muted because it makes energy.
    Muted,
    /// The model cannot be followed.
    Failed,
}

/// From positions to velocity.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LoopEstimator {
    BackwardDifference,
    Kalman,
}

impl LoopEstimator {
    /// Every estimator, that of the theory first.
    pub const ALL: [Self; 2] = [Self::BackwardDifference, Self::Kalman];

    /// Returns its name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::BackwardDifference => "backward-difference",
            Self::Kalman => "kalman",
        }
    }
}

/// What a voice is made for.
#[derive(Clone, Copy, Debug)]
pub struct VoiceOrder<'a> {
    pub values: &'a LoopValues,
    pub estimator: LoopEstimator,
    /// One value per parameter of the model; none for a wall.
    pub parameters: &'a [f64],
}

/// A wall that pushes and pulls: F = K x + B v of what the estimator says.
struct RenderedWall {
    stiffness: f64,
    damping: f64,
    period: f64,
    estimator: Box<dyn Estimator>,
}

impl TrialVoice for RenderedWall {
    fn answer(&mut self, _tick: u64, position: f64) -> TrialAnswer {
        let motion = self.estimator.update(position, self.period);
        TrialAnswer::Force(self.stiffness * motion.position + self.damping * motion.velocity)
    }
}

/// Returns a wall as it is rendered.
pub(super) fn wall(order: &VoiceOrder<'_>) -> Box<dyn TrialVoice> {
    let get = |quantity| order.values.get(quantity);
    let period = get(LoopQuantity::Period);
    let estimator: Box<dyn Estimator> = match order.estimator {
        LoopEstimator::BackwardDifference => Box::new(BackwardDifference::new(period)),
        LoopEstimator::Kalman => {
            // One that has no steps is as good as the finest.
            let quantum = get(LoopQuantity::EncoderStep).max(FINEST_STEP);
            Box::new(Kalman::new(period, quantum, get(LoopQuantity::JerkDensity)))
        }
    };
    let (stiffness, damping) = (get(LoopQuantity::Stiffness), get(LoopQuantity::Damping));
    Box::new(RenderedWall { stiffness, damping, period, estimator })
}
