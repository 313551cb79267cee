//! The crate `differential-equations`: DOP853 and Dopri5 with events.
//!
//! - default: tolerances 1e-6 both, its own terminal falling events (`IVP::event`), and a new
//!   `solve` after each; swept as well;
//! - best: its own `Solout` (its example 10_custom_solout) with a root search on the method's
//!   interpolant, and `ControlFlag::ModifyState` at the event: one `solve` for the whole run,
//!   without the crate's Brent–Dekker, which loses its bracket (`probes`).

mod events;
mod flight;
mod solout;

use std::hint::black_box;

use differential_equations::ode::OrdinaryNumericalMethod;
use differential_equations::prelude::{ExplicitRungeKutta, Interpolation};

use crate::entry::{Entry, Setting, tolerances};
use crate::log::Log;
use crate::problem::Problem;

const CODE: &str = "differential-equations";

#[derive(Clone, Copy)]
enum Method {
    Dop853,
    Dopri5,
}

#[derive(Clone, Copy)]
enum Events {
    Its,
    /// By the crate; after a reset the state is put clearly above the floor.
    Nudged,
    /// By our root search, in a `Solout`.
    Ours,
}

pub(crate) fn entries<const N: usize, const G: usize, P: Problem<N, G>>(
    problem: P,
    t_end: f64,
) -> Vec<Entry> {
    let ways = [
        (Method::Dop853, Events::Ours, "own Solout"),
        (Method::Dopri5, Events::Ours, "own Solout"),
        (Method::Dop853, Events::Nudged, "its events"),
        (Method::Dopri5, Events::Nudged, "its events"),
    ];
    let default = entry(problem, t_end, Method::Dop853, Events::Its, Setting::Default, 1e-6);
    let sweep = ways.into_iter().flat_map(|(method, events, advice)| {
        tolerances(13).map(move |tolerance| {
            entry(problem, t_end, method, events, Setting::Best(advice), tolerance)
        })
    });
    std::iter::once(default).chain(sweep).collect()
}

fn entry<const N: usize, const G: usize, P: Problem<N, G>>(
    problem: P,
    t_end: f64,
    method: Method,
    events: Events,
    setting: Setting,
    tolerance: f64,
) -> Entry {
    let name = match method {
        Method::Dop853 => "DOP853",
        Method::Dopri5 => "Dopri5",
    };
    let is_default = setting == Setting::Default;
    let note = match events {
        Events::Its => "its Event, terminal, falling",
        Events::Nudged => "its Event, terminal, falling; the state nudged above the floor",
        Events::Ours => "hand-made root search in a Solout",
    };
    let longest = if is_default { f64::INFINITY } else { problem.longest_step() };
    // A first step of 0 lets the crate choose.
    let first = if matches!(events, Events::Ours) { solout::FIRST } else { 0.0 };
    let run = move |log: &mut Log| {
        let (problem, t_end) = (black_box(problem), black_box(t_end));
        match method {
            Method::Dop853 => {
                let it = || ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance);
                go(&problem, t_end, || it().h_max(longest).h0(first), events, log)
            }
            Method::Dopri5 => {
                let it = || ExplicitRungeKutta::dopri5().rtol(tolerance).atol(tolerance);
                go(&problem, t_end, || it().h_max(longest).h0(first), events, log)
            }
        }
    };
    Entry { code: CODE, method: name, setting, knob: tolerance, note, run: Box::new(run) }
}

fn go<const N: usize, const G: usize, P: Problem<N, G>, S>(
    problem: &P,
    t_end: f64,
    method: impl Fn() -> S,
    events: Events,
    log: &mut Log,
) -> Result<(), String>
where
    S: OrdinaryNumericalMethod<f64, [f64; N]> + Interpolation<f64, [f64; N]>,
{
    match events {
        Events::Its => events::run(problem, t_end, method, |x| x, log),
        Events::Nudged => events::run(problem, t_end, method, |x| problem.nudged(x), log),
        Events::Ours => solout::run(problem, t_end, method(), log),
    }
}
