//! Dopri5: sparse steps, and the crate's continuous output for the step with the event.

use std::cell::Cell;

use ode_solvers::continuous_output_model::ContinuousOutputModel;
use ode_solvers::dop_shared::{IntegrationError, OutputType, SolverResult, Stats};
use ode_solvers::{Dopri5, SVector};

use super::events::Solver;
use super::flight::{Flight, state, vector};
use crate::log::Log;
use crate::problem::Problem;

pub(super) struct LastStep;

fn stepper<const N: usize, const G: usize, const M: usize, P: Problem<N, G>>(
    flight: Flight<'_, N, G, M, P>,
    (from, start): (f64, SVector<f64, M>),
    until: f64,
    first: f64,
    tolerance: f64,
) -> Dopri5<f64, SVector<f64, M>, Flight<'_, N, G, M, P>> {
    let longest = flight.problem.longest_step().min(until - from);
    let (h, output) = (first.min(longest), OutputType::Sparse);
    Dopri5::from_param(
        flight, from, until, 0.0, start, tolerance, tolerance, 0.9, 0.04, 0.2, 10.0, longest, h,
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
        until: f64,
        tolerance: f64,
    ) -> impl Fn(f64) -> [f64; N] {
        let mut stepper = stepper(flight, from, until, until - from.0, tolerance);
        let mut output = ContinuousOutputModel::new();
        // The same step from the same state succeeded before.
        let _ = stepper.integrate_with_continuous_output_model(&mut output);
        move |t| output.evaluate(t.min(until)).map_or([f64::NAN; N], |y| state(&y))
    }
}

/// Runs as the crate's example: the first dense point beyond a guard is the event.
pub(super) fn on_a_grid<const N: usize, const G: usize, P: Problem<N, G>>(
    problem: &P,
    t_end: f64,
    log: &mut Log,
) -> Result<(), String> {
    const GRID: f64 = 0.01;
    let (mut mode, mut x) = problem.start();
    let mut time = 0.0;
    let count = Cell::new(0);
    while time < t_end {
        let flight = Flight::<N, G, N, P>::new(*problem, mode, &x, &count);
        let start = vector(time, &x);
        let mut stepper = Dopri5::new(flight, time, t_end, GRID, start, 1e-2, 1e-6);
        stepper.integrate().map_err(|error| error.to_string())?;
        let mut watching = flight;
        let mut points = stepper.x_out().iter().zip(stepper.y_out());
        let event = points.find_map(|(t, y)| {
            let fallen = watching.fallen(&state(y));
            let guard = fallen.iter().position(|is| *is)?;
            Some((*t, guard, state(y)))
        });
        let Some((t, guard, at)) = event else { break };
        time = t;
        log.event(t, P::names(mode)[guard])?;
        (mode, x) = problem.fire(mode, guard, &at);
    }
    log.count(count.get());
    Ok(())
}
