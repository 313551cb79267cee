//! Events around a solver that has none: integrate until a guard has fallen, repeat the last
//! step to locate the event, and restart.

use std::cell::Cell;

use ode_solvers::SVector;
use ode_solvers::dop_shared::{IntegrationError, SolverResult, Stats};

use super::flight::{Flight, state, vector};
use crate::log::Log;
use crate::peers::handwritten::falling;
use crate::problem::Problem;

pub(super) trait Solver {
    fn integrate<const N: usize, const G: usize, const M: usize, P: Problem<N, G>>(
        flight: Flight<'_, N, G, M, P>,
        from: (f64, SVector<f64, M>),
        until: f64,
        first: f64,
        tolerance: f64,
    ) -> (Result<Stats, IntegrationError>, SolverResult<f64, SVector<f64, M>>);

    fn over_step<const N: usize, const G: usize, const M: usize, P: Problem<N, G>>(
        flight: Flight<'_, N, G, M, P>,
        from: (f64, SVector<f64, M>),
        until: f64,
        tolerance: f64,
    ) -> impl Fn(f64) -> [f64; N];
}

pub(super) fn run<const N: usize, const G: usize, const M: usize, P: Problem<N, G>, S: Solver>(
    problem: &P,
    t_end: f64,
    tolerance: f64,
    log: &mut Log,
) -> Result<(), String> {
    let (mut mode, mut x) = problem.start();
    let (mut time, mut h) = (0.0, 0.0);
    let count = Cell::new(0);
    while time < t_end {
        let flight = Flight::<N, G, M, P>::new(*problem, mode, &x, &count);
        let (ended, output) = S::integrate(flight, (time, vector(time, &x)), t_end, h, tolerance);
        ended.map_err(|error| error.to_string())?;
        let (times, states) = output.get();
        let last = times.len() - 1;
        let mut watching = flight;
        for end in &states[..last] {
            let _ = watching.fallen(&state(end));
        }
        let step = |i: usize| S::over_step(flight, (times[i], states[i]), times[i + 1], tolerance);
        let mut fallen = watching;
        let is_fallen = fallen.fallen(&state(&states[last]));
        for i in 0..last - usize::from(is_fallen.contains(&true)) {
            sample(log, times[i + 1], || step(i));
        }
        if !is_fallen.contains(&true) {
            break;
        }
        let (from, until) = (times[last - 1], times[last]);
        let at = step(last - 1);
        let ends = (problem.guards(mode, &state(&states[last - 1])), state(&states[last]));
        let (theta, guard) =
            earliest(problem, mode, &at, (from, until), (&ends.0, &ends.1), is_fallen);
        h = until - from;
        time = from + theta * h;
        log.sample(time, &at);
        log.event(time, P::names(mode)[guard])?;
        (mode, x) = problem.fire(mode, guard, &at(time));
    }
    log.count(count.get());
    Ok(())
}

fn sample<const N: usize, F: Fn(f64) -> [f64; N]>(log: &mut Log, t: f64, step: impl Fn() -> F) {
    let mut at = None;
    log.sample(t, |time| at.get_or_insert_with(&step)(time));
}

fn earliest<const N: usize, const G: usize, P: Problem<N, G>>(
    problem: &P,
    mode: P::Mode,
    at: &impl Fn(f64) -> [f64; N],
    (from, until): (f64, f64),
    (start, end): (&[f64; G], &[f64; N]),
    fallen: [bool; G],
) -> (f64, usize) {
    let end = problem.guards(mode, end);
    let mut first = (1.0, 0);
    for i in (0..G).filter(|i| fallen[*i]) {
        let theta = falling((start[i], end[i]), |theta| {
            let x = at(from + theta * (until - from));
            let rate = problem.guard_rates(mode, &x)[i];
            (problem.guards(mode, &x)[i], (until - from) * rate)
        });
        if theta <= first.0 {
            first = (theta, i);
        }
    }
    first
}
