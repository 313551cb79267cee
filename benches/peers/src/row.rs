//! A row of the results: one code, one method, one setting, one problem.

use serde::Serialize;

use crate::entry::Entry;
use crate::judge::Verdict;
use crate::measure::median_and_minimum;
use crate::versions::version;

#[derive(Clone, Debug, Serialize)]
pub(crate) struct Row {
    pub(crate) problem: String,
    pub(crate) code: String,
    pub(crate) version: String,
    pub(crate) method: String,
    /// "default", "sweep", or a name for the advice.
    pub(crate) setting: String,
    /// Relative and absolute tolerance, or step (s).
    pub(crate) tolerance_or_step: f64,
    pub(crate) events: usize,
    /// `true` if all events happened in their order; `false` for a code without events.
    pub(crate) sequence_ok: bool,
    pub(crate) event_error_s: Option<f64>,
    pub(crate) state_error: Option<f64>,
    pub(crate) rhs: Option<u64>,
    /// Minimum time of all repeats (ns per simulated ms).
    pub(crate) ns_per_ms_min: Option<f64>,
    pub(crate) ns_per_ms_median: Option<f64>,
    pub(crate) note: String,
    pub(crate) failure: Option<String>,
    /// Times of single runs (ns).
    #[serde(skip)]
    pub(crate) times: Vec<f64>,
}

impl Row {
    pub(crate) fn new(problem: &str, entry: &Entry, verdict: Verdict, rhs: Option<u64>) -> Self {
        Self {
            problem: problem.to_owned(),
            code: entry.code.to_owned(),
            version: version(entry.code),
            method: entry.method.to_owned(),
            setting: entry.setting.to_string(),
            tolerance_or_step: entry.knob,
            events: 0,
            sequence_ok: false,
            event_error_s: None,
            state_error: None,
            rhs,
            ns_per_ms_min: None,
            ns_per_ms_median: None,
            note: entry.note.to_owned(),
            failure: None,
            times: Vec::new(),
        }
        .judged(verdict)
    }

    pub(crate) fn judged(self, verdict: Verdict) -> Self {
        Self {
            events: verdict.events,
            sequence_ok: verdict.has_events && verdict.failure.is_none(),
            event_error_s: verdict.event_error,
            state_error: verdict.state_error,
            failure: verdict.failure,
            ..self
        }
    }

    pub(crate) fn sum_up(&mut self, t_end: f64) {
        let per_ms = 1.0 / (t_end * 1e3);
        let found = median_and_minimum(&self.times).filter(|_| self.failure.is_none());
        self.ns_per_ms_median = found.map(|(median, _)| rounded(median * per_ms));
        self.ns_per_ms_min = found.map(|(_, minimum)| rounded(minimum * per_ms));
        self.event_error_s = self.event_error_s.map(rounded);
        self.state_error = self.state_error.map(rounded);
    }

    pub(crate) fn is_same(&self, other: &Self) -> bool {
        self.problem == other.problem
            && self.code == other.code
            && self.method == other.method
            && self.setting == other.setting
            && self.tolerance_or_step.to_bits() == other.tolerance_or_step.to_bits()
    }
}

/// Rounds to four digits: more would be noise in the committed file.
fn rounded(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}
