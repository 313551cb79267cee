use instruments::equations::ModeNumber;
use mechanism::kane::derive_model;
use pode::contacts::WithContacts;
use pode::stepper::Rk4;
use pode::{Limits, Silent, Simulator};

use crate::kane::runnable::{self, CART, Run, WALL, described, model, shipped};
use crate::kane::stroke::still;

/// Beam on two felts, its weight nearer to the left one; it starts above both.
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

#[test]
fn the_mode_at_rest_is_the_one_that_holds_under_the_input() {
    // The pendulum hangs, and the cart is where the spring is slack, or at the wall before that.
    let cart = CART.model::<4>("default", 0, &[]);
    for (input, mode) in [(0.0, "free"), (0.03, "free"), (0.09, "right"), (-0.2, "left")] {
        let pose = cart.rest_pose(&still(input));
        assert_eq!((runnable::mode_name(&cart, pose.mode), pose.imbalance), (mode, None));
        let expected = [f64::clamp(input, -0.05, 0.05), 0.0, 0.0, 0.0];
        for (a, b) in pose.state.iter().zip(expected) {
            assert!((a - b).abs() < 1e-9, "at {input}: {:?}", pose.state);
        }
    }
    // It has no states: one more entry stays 0.
    let wall = WALL.model::<1>("default", 0, &[]);
    for (input, mode) in [(0.0, 0), (4e-3, 0), (9e-3, 1), (20e-3, 1)] {
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
        let said = derive_model("beam.toml", text, &()).map(|_| ());
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
    assert!(derive_model("beam.toml", &starts, &()).is_ok());
    let unsaid = &falling[..falling.find("[rest]").unwrap()];
    assert!(derive_model("beam.toml", unsaid, &()).is_ok(), "it is not said that it rests");
    // With one felt it turns until its centre is below it.
    let hanging = BEAM.replace("gap = \"y(right)\"", "gap = \"y(right) + 5 m\"");
    says(&hanging, &["beam.toml:22:2", "rests at turn = -1.57", "out of its range"]);
}
