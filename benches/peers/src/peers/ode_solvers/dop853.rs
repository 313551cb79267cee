//! Dop853: it has no continuous output, so a point inside a step is the end of a shorter step.

use ode_solvers::dop_shared::{IntegrationError, OutputType, SolverResult, Stats};
use ode_solvers::{Dop853, SVector};

use super::events::Solver;
use super::flight::{Flight, state};
use crate::problem::Problem;

pub(super) struct LastStep;

fn stepper<const N: usize, const G: usize, const M: usize, P: Problem<N, G>>(
    flight: Flight<'_, N, G, M, P>,
    (from, start): (f64, SVector<f64, M>),
    until: f64,
    first: f64,
    tolerance: f64,
) -> Dop853<f64, SVector<f64, M>, Flight<'_, N, G, M, P>> {
    let longest = flight.problem.longest_step().min(until - from);
    let (h, output) = (first.min(longest), OutputType::Sparse);
    Dop853::from_param(
        flight, from, until, 0.0, start, tolerance, tolerance, 0.9, 0.0, 0.333, 6.0, longest, h,
        100_000, 1000, output,
    )
}

impl Solver for LastStep {
    fn integrate<const N: usize, const G: usize, const M: usize, P: Problem<N, G>>(
        flight: Flight<'_, N, G, M, P>,
        from: (f64, SVector<f64, M>),
        until: f64,
        first: f64,
        tolerance: f64,
    ) -> (Result<Stats, IntegrationError>, SolverResult<f64, SVector<f64, M>>) {
        let mut stepper = stepper(flight, from, until, first, tolerance);
        (stepper.integrate(), stepper.into())
    }

    fn over_step<const N: usize, const G: usize, const M: usize, P: Problem<N, G>>(
        flight: Flight<'_, N, G, M, P>,
        from: (f64, SVector<f64, M>),
        _until: f64,
        tolerance: f64,
    ) -> impl Fn(f64) -> [f64; N] {
        // Watch no guard: the step must not stop at the guard that the search locates.
        let flight = Flight { watched: [false; G], ..flight };
        move |t| {
            if t <= from.0 {
                return state(&from.1);
            }
            let mut stepper = stepper(flight, from, t, t - from.0, tolerance);
            let _ = stepper.integrate();
            stepper.y_out().last().map_or([f64::NAN; N], state)
        }
    }
}
