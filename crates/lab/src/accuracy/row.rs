use pode::{State as _, Work};
use serde::{Deserialize, Serialize};

use super::judge::RunVerdict;
use super::method::{self, NamedMethod, Setting};
use crate::scenario::{Scenario, StateOf};

/// A judged, counted and timed run.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct StudyRow {
    /// Number of the run in its study.
    pub number: usize,
    pub scenario: String,
    #[serde(deserialize_with = "method::by_name")]
    pub method: &'static NamedMethod,
    pub setting: Setting,
    pub verdict: RunVerdict,
    pub counts: EvaluationCounts,
    pub times: Times,
    /// Energy that the method generated (J); `None` where it is not finite.
    pub energy_residual: Option<f64>,
}

/// Evaluations of a run, as `pode` counts them.
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct EvaluationCounts {
    pub derivatives_per_ms: f64,
    pub jacobians_per_ms: f64,
    /// Evaluations of single guards per simulated ms.
    pub guards_per_ms: f64,
    pub readouts_per_ms: f64,
    pub worst_derivatives: u32,
    pub worst_jacobians: u32,
    pub worst_guards: u32,
    /// Steps in the whole run that certainly missed no root of a guard on the computed orbit.
    pub steps_certain: u64,
    pub steps_unknown: u64,
    /// Derivatives per simulated ms, where a Jacobian counts as one per entry of the state.
    pub evaluations_per_ms: f64,
}

impl EvaluationCounts {
    /// Returns the counts of ticks of `tick` (s).
    pub(super) fn new<S: Scenario>(work: &[Work], tick: f64) -> Self {
        let ms = work.len() as f64 * tick * 1e3;
        let sum = |count: fn(&Work) -> u32| -> u64 {
            work.iter().map(|work| u64::from(count(work))).sum()
        };
        let per_ms = |count| if ms > 0.0 { sum(count) as f64 / ms } else { 0.0 };
        let worst = |count: fn(&Work) -> u32| work.iter().map(count).max().unwrap_or(0);
        let (derivatives, jacobians) =
            (per_ms(|work| work.derivatives), per_ms(|work| work.jacobians));
        let entries = StateOf::<S>::ZERO.entries().len() as f64;
        Self {
            derivatives_per_ms: derivatives,
            jacobians_per_ms: jacobians,
            guards_per_ms: per_ms(|work| work.guards),
            readouts_per_ms: per_ms(|work| work.readouts),
            worst_derivatives: worst(|work| work.derivatives),
            worst_jacobians: worst(|work| work.jacobians),
            worst_guards: worst(|work| work.guards),
            steps_certain: sum(|work| work.certain),
            steps_unknown: sum(|work| work.unknown),
            evaluations_per_ms: derivatives + entries * jacobians,
        }
    }
}

/// Times of a run on one machine (ns).
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct Times {
    /// Time per simulated ms (ns).
    pub per_ms: f64,
    /// Time of the slowest tick (ns).
    pub worst_tick: f64,
    /// Mean time of a tick without events (ns).
    pub without_event: Option<f64>,
    /// Mean time of a tick with one event (ns).
    pub with_one_event: Option<f64>,
    /// Mean time of the ticks with the most events (ns).
    pub with_most_events: Option<f64>,
    /// Number of events in the ticks with the most.
    pub most_events: u32,
}
