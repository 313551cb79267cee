//! A `Solout` with our root search on the crate's interpolant, which changes mode and state.

use std::cell::Cell;

use differential_equations::ode::{OrdinaryNumericalMethod, solve_ode};
use differential_equations::prelude::{ControlFlag, Interpolation, Solout, Solution};

use super::flight::Flight;
use crate::log::Log;
use crate::peers::handwritten::falling;
use crate::problem::{Problem, armed};

/// First step (s), also after each event. The crate rejects one that is longer than the rest of
/// the run, so the run ends that much later.
pub(super) const FIRST: f64 = 0.01;

struct Watcher<'a, const N: usize, const G: usize, P: Problem<N, G>> {
    problem: &'a P,
    t_end: f64,
    mode: &'a Cell<P::Mode>,
    guards: [f64; G],
    watched: [bool; G],
    log: &'a mut Log,
    failed: Result<(), String>,
}

pub(super) fn run<const N: usize, const G: usize, P: Problem<N, G>, S>(
    problem: &P,
    t_end: f64,
    mut method: S,
    log: &mut Log,
) -> Result<(), String>
where
    S: OrdinaryNumericalMethod<f64, [f64; N]> + Interpolation<f64, [f64; N]>,
{
    let (mode, x) = problem.start();
    let mode = Cell::new(mode);
    let (guards, watched) = (problem.guards(mode.get(), &x), armed(problem, mode.get(), &x));
    let mut watcher = Watcher { problem, t_end, mode: &mode, guards, watched, log, failed: Ok(()) };
    let flight = Flight { problem, mode: &mode };
    let solved = solve_ode(&mut method, &flight, 0.0, t_end + FIRST, &x, &mut watcher);
    let solution = solved.map_err(|error| format!("{error:?}"))?;
    watcher.log.count(solution.evals.function as u64);
    watcher.failed
}

impl<const N: usize, const G: usize, P: Problem<N, G>> Watcher<'_, N, G, P> {
    fn earliest<I: Interpolation<f64, [f64; N]> + ?Sized>(
        &self,
        (from, to): (f64, f64),
        end: &[f64; G],
        interpolant: &mut I,
    ) -> Option<(f64, usize)> {
        let mut first: Option<(f64, usize)> = None;
        for i in (0..G).filter(|i| self.watched[*i] && end[*i] <= 0.0) {
            let theta = falling((self.guards[i], end[i]), |theta| {
                let x = state(interpolant, from + theta * (to - from));
                let rate = self.problem.guard_rates(self.mode.get(), &x)[i];
                (self.problem.guards(self.mode.get(), &x)[i], (to - from) * rate)
            });
            if first.is_none_or(|(earlier, _)| theta < earlier) {
                first = Some((theta, i));
            }
        }
        first.map(|(theta, guard)| (from + theta * (to - from), guard))
    }

    fn restart(&mut self, x: &[f64; N]) {
        self.guards = self.problem.guards(self.mode.get(), x);
        self.watched = armed(self.problem, self.mode.get(), x);
    }
}

impl<const N: usize, const G: usize, P: Problem<N, G>> Solout<f64, [f64; N]>
    for Watcher<'_, N, G, P>
{
    fn solout<I: Interpolation<f64, [f64; N]> + ?Sized>(
        &mut self,
        to: f64,
        from: f64,
        end: &[f64; N],
        _start: &[f64; N],
        interpolant: &mut I,
        _solution: &mut Solution<f64, [f64; N]>,
    ) -> ControlFlag<f64, [f64; N]> {
        let guards = self.problem.guards(self.mode.get(), end);
        let Some((t, guard)) = self.earliest((from, to), &guards, interpolant) else {
            self.log.sample(to, |t| state(interpolant, t));
            self.guards = guards;
            for (watched, guard) in self.watched.iter_mut().zip(guards) {
                *watched |= guard > 0.0;
            }
            return if to >= self.t_end { ControlFlag::Terminate } else { ControlFlag::Continue };
        };
        self.log.sample(t, |t| state(interpolant, t));
        if t > self.t_end {
            return ControlFlag::Terminate;
        }
        let x = state(interpolant, t);
        self.failed = self.log.event(t, P::names(self.mode.get())[guard]);
        if self.failed.is_err() {
            return ControlFlag::Terminate;
        }
        let (mode, x) = self.problem.fire(self.mode.get(), guard, &x);
        self.mode.set(mode);
        self.restart(&x);
        ControlFlag::ModifyState(t, x)
    }
}

/// Returns the interpolant's state, or one that fails every test.
fn state<const N: usize, I: Interpolation<f64, [f64; N]> + ?Sized>(
    interpolant: &mut I,
    t: f64,
) -> [f64; N] {
    interpolant.interpolate(t).unwrap_or([f64::NAN; N])
}
