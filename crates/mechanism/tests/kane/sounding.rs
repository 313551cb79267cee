use pode::contacts::{ContactGuard, WithContacts};
use pode::stepper::Rk4;
use pode::{Event, EventCause, Limits, Motion, Piece, Signal, Simulator, Watch, Work};

use crate::kane::runnable::{Run, described, model, shipped};

type Action = WithContacts<Run<10>>;

const STRING: &str = "string";

/// Events of the string: closing or not, sounding speed, and speed of the hammer's head.
#[derive(Default)]
struct Strings(Vec<(bool, Option<f64>, f64)>);

impl Watch<Action> for Strings {
    fn piece<S: Signal<Motion>>(&mut self, _: &Action, _: &Piece<'_, Action, S>) {}

    fn event(&mut self, model: &Action, event: &Event<'_, Action>) {
        let EventCause::Guard(spec) = event.cause else { return };
        let ContactGuard::Gap(contact) = ContactGuard::of(spec.id) else { return };
        if spec.name == STRING {
            let state = &event.before.1;
            let sounds = model.system().contact_sounding(contact, state);
            let closes = !event.before.0.contacts.is_closed(contact);
            // The shank is 130 mm long and turns by the fifth coordinate, 10 states in all.
            self.0.push((closes, sounds, 0.13 * state[9] * state[4].cos()));
        }
    }
}

fn pressed(text: &str, length: f64, reach: f64) -> (Strings, Work) {
    let action: Run<10> = model(described(text), (0, 40));
    let still = Motion::default();
    let pose = action.rest_pose(&still);
    let contacts = WithContacts::new(action).unwrap();
    let (mode, state) = contacts.start(pose.mode, &pose.state, &still);
    let mut simulator = Simulator::new(contacts, Rk4, Limits::default(), mode, state);
    let press = |t: f64| half_cosine(t, length, reach);
    let mut told = Strings::default();
    let outcome = simulator.run(0.2, 1e-4, press, &mut told);
    assert!(outcome.is_completed(), "{outcome:?}");
    (told, outcome.work)
}

fn half_cosine(t: f64, length: f64, reach: f64) -> Motion {
    let w = std::f64::consts::PI / length;
    if t > length {
        return Motion { position: reach, ..Motion::default() };
    }
    let (sin, cos) = (w * t).sin_cos();
    let half = reach / 2.0;
    Motion {
        position: half * (1.0 - cos),
        rate: half * w * sin,
        acceleration: half * w * w * cos,
        jerk: -half * w * w * w * sin,
    }
}

#[test]
fn a_hammer_that_meets_the_string_sounds_with_its_speed_and_not_where_it_leaves() {
    let text = shipped("grand-action");
    let (told, _) = pressed(&text, 0.08, 10e-3);
    let [(true, Some(speed), rise), (false, None, _)] = told.0[..] else {
        panic!("one stroke: it closes and opens: {:?}", told.0)
    };
    assert!((speed - rise).abs() < 1e-12 && speed > 0.5, "{speed} m/s, not {rise}");
    assert!(pressed(&text, 0.08, 3e-3).0.0.is_empty(), "it does not reach the string");
}

#[test]
fn most_steps_of_a_stroke_are_certain_though_frictions_slide() {
    let (_, work) = pressed(&shipped("grand-action"), 0.08, 10e-3);
    println!("{} certain, {} not", work.certain, work.unknown);
    assert!(work.certain > work.unknown, "{work:?}");
}
