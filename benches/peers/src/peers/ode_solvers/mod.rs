//! The crate `ode_solvers`: Dopri5 and Dop853, without events.
//!
//! Its documentation stops at an event through `System::solout`, which sees the ends of steps
//! (or the points of a dense grid), and leaves the rest to the user. Here:
//! - default: as in its example `bouncing_ball`: tolerances 1e-2 and 1e-6, dense output every
//!   10 ms, the first point beyond the guard is the event;
//! - best: sparse output; the step in which a guard changes its sign is repeated to locate the
//!   event (Dopri5: on the crate's continuous output; Dop853 offers none: by Newton on the
//!   length of the step);
//! - Dop853 evaluates its last stage at the wrong time, see `probes`: a second sweep carries
//!   the time as an additional state, which hides that.

mod dop853;
mod dopri5;
mod events;
mod flight;

use std::hint::black_box;

use events::Solver;

use crate::entry::{Entry, Run, Setting, tolerances};
use crate::problem::Problem;

const CODE: &str = "ode_solvers";

/// Lists all rows; `M` is N + 1.
pub(crate) fn entries<const N: usize, const G: usize, const M: usize, P: Problem<N, G>>(
    problem: P,
    t_end: f64,
) -> Vec<Entry> {
    let mut all = vec![default(problem, t_end)];
    for tolerance in tolerances(13) {
        let entry = |method, advice, note, run| Entry {
            code: CODE,
            method,
            setting: Setting::Best(advice),
            knob: tolerance,
            note,
            run,
        };
        all.push(entry(
            "Dopri5",
            "sweep",
            "hand-made root search on its continuous output",
            searched::<N, G, N, P, dopri5::LastStep>(problem, t_end, tolerance),
        ));
        all.push(entry(
            "Dop853",
            "sweep",
            "hand-made root search by steps of its own",
            searched::<N, G, N, P, dop853::LastStep>(problem, t_end, tolerance),
        ));
        all.push(entry(
            "Dop853",
            "time as a state",
            "avoids its wrong node",
            searched::<N, G, M, P, dop853::LastStep>(problem, t_end, tolerance),
        ));
    }
    all
}

fn searched<
    const N: usize,
    const G: usize,
    const M: usize,
    P: Problem<N, G>,
    S: Solver + 'static,
>(
    problem: P,
    t_end: f64,
    tolerance: f64,
) -> Run {
    Box::new(move |log| {
        events::run::<N, G, M, P, S>(&black_box(problem), black_box(t_end), tolerance, log)
    })
}

fn default<const N: usize, const G: usize, P: Problem<N, G>>(problem: P, t_end: f64) -> Entry {
    Entry {
        code: CODE,
        method: "Dopri5",
        setting: Setting::Default,
        knob: 1e-2,
        note: "as in its example bouncing_ball: events on a dense grid of 10 ms; the absolute \
               tolerance is 1e-6",
        run: Box::new(move |log| dopri5::on_a_grid(&black_box(problem), black_box(t_end), log)),
    }
}
