//! Programs written for one problem alone, as accurate as the libraries: the speed that a
//! library must reach.

mod dop853;
mod rk4;
mod root;
mod stages;
// The numbers of Hairer's program, once: those of pode's own method.
#[path = "../../../../../crates/pode/src/stepper/dop853/tableau.rs"]
mod tableau;

pub(crate) use root::falling;

use std::hint::black_box;

use crate::entry::{Entry, STEPS, Setting, tolerances};
use crate::problem::Problem;

const CODE: &str = "handwritten";

pub(crate) fn entries<const N: usize, const G: usize, P: Problem<N, G>>(
    problem: P,
    t_end: f64,
) -> Vec<Entry> {
    let adaptive = tolerances(13).map(|tolerance| Entry {
        code: CODE,
        method: "DOP853",
        setting: Setting::Best("sweep"),
        knob: tolerance,
        note: "dense output computed only in steps with an event; longest step one width of a bell",
        run: Box::new(move |log| {
            dop853::run(black_box(&problem), black_box(t_end), tolerance, log)
        }),
    });
    let fixed = STEPS.into_iter().map(|h| Entry {
        code: CODE,
        method: "RK4",
        setting: Setting::Best("sweep"),
        knob: h,
        note: "events by Newton on the length of the step",
        run: Box::new(move |log| rk4::run(black_box(&problem), black_box(t_end), h, log)),
    });
    adaptive.chain(fixed).collect()
}
