//! Judges hand-made runs: missing and extra events, states that differ, runs cut short.

use pode::Motion;

use super::*;

#[derive(Clone, Copy, Debug)]
struct Ball;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Mode {
    Flight,
    Rest,
}

impl Model for Ball {
    type Mode = Mode;
    type State = [f64; 2];
    type Input = Motion;
    const COORDS: usize = 1;

    fn derivative(&self, _mode: Mode, _x: &[f64; 2], _input: &Motion) -> [f64; 2] {
        [0.0; 2]
    }
}

fn expected(t: f64, guard: &str, to: Mode) -> ExpectedEvent<Ball> {
    ExpectedEvent { t, guard: guard.to_owned(), to }
}

fn reference() -> Reference<Ball> {
    Reference {
        events: vec![
            expected(0.1, "floor", Mode::Flight),
            expected(0.2, "floor", Mode::Rest),
            expected(0.3, "lift", Mode::Flight),
        ],
        is_whole: true,
        rest: None,
        names: Vec::new(),
        samples: vec![
            ReferenceSample { t: 0.15, state: [2.0, -4.0], force: 10.0 },
            ReferenceSample { t: 0.25, state: [1.0, 1.0], force: 0.0 },
        ],
    }
}

fn right() -> ObservedRun<Ball> {
    let reference = reference();
    let seen = [("floor", Mode::Flight), ("floor", Mode::Rest), ("lift", Mode::Flight)];
    let times = reference.events.iter().map(|event| event.t);
    ObservedRun {
        events: times.zip(seen).map(|(t, (guard, to))| SeenEvent { t, guard, to }).collect(),
        entered: Some((0.3, Mode::Flight)),
        samples: reference.samples.iter().map(|it| Some((it.state, it.force))).collect(),
        work: Vec::new(),
        ticks: Vec::new(),
        residual: 0.0,
        trouble: None,
    }
}

#[track_caller]
fn wrong(observed: &ObservedRun<Ball>) -> (usize, String, String) {
    let verdict = judge(&reference(), observed);
    let errors = [verdict.event_error, verdict.state_error, verdict.force_error];
    assert_eq!(errors, [None; 3], "a wrong sequence has no error");
    let SequenceVerdict::Wrong(EventMismatch { index, expected, found }) = verdict.sequence else {
        panic!("{verdict:?}");
    };
    (index, expected, found)
}

#[test]
fn a_run_that_is_right_has_its_largest_errors() {
    let mut observed = right();
    observed.events[1].t += 1e-6;
    observed.events[2].t -= 1e-7;
    observed.samples[0] = Some(([2.0 - 0.2, -4.0], 10.0));
    observed.samples[1] = Some(([1.0, 1.0 + 1.0], 0.5));
    let verdict = judge(&reference(), &observed);
    assert_eq!((verdict.events, verdict.sequence.is_right()), (3, true));
    let near = |found: Option<f64>, right: f64| (found.unwrap() - right).abs() < 1e-12;
    assert!(near(verdict.event_error, 1e-6), "{verdict:?}");
    // 0.2 of 2 is less than 1 of 4.
    assert!(near(verdict.state_error, 0.25), "{verdict:?}");
    assert!(near(verdict.force_error, 0.05), "{verdict:?}");
}

#[test]
fn a_missing_event_is_where_the_sequence_differs() {
    let mut observed = right();
    observed.events.remove(1);
    let (index, expected, found) = wrong(&observed);
    assert_eq!(index, 1);
    assert_eq!(expected, "floor to Rest at 0.2000 s");
    assert_eq!(found, "lift to Flight at 0.3000 s");
}

#[test]
fn an_event_too_few_at_the_end_is_missed_too() {
    let mut observed = right();
    observed.events.pop();
    let (index, expected, found) = wrong(&observed);
    assert_eq!(
        (index, expected.as_str(), found.as_str()),
        (2, "lift to Flight at 0.3000 s", "nothing")
    );
}

#[test]
fn an_extra_event_is_where_the_sequence_differs() {
    let mut observed = right();
    observed.events.insert(0, SeenEvent { t: 0.05, guard: "lift", to: Mode::Flight });
    assert_eq!(wrong(&observed).0, 0);
    let mut observed = right();
    observed.events.push(SeenEvent { t: 0.4, guard: "floor", to: Mode::Rest });
    assert_eq!(wrong(&observed).1, "nothing");
}

#[test]
fn the_right_guard_into_the_wrong_mode_is_wrong() {
    let mut observed = right();
    observed.events[1].to = Mode::Flight;
    assert_eq!(wrong(&observed).0, 1);
}

#[test]
fn more_events_may_follow_where_only_the_first_are_judged() {
    let reference = Reference { is_whole: false, ..reference() };
    let mut observed = right();
    observed.events.push(SeenEvent { t: 0.4, guard: "floor", to: Mode::Rest });
    assert!(judge(&reference, &observed).sequence.is_right());
    observed.events.truncate(2);
    assert!(!judge(&reference, &observed).sequence.is_right());
}

#[test]
fn the_rest_that_events_lead_to_is_judged_like_an_event() {
    let reference = Reference { rest: Some((0.5, Mode::Rest)), ..reference() };
    let mut observed = right();
    assert!(!judge(&reference, &observed).sequence.is_right(), "it is in the air");
    observed.entered = Some((0.5 + 1e-3, Mode::Rest));
    let error = judge(&reference, &observed).event_error.unwrap();
    assert!((error - 1e-3).abs() < 1e-15, "{error}");
}

#[test]
fn a_run_that_was_cut_short_has_failed_and_says_when() {
    let mut observed = right();
    observed.trouble = Some((0.125, "the state is not finite".into()));
    let failed = SequenceVerdict::Failed("the state is not finite at 0.1250 s".to_owned());
    assert_eq!(judge(&reference(), &observed).sequence, failed);
}

#[test]
fn what_no_tick_ended_at_is_not_compared() {
    let mut observed = right();
    observed.samples[0] = None;
    observed.samples[1] = Some(([1.0, 1.5], 0.0));
    assert_eq!(judge(&reference(), &observed).state_error, Some(0.5));
    observed.samples[1] = None;
    assert_eq!(judge(&reference(), &observed).state_error, None);
}
