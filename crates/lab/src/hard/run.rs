//! One run of a case, and its verdict.

use clap::Parser as _;
use cli::simulate::{
    CallerArgs, MOST_ENERGY_ERROR, SimulateArgs, SimulateError, Simulated, TimedEvent, simulate,
};
use pode::Stepper as _;
use pode::stepper::ByNeed;
use serde::Serialize;

use super::case::{CaseModel, ExpectedRun, HardCase, HardFailure};

/// Angle (rad) that the fastest motion of a run is taken to turn by, for a budget per radian.
const RADIANS: f64 = 10.0;

/// Verdict on a run, the best first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Default, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum HardVerdict {
    /// The events are right, and every error is within its tolerance.
    #[default]
    Right,
    /// The method rejects the case before it runs.
    Refused,
    /// An error that the run itself reports, or its end with a reason.
    Reported,
    /// The events are right, and an error is above its tolerance.
    Rough,
    /// The events are wrong, and the run does not report it.
    Wrong,
}

impl HardVerdict {
    pub const ALL: [Self; 5] =
        [Self::Right, Self::Refused, Self::Reported, Self::Rough, Self::Wrong];

    /// Returns `true` for an error that the run does not report.
    pub fn is_silent(self) -> bool {
        Self::Reported < self
    }

    pub const fn title(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Refused => "refused",
            Self::Reported => "reported",
            Self::Rough => "inaccurate",
            Self::Wrong => "wrong events",
        }
    }
}

/// A judged run.
#[derive(Clone, Debug, Default, Serialize)]
pub struct HardRun {
    pub method: &'static str,
    /// Length of a tick (s).
    pub step: f64,
    pub verdict: HardVerdict,
    /// Largest error of an event's time (s).
    pub event_error: Option<f64>,
    /// Largest error of a value at the end, over its size.
    pub value_error: Option<f64>,
    /// Error of the energy audit, as a share of the energy that moved.
    pub energy_error: Option<f64>,
    /// Evaluations of the derivative.
    pub derivatives: Option<u64>,
    /// Reported reason, or difference from the right outcome.
    pub remark: String,
}

impl HardRun {
    /// Returns the larger of the errors of times and values.
    pub fn error(&self) -> Option<f64> {
        self.event_error.into_iter().chain(self.value_error).reduce(f64::max)
    }
}

impl HardCase {
    pub(super) fn run(&self, model: &CaseModel, method: &'static str, step: f64) -> HardRun {
        let fails = self.expected.fails;
        let is_budgeted = method == ByNeed::NAME;
        let radians = if is_budgeted { self.expected.radians.unwrap_or(RADIANS) } else { 0.0 };
        let ended = |verdict, right: HardFailure, remark: String| {
            let verdict = if fails == Some(right) { HardVerdict::Right } else { verdict };
            HardRun { verdict, remark, ..HardRun::default() }
        };
        let done = match (model, self.args(method, step)) {
            (Err(mistakes), _) => ended(HardVerdict::Wrong, HardFailure::Mistake, mistakes.clone()),
            (Ok(_), Err(usage)) => {
                ended(HardVerdict::Refused, HardFailure::Mistake, usage.to_string())
            }
            (Ok(model), Ok(args)) => match simulate(model, &args) {
                Ok(simulated) => self.judge(radians, &simulated),
                Err(error @ SimulateError::Usage(_)) => {
                    ended(HardVerdict::Refused, HardFailure::Mistake, error.to_string())
                }
                Err(error) => ended(HardVerdict::Reported, HardFailure::Fault, error.to_string()),
            },
        };
        HardRun { method, step, ..done }
    }

    fn args(&self, method: &str, step: f64) -> Result<SimulateArgs, clap::Error> {
        let [until, step] = [self.until, step].map(|it| it.to_string());
        let words =
            ["simulate", &self.model, "--until", &until, "--step", &step, "--method", method];
        let words = words.into_iter().chain(self.arguments.iter().map(String::as_str));
        let caller = CallerArgs { first_tick: self.first_tick, ..CallerArgs::default() };
        Ok(SimulateArgs { caller, ..SimulateArgs::try_parse_from(words)? })
    }

    /// Judges a run of a method with a budget over so many radians (0 without one).
    fn judge(&self, radians: f64, simulated: &Simulated) -> HardRun {
        /// Number of events in a remark.
        const SHOWN: usize = 6;
        let (expected, report) = (&self.expected, &simulated.report);
        let is_sequence = expected.is_sequence(&simulated.events) && expected.fails.is_none();
        let event_error = expected.event_error(&simulated.events).filter(|_| is_sequence);
        let state = &report["final"]["state"];
        let value_error = expected.value_error(&|name| state[name].as_f64());
        let energy_error = report["energy_audit"]["error"].as_f64();
        let budget = radians * ByNeed::BUDGET;
        let value = expected.accuracy.unwrap_or(expected.tolerance);
        let limits = [
            (event_error, expected.tolerance.max(budget * self.until.min(1.0))),
            (value_error, value.max(budget)),
            (energy_error, expected.energy.map_or(f64::INFINITY, |most| most.max(budget))),
        ];
        let is_within = limits.iter().all(|(error, most)| error.is_none_or(|it| it <= *most));
        let is_reported = energy_error.is_some_and(|error| MOST_ENERGY_ERROR < error);
        let verdict = match (is_sequence, is_within, is_reported) {
            (true, true, _) => HardVerdict::Right,
            (_, _, true) => HardVerdict::Reported,
            (true, false, false) => HardVerdict::Rough,
            (false, _, false) => HardVerdict::Wrong,
        };
        let remark = if is_sequence {
            String::new()
        } else {
            format!("{:?}", simulated.events.iter().take(SHOWN).collect::<Vec<_>>())
        };
        let derivatives = report["counts"]["evaluations"]["derivatives"].as_u64();
        let errors = HardRun { event_error, value_error, energy_error, ..HardRun::default() };
        HardRun { verdict, derivatives, remark, ..errors }
    }
}

impl ExpectedRun {
    /// Pairs expected events with those at the same place of the sequence.
    fn pairs<'a>(
        &'a self,
        found: &'a [TimedEvent],
    ) -> impl Iterator<Item = (&'a (String, f64), &'a TimedEvent)> {
        let all = self.events.iter().flatten().chain(&self.begins).zip(found);
        all.chain(self.ends.iter().rev().zip(found.iter().rev()))
    }

    fn is_sequence(&self, found: &[TimedEvent]) -> bool {
        let expected = self.begins.len().max(self.ends.len()).max(self.least);
        let is_whole = self.events.as_ref().is_none_or(|all| all.len() == found.len());
        let is_counted = self.counts.iter().all(|(name, count)| {
            found.iter().filter(|it| it.name == name.as_str()).count() == *count
        });
        let mut pairs = self.pairs(found);
        is_whole && is_counted && expected <= found.len() && pairs.all(|(a, b)| a.0 == b.name)
    }

    fn event_error(&self, found: &[TimedEvent]) -> Option<f64> {
        self.pairs(found).map(|(expected, it)| (expected.1 - it.t).abs()).reduce(f64::max)
    }

    /// Returns the largest error of a value; infinite if one is not finite.
    fn value_error(&self, found: &dyn Fn(&str) -> Option<f64>) -> Option<f64> {
        let scale = self.scale.unwrap_or(1.0);
        let error = |(name, right): (&String, &f64)| {
            Some((found(name)? - right).abs() / right.abs().max(scale)).filter(|it| it.is_finite())
        };
        self.r#final.iter().map(|it| error(it).unwrap_or(f64::INFINITY)).reduce(f64::max)
    }
}
