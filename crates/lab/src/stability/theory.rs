//! Theoretical boundaries in a map of a wall.

use haptics::{EstimatorName, RoundedDevice, SampledWall};

use super::quantity::{LoopQuantity, LoopValues};
use super::{axis::LoopPoint, poles::spectral_radius};

/// Margin of a boundary: above zero inside, below zero outside.
pub(super) type TheoryMargin = fn(&LoopValues) -> f64;

/// A theory of where a wall is stable.
#[derive(Clone, Copy, Debug)]
pub struct StabilityTheory {
    pub name: &'static str,
    pub title: &'static str,
    margin: TheoryMargin,
    /// Quantity that must be above zero for the theory to differ from others.
    pub(super) needs: Option<LoopQuantity>,
}

/// `[CS97]`, with delay `[HA14]`.
const PASSIVE: StabilityTheory = StabilityTheory {
    name: "colgate_schenkel",
    title: "passive: b > K (T/2 + d) + |B| [CS97]",
    margin: |values| values.get(LoopQuantity::DeviceDamping) - wall(values).passive_damping(),
    needs: None,
};

/// `[AO05]`, for a wall without damping.
const ROUNDED: StabilityTheory = StabilityTheory {
    name: "abbott_okamura",
    title: "K < min(2 b/T, 2 f/Δ) [AO05]",
    margin: |values| {
        let device = RoundedDevice {
            damping: values.get(LoopQuantity::DeviceDamping),
            coulomb: values.get(LoopQuantity::Friction),
            quantum: values.get(LoopQuantity::EncoderStep),
        };
        let most = device.passive_stiffness(values.get(LoopQuantity::Period));
        most - values.get(LoopQuantity::Stiffness)
    },
    needs: Some(LoopQuantity::EncoderStep),
};

/// `[GS09]`, for heavy keys.
const LINEAR: StabilityTheory = StabilityTheory {
    name: "gil",
    title: "K < (b + B) / (T/2 + d) [GS09]",
    margin: |values| {
        let damping = values.get(LoopQuantity::DeviceDamping);
        wall(values).linear_stiffness(damping) - values.get(LoopQuantity::Stiffness)
    },
    needs: None,
};

/// Exact poles of the loop's linear part, alone on its key.
const POLES: StabilityTheory = StabilityTheory {
    name: "poles",
    title: "poles of key and wall, exact",
    margin: |values| {
        let [mass, damping] =
            [LoopQuantity::Mass, LoopQuantity::DeviceDamping].map(|it| values.get(it));
        // A missing pole counts as unstable.
        1.0 - spectral_radius(&wall(values), mass, damping).unwrap_or(f64::INFINITY)
    },
    needs: None,
};

pub(super) fn theories(estimator: EstimatorName) -> Vec<StabilityTheory> {
    match estimator {
        EstimatorName::BackwardDifference => vec![PASSIVE, ROUNDED, LINEAR, POLES],
        EstimatorName::Kalman
        | EstimatorName::FilteredDifference
        | EstimatorName::AdaptiveWindow
        | EstimatorName::Levant => Vec::new(),
    }
}

impl StabilityTheory {
    /// Returns the margin at a point: above zero inside the boundary.
    pub fn margin(&self, point: &LoopPoint) -> f64 {
        (self.margin)(&point.values)
    }
}

fn wall(values: &LoopValues) -> SampledWall {
    SampledWall {
        stiffness: values.get(LoopQuantity::Stiffness),
        damping: values.get(LoopQuantity::Damping),
        period: values.get(LoopQuantity::Period),
        delay: values.get(LoopQuantity::Delay),
    }
}
