//! One code with one method and setting on one problem: a row of the results.

use std::fmt;

use crate::log::Log;

/// Origin of a code's settings.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Setting {
    Default,
    /// The documentation's advice, over a sweep of tolerances or steps; named where a code has
    /// several.
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

pub(crate) struct Entry {
    pub(crate) code: &'static str,
    pub(crate) method: &'static str,
    pub(crate) setting: Setting,
    /// Relative and absolute tolerance, or step (s).
    pub(crate) knob: f64,
    pub(crate) note: &'static str,
    pub(crate) run: Run,
}

impl Entry {
    /// Counts the evaluations of a run without samples, whose dense output may cost some.
    pub(crate) fn evaluations(&self) -> Option<u64> {
        let mut log = Log::new(&[]);
        (self.run)(&mut log).ok().and(log.evaluations)
    }
}

/// Returns the tolerances of a sweep: half decades from 1e-4 to `10^-last`.
pub(crate) fn tolerances(last: i32) -> impl Iterator<Item = f64> {
    (8..=2 * last).map(|half| 10_f64.powf(-0.5 * f64::from(half)))
}

/// Fixed steps of a sweep (s): 4 ms to 25 µs, each about 0.6 of the one before.
pub(crate) const STEPS: [f64; 12] =
    [4e-3, 2.5e-3, 2e-3, 1e-3, 6e-4, 4e-4, 2.5e-4, 1.5e-4, 1e-4, 6e-5, 4e-5, 2.5e-5];
