//! The crate's own events: terminal and falling, one `solve` between two events.

use std::cell::{Cell, RefCell};

use differential_equations::ode::OrdinaryNumericalMethod;
use differential_equations::prelude::{
    ControlFlag, CrossingDirection, Event, EventConfig, IVP, Interpolation, Solout, Solution,
};
use differential_equations::status::Status;

use super::flight::Flight;
use crate::log::Log;
use crate::problem::Problem;

/// Guard `index` of the problem; it never fires if the problem has fewer guards.
struct Guard<'a, const N: usize, const G: usize, P: Problem<N, G>> {
    flight: &'a Flight<'a, N, G, P>,
    index: usize,
}

impl<const N: usize, const G: usize, P: Problem<N, G>> Event<f64, [f64; N]> for Guard<'_, N, G, P> {
    fn config(&self) -> EventConfig {
        EventConfig::new(CrossingDirection::Negative, Some(1))
    }

    fn event(&self, _t: f64, x: &[f64; N]) -> f64 {
        let guards = self.flight.problem.guards(self.flight.mode.get(), x);
        guards.get(self.index).copied().unwrap_or(1.0)
    }
}

struct Sampler<'a>(&'a RefCell<&'a mut Log>);

impl<const N: usize> Solout<f64, [f64; N]> for Sampler<'_> {
    fn solout<I: Interpolation<f64, [f64; N]> + ?Sized>(
        &mut self,
        t: f64,
        _: f64,
        _: &[f64; N],
        _: &[f64; N],
        interpolant: &mut I,
        _: &mut Solution<f64, [f64; N]>,
    ) -> ControlFlag<f64, [f64; N]> {
        let at = |t| interpolant.interpolate(t).unwrap_or([f64::NAN; N]);
        self.0.borrow_mut().sample(t, at);
        ControlFlag::Continue
    }
}

pub(super) fn run<const N: usize, const G: usize, P: Problem<N, G>, S>(
    problem: &P,
    t_end: f64,
    method: impl Fn() -> S,
    after: impl Fn([f64; N]) -> [f64; N],
    log: &mut Log,
) -> Result<(), String>
where
    S: OrdinaryNumericalMethod<f64, [f64; N]> + Interpolation<f64, [f64; N]>,
{
    let (mode, mut x) = problem.start();
    let mode = Cell::new(mode);
    let flight = Flight { problem, mode: &mode };
    let guards = [0, 1].map(|index| Guard { flight: &flight, index });
    let log = RefCell::new(log);
    let mut time = 0.0;
    while time < t_end {
        let ivp = IVP::ode(&flight, time, t_end, x).method(method()).solout(Sampler(&log));
        let solved = ivp.event(&guards[0]).event(&guards[1]).solve();
        let solution = solved.map_err(|error| format!("{error:?}"))?;
        let mut log = log.borrow_mut();
        log.count(solution.evals.function as u64);
        let event = solution.t.last().zip(solution.y.last());
        let (Status::Interrupted, Some((t, at))) = (&solution.status, event) else {
            return Ok(());
        };
        log.forget_after(*t);
        let guard = nearest(&problem.guards(mode.get(), at));
        log.event(*t, P::names(mode.get())[guard])?;
        let (next, reset) = problem.fire(mode.get(), guard, at);
        mode.set(next);
        (time, x) = (*t, after(reset));
    }
    Ok(())
}

/// Returns the guard nearest to zero: the crate does not report which event fired.
fn nearest(guards: &[f64]) -> usize {
    let size = |index: &usize| guards[*index].abs();
    (0..guards.len()).min_by(|a, b| size(a).total_cmp(&size(b))).unwrap_or(0)
}
