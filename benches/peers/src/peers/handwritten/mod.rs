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

#[cfg(test)]
mod tests {
    /// FNV-1a of the sources. A change of the yardstick needs a refreshed report.
    const FROZEN: u64 = 0x3f92_8768_113f_8dd8;

    #[test]
    fn the_yardstick_is_the_one_of_the_committed_report() {
        let sources = [
            include_str!("dop853.rs"),
            include_str!("rk4.rs"),
            include_str!("root.rs"),
            include_str!("stages.rs"),
        ];
        let hash = sources.concat().bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        });
        assert_eq!(hash, FROZEN, "{hash:#x}");
    }
}
