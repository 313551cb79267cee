//! A run against the reference: first the order of the events, then the errors of events and of
//! states, each on its own.

use crate::reference::{Expected, Reference};

#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Verdict {
    /// `true` if the code reports events; otherwise only its states are judged.
    pub(crate) has_events: bool,
    pub(crate) events: usize,
    pub(crate) failure: Option<String>,
    /// Largest error of an event's time (s).
    pub(crate) event_error: Option<f64>,
    /// Largest error of the state away from events, each component over its largest magnitude.
    pub(crate) state_error: Option<f64>,
}

/// Judges a code that reports no events by `states`; a missing state is a failure.
pub(crate) fn judge_states(
    reference: &Reference,
    states: &[f64],
    ended: Result<(), String>,
) -> Verdict {
    let state_error = state_error(reference, states);
    let missing = || state_error.is_none().then(|| "states are missing".to_owned());
    let failure = ended.err().or_else(missing);
    let state_error = state_error.filter(|_| failure.is_none());
    Verdict { has_events: false, events: 0, failure, event_error: None, state_error }
}

/// Judges `events` (time (s), guard) and `states`, or the error that ended the run.
pub(crate) fn judge(
    reference: &Reference,
    events: &[(f64, &str)],
    states: &[f64],
    ended: Result<(), String>,
) -> Verdict {
    let failure = difference(&reference.events, events).map(|what| match &ended {
        Err(why) => format!("{what}; {why}"),
        Ok(()) => what,
    });
    let failure = failure.or(ended.err());
    let is_right = failure.is_none();
    let off = reference.events.iter().zip(events).map(|(e, (t, _))| (e.t - t).abs());
    Verdict {
        has_events: true,
        events: events.len(),
        failure,
        event_error: is_right.then(|| off.fold(0.0, f64::max)),
        state_error: is_right.then(|| state_error(reference, states)).flatten(),
    }
}

fn difference(expected: &[Expected], seen: &[(f64, &str)]) -> Option<String> {
    let same = |(e, s): &(&Expected, &(f64, &str))| e.guard == s.1;
    let first = expected.iter().zip(seen).take_while(same).count();
    if first == expected.len() && first == seen.len() {
        return None;
    }
    let expected_there = expected
        .get(first)
        .map_or_else(|| "nothing more".to_owned(), |e| format!("{} at {:.4} s", e.guard, e.t));
    let seen_there = seen
        .get(first)
        .map_or_else(|| "nothing more".to_owned(), |(t, guard)| format!("{guard} at {t:.4} s"));
    let (n, of) = (seen.len(), expected.len());
    Some(format!("{n} events for {of}: after {first}, {seen_there} where {expected_there} is due"))
}

fn state_error(reference: &Reference, states: &[f64]) -> Option<f64> {
    let width = reference.scales.len();
    if width == 0 || states.len() != width * reference.states.len() {
        return None;
    }
    let error = |(right, is): (&Vec<f64>, &[f64])| {
        let parts = right.iter().zip(is).zip(&reference.scales);
        parts.fold(0.0, |most: f64, ((a, b), scale)| most.max((a - b).abs() / scale))
    };
    Some(reference.states.iter().zip(states.chunks(width)).map(error).fold(0.0, f64::max))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reference() -> Reference {
        let expected = |t: f64, guard: &str| Expected { t, guard: guard.to_owned() };
        Reference::new(
            vec![expected(0.1, "release"), expected(0.2, "land")],
            vec![(0.05, vec![2.0]), (0.15, vec![-4.0])],
        )
    }

    #[test]
    fn errors_are_measured_only_where_the_sequence_is_right() {
        let right = [(0.1, "release"), (0.2 + 1e-6, "land")];
        let verdict = judge(&reference(), &right, &[2.0, -4.4], Ok(()));
        assert_eq!(verdict.failure, None);
        assert!((verdict.event_error.unwrap() - 1e-6).abs() < 1e-12);
        assert!((verdict.state_error.unwrap() - 0.1).abs() < 1e-12);
        let wrong = [(0.1, "release"), (0.15, "string")];
        let verdict = judge(&reference(), &wrong, &[2.0, -4.0], Ok(()));
        assert_eq!((verdict.event_error, verdict.state_error), (None, None));
        assert_eq!(
            verdict.failure.unwrap(),
            "2 events for 2: after 1, string at 0.1500 s where land at 0.2000 s is due"
        );
    }

    #[test]
    fn a_missing_event_and_an_error_are_failures() {
        let verdict = judge(&reference(), &[(0.1, "release")], &[], Ok(()));
        assert!(verdict.failure.unwrap().contains("nothing more where land at 0.2000 s is due"));
        let right = [(0.1, "release"), (0.2, "land")];
        let verdict = judge(&reference(), &right, &[], Err("stopped".to_owned()));
        assert_eq!(verdict.failure.unwrap(), "stopped");
    }
}
