//! Compares a run with the reference: first the sequence of events, then the errors.

use pode::{Model, State};
use serde::{Deserialize, Serialize};

use super::observe::{FoundSamples, ObservedRun, SeenEvent};
use crate::scenario::{ExpectedEvent, Reference, ReferenceSample};

/// Verdict on a run: its events, and its errors if the events were right.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct RunVerdict {
    pub sequence: SequenceVerdict,
    /// Number of events, judged or not.
    pub events: usize,
    /// Largest error of an event's time (s).
    pub event_error: Option<f64>,
    /// Largest error of the state away from events; each entry over its largest magnitude.
    pub state_error: Option<f64>,
    /// Largest error of the force away from events, over its largest magnitude.
    pub force_error: Option<f64>,
    /// Least errors that the reference can show: of event times (s), and of states and force.
    pub least_errors: [f64; 2],
}

impl RunVerdict {
    /// Returns the verdict with smaller errors raised to those that the reference can show.
    pub(super) fn at_least(self, least: [f64; 2]) -> Self {
        let [event, state] = least;
        let raised = |error: Option<f64>, least: f64| error.map(|it| it.max(least));
        Self {
            event_error: raised(self.event_error, event),
            state_error: raised(self.state_error, state),
            force_error: raised(self.force_error, state),
            least_errors: least,
            ..self
        }
    }
}

/// Result of comparing the events with the reference.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SequenceVerdict {
    Right,
    Wrong(EventMismatch),
    Failed(String),
}

/// First difference between two sequences of events.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct EventMismatch {
    pub index: usize,
    pub expected: String,
    pub found: String,
}

impl SequenceVerdict {
    pub const fn is_right(&self) -> bool {
        matches!(self, Self::Right)
    }
}

pub(super) fn judge<M: Model>(reference: &Reference<M>, observed: &ObservedRun<M>) -> RunVerdict {
    let sequence = sequence(reference, observed);
    let is_right = sequence.is_right();
    RunVerdict {
        events: observed.events.len(),
        event_error: event_error(reference, observed).filter(|_| is_right),
        state_error: state_error(&reference.samples, &observed.samples).filter(|_| is_right),
        force_error: force_error(&reference.samples, &observed.samples).filter(|_| is_right),
        least_errors: [0.0; 2],
        sequence,
    }
}

fn sequence<M: Model>(reference: &Reference<M>, observed: &ObservedRun<M>) -> SequenceVerdict {
    if let Some(difference) = difference(reference, &observed.events) {
        return match &observed.trouble {
            // Later events are consequences of a cap or a fault.
            Some((t, why)) => SequenceVerdict::Failed(format!("{why} at {t:.4} s")),
            None => SequenceVerdict::Wrong(difference),
        };
    }
    if let Some((t, why)) = &observed.trouble {
        return SequenceVerdict::Failed(format!("{why} at {t:.4} s"));
    }
    match (reference.rest, observed.entered) {
        (Some((_, rest)), entered) if entered.map(|(_, mode)| mode) != Some(rest) => {
            SequenceVerdict::Wrong(EventMismatch {
                index: observed.events.len(),
                expected: format!("rest in {}", reference.mode_name(rest)),
                found: "no rest".to_owned(),
            })
        }
        _ => SequenceVerdict::Right,
    }
}

fn difference<M: Model>(reference: &Reference<M>, seen: &[SeenEvent<M>]) -> Option<EventMismatch> {
    let expected = &reference.events;
    let is_same = |(e, s): &(&ExpectedEvent<M>, &SeenEvent<M>)| e.guard == s.guard && e.to == s.to;
    let index = expected.iter().zip(seen).take_while(is_same).count();
    let is_over = index == seen.len() || !reference.is_whole;
    if index == expected.len() && is_over {
        return None;
    }
    let nothing = || "nothing".to_owned();
    let name = |guard: &str, to: M::Mode, t: f64| {
        format!("{guard} to {} at {t:.4} s", reference.mode_name(to))
    };
    let expected = expected.get(index).map_or_else(nothing, |e| name(&e.guard, e.to, e.t));
    let found = seen.get(index).map_or_else(nothing, |s| name(s.guard, s.to, s.t));
    Some(EventMismatch { index, expected, found })
}

/// Returns the largest error of a time (s): of the matched events, and of the rest that follows.
fn event_error<M: Model>(reference: &Reference<M>, observed: &ObservedRun<M>) -> Option<f64> {
    let pairs = reference.events.iter().zip(&observed.events);
    let events = pairs.map(|(expected, seen)| (expected.t - seen.t).abs());
    let rest =
        reference.rest.zip(observed.entered).map(|(rest, entered)| (rest.0 - entered.0).abs());
    events.chain(rest).reduce(f64::max)
}

/// Returns the largest error of any entry of the state, over that entry's largest magnitude.
fn state_error<S: State>(
    samples: &[ReferenceSample<S>],
    found: &[Option<FoundSamples<S>>],
) -> Option<f64> {
    let entries = S::ZERO.entries().len();
    let error = |index: usize| {
        let pairs = samples.iter().zip(found).filter_map(|(sample, found)| {
            let (state, _) = found.as_ref()?;
            Some((sample.state.entries()[index], state.entries()[index]))
        });
        relative(pairs)
    };
    (0..entries).filter_map(error).reduce(f64::max)
}

fn force_error<S>(
    samples: &[ReferenceSample<S>],
    found: &[Option<FoundSamples<S>>],
) -> Option<f64> {
    let pairs = samples.iter().zip(found);
    relative(pairs.filter_map(|(sample, found)| Some((sample.force, found.as_ref()?.1))))
}

/// Returns the largest difference of the pairs (right, found), over the largest right one.
fn relative(pairs: impl Iterator<Item = (f64, f64)>) -> Option<f64> {
    let sizes = pairs.map(|(right, found)| ((right - found).abs(), right.abs()));
    let (error, size) = sizes.reduce(|most, it| (most.0.max(it.0), most.1.max(it.1)))?;
    Some(if size > 0.0 { error / size } else { error })
}

#[cfg(test)]
mod tests;
