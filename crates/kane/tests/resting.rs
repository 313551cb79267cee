//! Where described models rest: against closed forms, and beside models written by hand.
#![expect(clippy::unwrap_used, reason = "a test fails aloud")]

use contacts::WithContacts;
use equations::{EquationModel, ModeNumber, RestPose};
use hand_written::{CartPendulum, ReducedGrand, SpringWall};
use kane::assemble::TapeFunctions;
use kane::description::NoBases;
use kane::{DerivedModel, derive_model};
use models::Described;
use pode::stepper::Rk4;
use pode::{Limits, Motion, Silent, Simulator};

use crate::shipped::{Folder, files};

pub(crate) type Run<const N: usize> = EquationModel<&'static TapeFunctions, N, 512>;

/// The model that `text` describes.
pub(crate) fn described(text: &str) -> DerivedModel {
    derive_model("it.toml", text, &Folder).unwrap_or_else(|mistakes| panic!("{mistakes}"))
}

/// The same, with the values of a preset for a key.
#[expect(clippy::large_stack_frames, reason = "a test, off the tick")]
pub(crate) fn model<const N: usize>(derived: DerivedModel, case: (usize, u8)) -> Run<N> {
    let functions: &'static TapeFunctions = Box::leak(Box::new(derived.program.functions));
    let table = derived.program.table;
    let default = Run::<N>::new(table, functions, &[]).unwrap();
    let mut values = vec![0.0; table.parameters.len()];
    default.preset(case.0, case.1, &mut values);
    Run::<N>::new(table, functions, &values).unwrap()
}

/// The text of a description that is shipped.
pub(crate) fn shipped(name: &str) -> String {
    let texts = files().into_iter().map(|file| std::fs::read_to_string(file).unwrap());
    let mut named = texts.filter(|text| text.starts_with(&format!("name = \"{name}\"")));
    named.next().unwrap()
}

fn still(position: f64) -> Motion {
    Motion { position, ..Motion::default() }
}

/// A beam on two felts, its weight nearer to the left one; it starts above both.
const BEAM: &str = r#"
name = "beam"
summary = "a beam on two felts"
gravity = ["0", "-9.81 m/s^2"]

[coordinates]
y = { unit = "m", range = ["-1 m", "1 m"], speed_range = ["-1 m/s", "1 m/s"] }
turn = { unit = "rad", range = ["-1 rad", "1 rad"], speed_range = ["-1 rad/s", "1 rad/s"] }

[frames]
B = { origin = ["0 m", "y"], turn = "turn" }
[points]
left = { in = "B", at = ["-0.2 m"] }
right = { in = "B", at = ["0.3 m"] }
[bodies]
beam = { frame = "B", mass = "0.5 kg", inertia = "0.01 kg*m^2" }

[contacts]
left = { gap = "y(left)", stiffness = "2e6 N/m^2", exponent = 2 }
right = { gap = "y(right)", stiffness = "5e5 N/m^2", exponent = 2, damping = "1 s/m" }

[rest]
y = "0.1 m"
turn = "0.3 rad"
"#;

#[test]
fn what_starts_above_its_contacts_comes_to_lie_on_them() {
    let beam: Run<4> = model(described(BEAM), (0, 0));
    let pose = beam.rest_pose(&still(0.0));
    assert_eq!(pose.imbalance, None);
    let [y, turn, ..] = pose.state;
    // The moments about the centre are in balance: 0.2 L = 0.3 R, with L + R the weight.
    let depth = |force: f64, stiffness: f64| (force / stiffness).sqrt();
    let weight = 0.5 * 9.81;
    let left = -depth(weight * 0.6, 2e6);
    let right = -depth(weight * 0.4, 5e5);
    assert!((y - 0.2 * turn.sin() - left).abs() < 1e-12, "{y} {turn}");
    assert!((y + 0.3 * turn.sin() - right).abs() < 1e-12, "{y} {turn}");
}

#[test]
fn a_mass_over_a_stop_rests_on_it_though_newton_sees_no_force() {
    // Free above the stop: Newton's matrix is singular there.
    let text = r#"
name = "block"
summary = "a block over a felt"
gravity = ["0", "-9.81 m/s^2"]
[coordinates]
y = { unit = "m", range = ["-1 m", "1 m"], speed_range = ["-1 m/s", "1 m/s"] }
[frames]
B = { origin = ["0 m", "y"] }
[bodies]
block = { frame = "B", mass = "2 kg" }
[contacts]
floor = { gap = "y", stiffness = "1e4 N / (1 m)^1.5", exponent = 1.5 }
[rest]
y = "0.5 m"
"#;
    let block: Run<2> = model(described(text), (0, 0));
    let [y, rate] = block.rest_pose(&still(0.0)).state;
    let depth = (2.0 * 9.81 / 1e4_f64).powf(2.0 / 3.0);
    assert!((y + depth).abs() < 1e-12 && rate.abs() < 1e-15, "{y}, not -{depth}");
}

#[test]
fn a_grand_action_rests_on_its_felts_on_every_key() {
    for (key, input) in [(0, 0.0), (40, 0.0), (87, 0.0), (40, 5e-3), (40, 10e-3)] {
        let action: Run<10> = model(described(&shipped("grand-action")), (0, key));
        let pose = action.rest_pose(&still(input));
        assert_eq!(pose.imbalance, None, "key {key} at {input}");
        let contacts = WithContacts::new(action).unwrap();
        let (mode, state) = contacts.start(pose.mode, &pose.state, &still(input));
        assert!(mode.contacts.closed().len() >= 5, "what touches: {mode:?}");
        let mut simulator = Simulator::new(contacts, Rk4, Limits::default(), mode, state);
        let moved = simulator.run(0.1, 1e-4, |_| still(input), &mut Silent);
        assert!(moved.is_completed(), "{moved:?}");
        for (now, then) in simulator.state().iter().zip(&state) {
            assert!((now - then).abs() < 1e-9, "key {key}: {now} was {then}");
        }
    }
}

#[track_caller]
fn rests_as_by_hand<M, const N: usize>(name: &str, written: &M, inputs: &[f64])
where
    M: Described<State = [f64; N]>,
    Run<N>: Clone,
{
    let described: Run<N> = model(described(&shipped(name)), (0, 0));
    for input in inputs {
        let (mode, state) = written.at_rest(&still(*input));
        let mode = ModeNumber(written.mode_code(mode).structure());
        let RestPose { mode: own, state: found, imbalance } = described.rest_pose(&still(*input));
        assert_eq!(own, mode, "{name} at {input}: {found:?}");
        assert_eq!(imbalance, None);
        for (a, b) in found.iter().zip(&state) {
            assert!((a - b).abs() < 1e-9, "{name} at {input}: {found:?}, not {state:?}");
        }
    }
}

#[test]
fn the_mode_at_rest_is_the_one_that_holds_under_the_input() {
    rests_as_by_hand("cart-pendulum", &CartPendulum::default(), &[0.0, 0.03, 0.09, -0.2]);
    rests_as_by_hand("reduced-grand", &ReducedGrand::default(), &[0.0, 1e-3, 5e-3]);
    // It has no states: one more entry stays 0.
    let wall: Run<1> = model(described(&shipped("spring-wall")), (0, 0));
    for input in [0.0, 4e-3, 9e-3, 20e-3] {
        let written = SpringWall::default();
        let mode = written.mode_code(written.at_rest(&still(input)).0).structure();
        assert_eq!(wall.at_rest(&still(input)).0, ModeNumber(mode), "at {input}");
    }
}

#[test]
fn a_condition_on_the_parameters_decides_the_mode_at_rest() {
    let rests = |preset| {
        let ball: Run<2> = model(described(&shipped("bouncing-ball")), (preset, 0));
        ball.at_rest(&still(0.0)).0
    };
    assert_eq!([rests(0), rests(1)], [ModeNumber(0), ModeNumber(1)], "one drops, one lies");
}

#[test]
fn a_rest_that_nothing_holds_is_a_mistake_of_its_line() {
    let start = BEAM.find("[contacts]").unwrap();
    let end = BEAM.find("[rest]").unwrap();
    let falling = format!("{}{}", &BEAM[..start], &BEAM[end..]);
    let says = |text: &str, parts: &[&str]| {
        let said = derive_model("beam.toml", text, &NoBases).map(|_| ());
        let said = said.unwrap_err().to_string();
        for part in parts {
            assert!(said.contains(part), "{said} lacks {part}");
        }
    };
    says(
        &falling,
        &["beam.toml:18:2", "nothing holds y' at rest", "changes by 9.810 m/s per second"],
    );
    let starts = falling.replace("[rest]", "[rest]\nstart = true");
    assert!(derive_model("beam.toml", &starts, &NoBases).is_ok());
    let unsaid = &falling[..falling.find("[rest]").unwrap()];
    assert!(derive_model("beam.toml", unsaid, &NoBases).is_ok(), "it is not said that it rests");
    // With one felt it turns until its centre is below it.
    let hanging = BEAM.replace("gap = \"y(right)\"", "gap = \"y(right) + 5 m\"");
    says(&hanging, &["beam.toml:22:2", "rests at turn = -1.57", "out of its range"]);
}
