//! One run of a case, and its verdict.

use clap::Parser as _;
use cli::simulate::{
    MOST_ENERGY_ERROR, SimulateArgs, SimulateError, Simulated, TimedEvent, simulate,
};
use instruments::LoadedModel;
use pode::Stepper as _;
use pode::stepper::ByNeed;
use serde::Serialize;

use super::case::{ExpectedRun, HardCase, HardFailure};

/// Angle of the fastest motion over a run (rad), of which `by-need` has a budget per radian.
const RADIANS: f64 = 10.0;

/// Verdict on a run, the best first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum HardVerdict {
    /// The events are right, and every error is within its tolerance.
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
#[derive(Clone, Debug, Serialize)]
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

    /// Returns the row of a run without results.
    pub(super) fn ended(
        method: &'static str,
        step: f64,
        verdict: HardVerdict,
        remark: String,
    ) -> Self {
        Self {
            method,
            step,
            verdict,
            event_error: None,
            value_error: None,
            energy_error: None,
            derivatives: None,
            remark,
        }
    }
}

impl HardCase {
    pub(super) fn run(&self, model: &LoadedModel, method: &'static str, step: f64) -> HardRun {
        let done = self.args(method, step).map(|args| simulate(model, &args));
        match done {
            Err(usage) => HardRun::ended(method, step, HardVerdict::Refused, usage.to_string()),
            Ok(Err(error @ SimulateError::Usage(_))) => {
                HardRun::ended(method, step, HardVerdict::Refused, error.to_string())
            }
            Ok(Err(error)) => {
                let is_right = self.expected.fails == Some(HardFailure::Fault);
                let verdict = if is_right { HardVerdict::Right } else { HardVerdict::Reported };
                HardRun::ended(method, step, verdict, error.to_string())
            }
            Ok(Ok(simulated)) => self.judge(method, step, &simulated),
        }
    }

    fn args(&self, method: &str, step: f64) -> Result<SimulateArgs, clap::Error> {
        let [until, step] = [self.until, step].map(|it| it.to_string());
        let words =
            ["simulate", &self.model, "--until", &until, "--step", &step, "--method", method];
        let words = words.into_iter().chain(self.arguments.iter().map(String::as_str));
        Ok(SimulateArgs { first_tick: self.first_tick, ..SimulateArgs::try_parse_from(words)? })
    }

    fn judge(&self, method: &'static str, step: f64, simulated: &Simulated) -> HardRun {
        let (expected, report) = (&self.expected, &simulated.report);
        let is_sequence = expected.is_sequence(&simulated.events);
        let event_error = expected.event_error(&simulated.events).filter(|_| is_sequence);
        let state = &report["final"]["state"];
        let value_error = expected.value_error(&|name| state[name].as_f64());
        let energy_error = report["energy_audit"]["error"].as_f64();
        // Its tolerance is an error per radian, which no step makes smaller.
        let is_budgeted = method == ByNeed::NAME;
        let radians = expected.radians.unwrap_or(RADIANS);
        let budget = if is_budgeted { radians * ByNeed::BUDGET } else { 0.0 };
        let time = expected.tolerance.max(budget * self.until.min(1.0));
        let value = expected.accuracy.unwrap_or(expected.tolerance).max(budget);
        let largest = [(event_error, time), (value_error, value)]
            .into_iter()
            .chain(expected.energy.map(|most| (energy_error, most.max(budget))));
        let mut is_within = true;
        for (error, most) in largest {
            is_within &= error.is_none_or(|error| error <= most);
        }
        let is_reported = energy_error.is_some_and(|error| MOST_ENERGY_ERROR < error);
        let verdict = match (is_sequence && expected.fails.is_none(), is_within, is_reported) {
            (true, true, _) => HardVerdict::Right,
            (_, _, true) => HardVerdict::Reported,
            (true, false, false) => HardVerdict::Rough,
            (false, _, false) => HardVerdict::Wrong,
        };
        let remark = if is_sequence { String::new() } else { listed(&simulated.events) };
        let derivatives = report["counts"]["evaluations"]["derivatives"].as_u64();
        let row = HardRun::ended(method, step, verdict, remark);
        HardRun { event_error, value_error, energy_error, derivatives, ..row }
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
            let error = (found(name)? - right).abs() / right.abs().max(scale);
            error.is_finite().then_some(error)
        };
        let errors = self.r#final.iter().map(|it| error(it).unwrap_or(f64::INFINITY));
        errors.reduce(f64::max)
    }
}

/// Lists the first events, for a remark.
fn listed(events: &[TimedEvent]) -> String {
    const SHOWN: usize = 6;
    let first = events.iter().take(SHOWN).map(|it| format!("{} {:.6}", it.name, it.t));
    format!("{} events: {}", events.len(), first.collect::<Vec<_>>().join(", "))
}
