//! Strokes rehearsed on a key with closed-form responses.

use haptics::plant::{Gesture, Touch};
use midi::{Velocity, VelocityCurve};
use pianist::{
    DamperFall, PlannedStroke, PlayOutcome, Practice, Rehearsal, RehearsedStroke, Shortfall,
    Strike, StrokeTable, StrokeTables, Technique, rehearse::tabulate,
};

/// Time from a release to the fall of the damper (s).
const FALL: f64 = 0.04;

/// A key that throws its hammer four times as fast as the finger, 10 mm after its start. Shortly
/// after a release it still rises and throws up to 20 % faster.
#[derive(Clone, Debug, Default)]
struct Toy {
    now: f64,
    released: Option<f64>,
    /// Finger speed above which a pressed hammer bounces and strikes twice (m/s).
    bounces_above: Option<f64>,
    /// Time after a release without any strike (s).
    returns_in: f64,
    /// Extra delay of the damper's fall (s).
    hangs: f64,
    /// Largest hammer speed (m/s).
    ceiling: Option<f64>,
}

impl Toy {
    fn strikes(&self, gesture: &Gesture, released: Option<f64>) -> Vec<Strike> {
        let at = gesture.start + 0.01 / gesture.speed;
        let is_back = released.is_none_or(|released| gesture.start >= released + self.returns_in);
        if at > gesture.release || !is_back {
            return Vec::new();
        }
        let haste =
            released.map_or(0.0, |released| 0.2 * (-(gesture.start - released) / 0.1).exp());
        let speed = 4.0 * gesture.speed * (1.0 + haste);
        let speed = self.ceiling.map_or(speed, |ceiling| speed.min(ceiling));
        let bounces = gesture.touch == Touch::Pressed
            && self.bounces_above.is_some_and(|limit| gesture.speed > limit);
        let second = Strike { at: at + 0.03, speed: 0.3 * speed };
        if bounces { vec![Strike { at, speed }, second] } else { vec![Strike { at, speed }] }
    }
}

impl Rehearsal for Toy {
    fn play(&mut self, gestures: &[Gesture], until: f64) -> PlayOutcome {
        let mut outcome = PlayOutcome::default();
        let span = self.now..until;
        for gesture in gestures {
            let strikes = self.strikes(gesture, self.released);
            outcome.strikes.extend(strikes.iter().filter(|strike| span.contains(&strike.at)));
            let fall = gesture.release + FALL + self.hangs;
            if span.contains(&fall) {
                outcome.damper_fall = Some(DamperFall { at: fall, speed: 0.2 });
            }
            if gesture.release <= until {
                self.released = Some(gesture.release);
            }
        }
        self.now = until;
        outcome
    }

    /// The key is up at once.
    fn depth(&self) -> f64 {
        0.0
    }

    fn period(&self) -> f64 {
        1e-3
    }
}

fn stroke(onset: f64, end: f64, velocity: u8, touch: Touch) -> PlannedStroke {
    let velocity = Velocity::nearest(f64::from(velocity));
    let speed = VelocityCurve::Disklavier.speed(velocity);
    PlannedStroke { key: 39, onset, end, speed, velocity, touch, release: None }
}

fn rehearse(toy: &Toy, strokes: &[PlannedStroke]) -> Vec<RehearsedStroke> {
    let technique = Technique::default();
    let tables = StrokeTables::measure(toy, &technique, &[Gesture::LIFT]);
    let practice = Practice { tables, curve: VelocityCurve::Disklavier, technique: &technique };
    let mut n_reported = 0;
    let rehearsed = practice.rehearse(toy.clone(), strokes, || n_reported += 1);
    assert_eq!(n_reported, strokes.len());
    check_script(toy, &rehearsed);
    rehearsed
}

/// Asserts that the gestures, played in one go on a new key, act as predicted.
#[track_caller]
fn check_script(toy: &Toy, rehearsed: &[RehearsedStroke]) {
    let mut toy = toy.clone();
    let gestures: Vec<_> = rehearsed.iter().filter_map(|stroke| stroke.gesture).collect();
    for stroke in rehearsed {
        // Each gesture is given only now, and before the next begins.
        let Some(gesture) = stroke.gesture else {
            assert_eq!(stroke.strike, None, "{stroke:?}");
            continue;
        };
        let next = gestures.iter().map(|it| it.start).find(|start| *start > gesture.start);
        let until = next.map_or(gesture.end(), |next| next.min(gesture.end()));
        let played = toy.play(&[gesture], until);
        assert_eq!(played.strikes.first().copied(), stroke.strike);
    }
    for pair in gestures.windows(2) {
        assert!(pair[0].release < pair[1].start, "fingers collide: {pair:?}");
    }
}

/// Returns the release of a played stroke (s).
#[track_caller]
fn release(stroke: &RehearsedStroke) -> f64 {
    stroke.gesture.expect("it is played").release
}

#[track_caller]
fn check_met(stroke: &RehearsedStroke) {
    let strike = stroke.strike.expect("a strike");
    let level = VelocityCurve::Disklavier.level(strike.speed);
    assert_eq!((stroke.n_strikes, stroke.shortfall), (1, None), "{stroke:?}");
    assert!((strike.at - stroke.wanted.onset).abs() <= 1e-4, "{stroke:?}");
    assert!((level - f64::from(stroke.wanted.velocity.get())).abs() <= 0.3, "{stroke:?}");
}

#[test]
fn a_table_says_what_the_key_does_from_rest() {
    let table = tabulate(&Toy::default(), Touch::Pressed, &Technique::default());
    assert!((table.command(1.0) - 0.25).abs() < 1e-9);
    assert!((table.delay(0.25) - 0.04).abs() < 1e-9);
    let (softest, loudest) = table.range().expect("it strikes");
    assert!((softest - 0.08).abs() < 1e-9 && (28.0..=32.0).contains(&loudest));
}

#[test]
fn trials_that_strike_twice_are_not_in_the_table() {
    let toy = Toy { bounces_above: Some(0.5), ..Toy::default() };
    let (_, loudest) =
        tabulate(&toy, Touch::Pressed, &Technique::default()).range().expect("it strikes");
    assert!(loudest <= 2.0);
}

#[test]
fn strokes_far_apart_are_met_at_the_first_try() {
    let rehearsed = rehearse(
        &Toy::default(),
        &[stroke(1.0, 2.0, 30, Touch::Pressed), stroke(5.0, 6.0, 105, Touch::Struck)],
    );
    for stroke in &rehearsed {
        check_met(stroke);
        assert_eq!(stroke.gesture.expect("it is played").touch, stroke.wanted.touch);
        assert!((stroke.damper_fall.expect("it falls").at - stroke.wanted.end).abs() < 3e-3);
    }
    assert_eq!(rehearsed[0].n_tries, 2, "one for the strike, one for the release");
}

#[test]
fn a_key_whose_damper_falls_late_is_let_go_early() {
    let slow = Toy { hangs: 0.2, ..Toy::default() };
    let rehearsed = rehearse(&slow, &[stroke(1.0, 2.0, 60, Touch::Pressed)]);
    check_met(&rehearsed[0]);
    assert!((rehearsed[0].damper_fall.expect("it falls").at - 2.0).abs() < 3e-3);
    assert!((release(&rehearsed[0]) - 1.76).abs() < 3e-3);
}

#[test]
fn a_repeated_key_is_met_from_the_state_it_is_in() {
    let strokes: Vec<_> = (0..40)
        .map(|i| {
            let onset = 1.0 + 0.25 * f64::from(i);
            let velocity = 40 + u8::try_from(i * 7 % 60).expect("below 60");
            stroke(onset, onset + 0.15, velocity, Touch::Pressed)
        })
        .collect();
    let rehearsed = rehearse(&Toy::default(), &strokes);
    rehearsed.iter().for_each(check_met);
    assert!(rehearsed[1].n_tries > rehearsed[0].n_tries, "what rest teaches is not enough");
}

#[test]
fn a_key_wanted_at_once_is_let_go_early() {
    let strokes = [stroke(1.0, 1.2, 60, Touch::Pressed), stroke(1.2, 2.0, 60, Touch::Pressed)];
    let rehearsed = rehearse(&Toy::default(), &strokes);
    rehearsed.iter().for_each(check_met);
    // The next begins 38 ms before its strike.
    assert!(release(&rehearsed[0]) < 1.162, "{:?}", rehearsed[0]);
}

#[test]
fn a_key_that_returns_slowly_is_let_go_earlier_still() {
    let slow = Toy { returns_in: 0.15, ..Toy::default() };
    let strokes = [stroke(1.0, 1.2, 60, Touch::Pressed), stroke(1.25, 2.0, 60, Touch::Pressed)];
    let rehearsed = rehearse(&slow, &strokes);
    rehearsed.iter().for_each(check_met);
    let usual = release(&rehearse(&Toy::default(), &strokes)[0]);
    assert!(release(&rehearsed[0]) < usual - 0.05);
}

#[test]
fn a_stroke_that_bounces_is_played_with_the_other_touch() {
    let toy = Toy { bounces_above: Some(0.3), ..Toy::default() };
    let rehearsed = rehearse(&toy, &[stroke(1.0, 2.0, 80, Touch::Pressed)]);
    check_met(&rehearsed[0]);
    assert_eq!(rehearsed[0].gesture.expect("it is played").touch, Touch::Struck);
}

#[test]
fn what_cannot_be_in_time_is_left_out_and_named() {
    // 10 ms after the other: no finger is back by then.
    let strokes = [stroke(1.0, 1.5, 60, Touch::Pressed), stroke(1.01, 1.5, 60, Touch::Pressed)];
    let rehearsed = rehearse(&Toy::default(), &strokes);
    check_met(&rehearsed[0]);
    assert_eq!((rehearsed[1].gesture, rehearsed[1].strike), (None, None));
    let Some(Shortfall::TooSoon { late: Some(late) }) = rehearsed[1].shortfall else {
        panic!("{:?}", rehearsed[1].shortfall)
    };
    assert!((0.03..0.2).contains(&late), "{late} s late");
    let fall = rehearsed[0].damper_fall.expect("it falls").at;
    assert!((fall - 1.5).abs() < 3e-3, "the note before keeps its length, not {fall} s");
}

#[test]
fn quick_repetitions_do_not_delay_what_comes_after_them() {
    // Eight in a second, of a key that takes a quarter of a second to come back.
    let slow = Toy { returns_in: 0.15, ..Toy::default() };
    let again = (0..40).map(|i| 1.0 + 0.125 * f64::from(i));
    let mut strokes: Vec<_> =
        again.map(|onset| stroke(onset, onset + 0.06, 40, Touch::Struck)).collect();
    strokes.push(stroke(7.0, 7.5, 60, Touch::Pressed));
    let rehearsed = rehearse(&slow, &strokes);
    let (played, left_out): (Vec<_>, Vec<_>) =
        rehearsed.iter().partition(|stroke| stroke.shortfall.is_none());
    for stroke in &played {
        check_met(stroke);
    }
    assert!(played.len() >= 21, "every second one, and the last: {}", played.len());
    assert!(left_out.iter().all(|it| matches!(it.shortfall, Some(Shortfall::TooSoon { .. }))));
    assert_eq!(rehearsed.last().expect("the last").shortfall, None);
}

#[test]
fn a_long_note_is_not_cut_for_one_that_no_release_would_help() {
    let weak = Toy { ceiling: Some(4.0), ..Toy::default() };
    let strokes = [stroke(1.0, 3.0, 60, Touch::Pressed), stroke(3.3, 4.0, 120, Touch::Struck)];
    let rehearsed = rehearse(&weak, &strokes);
    check_met(&rehearsed[0]);
    let fall = rehearsed[0].damper_fall.expect("it falls").at;
    assert!((fall - 3.0).abs() < 3e-3, "{fall} s");
    let Some(Shortfall::Level { speed, wanted }) = rehearsed[1].shortfall else {
        panic!("{:?}", rehearsed[1].shortfall)
    };
    assert!((speed - 4.0).abs() < 1e-9 && wanted > 7.0, "{speed} of {wanted} m/s");
    assert!(rehearsed[1].gesture.is_some(), "the loudest that there is");
}

/// A key whose hammer never arrives.
#[derive(Clone)]
struct Broken;

impl Rehearsal for Broken {
    fn play(&mut self, _gestures: &[Gesture], _until: f64) -> PlayOutcome {
        PlayOutcome::default()
    }

    fn depth(&self) -> f64 {
        0.0
    }

    fn period(&self) -> f64 {
        1e-3
    }
}

#[test]
fn a_key_that_never_strikes_is_reported_and_not_waited_for() {
    let technique = Technique::default();
    let tables = StrokeTables::measure(&Broken, &technique, &[Gesture::LIFT]);
    assert_eq!(tables.pressed, StrokeTable::default());
    let practice = Practice { tables, curve: VelocityCurve::Disklavier, technique: &technique };
    let rehearsed = practice.rehearse(Broken, &[stroke(1.0, 2.0, 60, Touch::Pressed)], || ());
    assert_eq!((rehearsed[0].strike, rehearsed[0].n_strikes), (None, 0));
    assert_eq!((rehearsed[0].shortfall, rehearsed[0].gesture), (Some(Shortfall::Silent), None));
    assert!(rehearsed[0].n_tries <= 2 * 12 + 4);
}
