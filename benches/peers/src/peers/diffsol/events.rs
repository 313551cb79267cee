//! Steps until a root function changes its sign, resets the state there, and continues.

use std::cell::Cell;

use diffsol::{
    NalgebraContext, NalgebraVec, OdeEquations, OdeSolverMethod, OdeSolverStopReason, Vector,
};

use crate::log::Log;
use crate::problem::Problem;

type V = NalgebraVec<f64>;

pub(super) fn drive<'a, const N: usize, const G: usize, P, E, S>(
    mut solver: S,
    (problem, t_end, mode): (&P, f64, &Cell<P::Mode>),
    log: &mut Log,
) -> Result<(), String>
where
    P: Problem<N, G>,
    E: OdeEquations<T = f64, V = V, C = NalgebraContext> + 'a,
    S: OdeSolverMethod<'a, E>,
{
    solver.set_stop_time(t_end).map_err(|error| error.to_string())?;
    let mut y = V::zeros(N, *solver.problem().context());
    loop {
        let reason = solver.step().map_err(|error| error.to_string())?;
        let root = match reason {
            OdeSolverStopReason::RootFound(t, guard) => Some((t, guard)),
            OdeSolverStopReason::InternalTimestep | OdeSolverStopReason::TstopReached => None,
        };
        let until = root.map_or(solver.state().t, |(t, _)| t);
        log.sample(until, |t| {
            let read = solver.interpolate_inplace(t, &mut y);
            if read.is_ok() { array(&y) } else { [f64::NAN; N] }
        });
        if let Some((t, guard)) = root {
            solver.interpolate_inplace(t, &mut y).map_err(|error| error.to_string())?;
            let mut x: [f64; N] = array(&y);
            // The crate reports both directions, also that in which a mode just begins.
            if problem.guard_rates(mode.get(), &x)[guard] <= 0.0 {
                log.event(t, P::names(mode.get())[guard])?;
                let (next, after) = problem.fire(mode.get(), guard, &x);
                mode.set(next);
                x = problem.nudged(after);
            }
            let rates = problem.derivative(mode.get(), t, &x);
            let state = solver.state_mut();
            for i in 0..N {
                state.y[i] = x[i];
                state.dy[i] = rates[i];
            }
            *state.t = t;
        } else if reason == OdeSolverStopReason::TstopReached {
            return Ok(());
        }
    }
}

fn array<const N: usize>(y: &V) -> [f64; N] {
    std::array::from_fn(|i| y[i])
}
