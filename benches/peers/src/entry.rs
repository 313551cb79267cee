//! One way of running one code on one problem: what becomes a row of the results.

use std::fmt;

use crate::log::Log;

/// How a code was set.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Setting {
    /// As it comes, with nothing chosen but the problem.
    Default,
    /// As its documentation advises, over a sweep of tolerances or steps; with the name of
    /// the advice where a code has several.
    Best(&'static str),
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Default => f.write_str("default"),
            Self::Best(advice) => f.write_str(advice),
        }
    }
}

/// Runs the code once from the start to the end of the problem.
pub(crate) type Run = Box<dyn Fn(&mut Log) -> Result<(), String>>;

/// One way of running one code.
pub(crate) struct Entry {
    /// The code, as in [`crate::versions`].
    pub(crate) code: &'static str,
    pub(crate) method: &'static str,
    /// How it was set.
    pub(crate) setting: Setting,
    /// Relative and absolute tolerance, or step (s).
    pub(crate) knob: f64,
    /// What a reader must know about this row.
    pub(crate) note: &'static str,
    pub(crate) run: Run,
}

/// Tolerances of a sweep: half decades from 1e-4 to `10^-last`.
pub(crate) fn tolerances(last: i32) -> impl Iterator<Item = f64> {
    (8..=2 * last).map(|half| 10_f64.powf(-0.5 * f64::from(half)))
}

/// Fixed steps of a sweep (s): 4 ms to 25 µs, the next about 0.6 of the one before.
pub(crate) const STEPS: [f64; 12] =
    [4e-3, 2.5e-3, 2e-3, 1e-3, 6e-4, 4e-4, 2.5e-4, 1.5e-4, 1e-4, 6e-5, 4e-5, 2.5e-5];
