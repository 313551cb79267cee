//! The load of the key: a wall, or the voice of a model.

use haptics::{AnyEstimator, Estimator as _, EstimatorName, EstimatorSettings};

use super::quantity::{FINEST_STEP, LoopQuantity, LoopValues};

/// A load of the key in a loop, tick by tick.
pub trait TrialVoice {
    /// Returns the answer to a key at `position` (m) at `tick`; ticks grow by one.
    fn answer(&mut self, tick: u64, position: f64) -> TrialAnswer;
}

/// Answer of a load in one tick.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum TrialAnswer {
    /// Force on the finger (N), up positive.
    Force(f64),
    /// Muted because the voice generated energy.
    Muted,
    Failed,
}

/// Parameters of a voice.
#[derive(Clone, Copy, Debug)]
pub struct VoiceOrder<'a> {
    pub values: &'a LoopValues,
    pub estimator: EstimatorName,
    /// One value per parameter of the model; empty for a wall.
    pub parameters: &'a [f64],
}

/// A wall that pushes and pulls: F = K x + B v with the estimated motion.
struct RenderedWall {
    stiffness: f64,
    damping: f64,
    period: f64,
    estimator: AnyEstimator,
}

impl TrialVoice for RenderedWall {
    fn answer(&mut self, _tick: u64, position: f64) -> TrialAnswer {
        let motion = self.estimator.update(position, self.period);
        TrialAnswer::Force(self.stiffness * motion.position + self.damping * motion.velocity)
    }
}

pub fn wall(order: &VoiceOrder<'_>) -> Box<dyn TrialVoice> {
    let get = |quantity| order.values.get(quantity);
    let period = get(LoopQuantity::Period);
    let settings = EstimatorSettings {
        period,
        // An encoder without steps counts as the finest.
        quantum: get(LoopQuantity::EncoderStep).max(FINEST_STEP),
        jerk_density: get(LoopQuantity::JerkDensity),
        cutoff: EstimatorSettings::KEY_CUTOFF,
        jerk_limit: EstimatorSettings::KEY_JERK_LIMIT,
    };
    let estimator = AnyEstimator::new(order.estimator, &settings);
    let (stiffness, damping) = (get(LoopQuantity::Stiffness), get(LoopQuantity::Damping));
    Box::new(RenderedWall { stiffness, damping, period, estimator })
}
