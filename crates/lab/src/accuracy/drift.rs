//! Error of the energy over a long run without loss, against time.

use pode::stepper::Any;
use pode::{Advance, Energetic as _};
use serde::{Deserialize, Serialize};

use super::job::RunJob;
use super::method::{self, NamedMethod};
use super::stepped::Stepped;
use crate::scenario::{Scenario, ScenarioVisitor};

/// Largest error of the energy of a long run until each of several times.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct EnergyDrift {
    /// Number of the run in its study.
    pub number: usize,
    #[serde(deserialize_with = "method::by_name")]
    pub method: &'static NamedMethod,
    /// Times (s), and errors over the energy at the start.
    pub points: Vec<(f64, f64)>,
}

/// A long run with a method until `until` (s), on the scenario that it visits.
pub(super) struct DriftRun {
    pub(super) method: &'static NamedMethod,
    pub(super) until: f64,
}

impl ScenarioVisitor for DriftRun {
    type Output = Vec<(f64, f64)>;

    fn visit<S: Scenario + 'static>(self, scenario: S) -> Vec<(f64, f64)> {
        /// Error that ends a run: the motion has lost its size.
        const LOST: f64 = 1e3;
        /// Ratio of the times of two points.
        const RATIO: f64 = 1.2;
        let Self { method, until } = self;
        let setting = method.long_run();
        let (stepper, limits) = (method.stepper(&setting), method.limits());
        let (scenario, stepping, tick) = (&scenario, method.stepping(), setting.tick);
        let job = RunJob { scenario, stepper, limits, stepping, tick };
        let mut simulator = job.simulator();
        let (mut points, mut error, mut next, mut t) = (Vec::new(), 0.0_f64, 0.0, 0.0);
        let energy = |it: &pode::Simulator<Stepped<S::Model>, Any>, t: f64| {
            it.model().energy(it.mode(), it.state(), &scenario.input(t))
        };
        let start = energy(&simulator, t);
        while t < until && error < LOST {
            if job.advance_alone(&mut simulator).advance != Advance::Completed {
                break;
            }
            t = simulator.tick() as f64 * job.tick;
            error = error.max((energy(&simulator, t) / start - 1.0).abs());
            if t >= next {
                points.push((t, error));
                next = RATIO * t;
            }
        }
        points
    }
}
