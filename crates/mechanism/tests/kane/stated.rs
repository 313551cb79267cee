//! Stated properties of described models, against their behaviour.

use instruments::equations::ModeNumber;
use pode::contacts::{ContactMode, ContactSet, ContactState, WithContacts};
use pode::stepper::{Rk4, VelocityVerlet};
use pode::{
    Limits, Model as _, Motion, Silent, Simulator, Sloped as _, Stepper, differenced_slopes,
};

use crate::kane::runnable::{BALL, CART, RIGID, Run, described, model, shipped};

const MASS: &str = r#"
name = "mass"
summary = "a mass on a spring, and a felt that the input presses"
[input]
name = "s"
unit = "m"
per_metre = "1"
[coordinates]
y = { unit = "m", range = ["-1 m", "1 m"], speed_range = ["-1 m/s", "1 m/s"] }
[frames]
B = { origin = ["0 m", "y"] }
[bodies]
mass = { frame = "B", mass = "0.1 kg" }
[springs]
spring = { stretch = "y", stiffness = "400 N/m" }
"#;

fn swung<const N: usize>(stepper: impl Stepper, text: &str) -> [f64; 2] {
    let it: Run<N> = model(described(text), (0, 0));
    let mut x = [0.0; N];
    x[0] = 0.01;
    let mut simulator = Simulator::new(it, stepper, Limits::default(), ModeNumber(0), x);
    let still = |_: f64| Motion::default();
    assert!(simulator.run(1.0, 1e-3, still, &mut Silent).is_completed());
    [simulator.state()[0], simulator.state()[1]]
}

#[test]
fn methods_that_step_places_and_speeds_in_turn_know_which_are_which() {
    // With room for more states the speeds do not begin in the middle of the room.
    let exact = 0.01 * (400.0_f64 / 0.1).sqrt().cos();
    let [one, other] = [swung::<2>(VelocityVerlet, MASS), swung::<5>(VelocityVerlet, MASS)];
    assert_eq!(one, other);
    assert!((one[0] - exact).abs() < 1e-4, "{one:?}, not {exact}");
    assert_eq!(swung::<2>(Rk4, MASS), swung::<5>(Rk4, MASS));
}

#[test]
fn slopes_with_contacts_are_those_of_what_is_closed() {
    let text = format!(
        "{MASS}[contacts]\npress = {{ gap = \"y - s\", stiffness = \"2e6 N/m^2\", exponent = 2, damping = \"3 s/m\" }}\n"
    );
    let it = WithContacts::new(model::<2>(described(&text), (0, 0)))
        .unwrap_or_else(|it| panic!("{it:?}"));
    let (x, input) = ([0.001, 0.2], Motion { position: 0.0025, rate: -0.05, ..Motion::default() });
    let mode =
        |state| ContactMode { structure: ModeNumber(0), contacts: ContactSet::OPEN.with(0, state) };
    let open = it.slopes(mode(ContactState::Open), &x, &input);
    assert_eq!((open.per_position, open.per_rate), (0.0, 0.0));
    // F = K d² (1 + c d') pushes the mass, and the input back.
    let (depth, rate) = (0.0015, -0.25);
    let closed = it.slopes(mode(ContactState::Closed), &x, &input);
    let per_position = 2.0 * 2e6 * depth * (1.0 + 3.0 * rate);
    assert!((closed.per_position - per_position).abs() < 1e-9 * per_position, "{closed:?}");
    assert!((closed.per_rate - 2e6 * depth * depth * 3.0).abs() < 1e-9, "{closed:?}");
    let differences = differenced_slopes(&it, mode(ContactState::Closed), &x, &input);
    assert!((closed.per_position - differences.per_position).abs() < 1e-5 * per_position);
    assert!((closed.per_rate - differences.per_rate).abs() < 1e-5);
}

#[test]
fn events_move_a_state_as_far_as_a_description_allows() {
    const ANY: f64 = f64::INFINITY;
    // The walls are at rest. Noise of 0.1 mm of the key moves the floor, 5 times as fast, by a
    // tenth of 2 mm, and the hammer by 0.02 rad; one that the key pushed through the string may
    // rotate by more than half a turn and land from behind.
    let cart = CART.model::<4>("default", 0, &[]);
    let ball = BALL.model::<2>("key", 0, &[]);
    let rigid = RIGID.model::<2>("paper", 0, &[]);
    let longest = |nature: pode::Nature| nature.longest_projection;
    assert_eq!([0, 1, 2].map(|it| longest(cart.nature(ModeNumber(it)))), [ANY, 1e-4, 1e-4]);
    assert_eq!([0, 1].map(|it| longest(ball.nature(ModeNumber(it)))), [ANY, 2e-3 * 5.0]);
    assert_eq!([0, 1].map(|it| longest(rigid.nature(ModeNumber(it)))), [4.0, ANY]);
}

#[test]
fn guards_have_the_units_that_follow_from_their_expressions() {
    let cart = described(&shipped("cart-pendulum"));
    let units =
        cart.program.table.modes.iter().flat_map(|mode| mode.guards.iter().map(|it| it.unit));
    assert_eq!(units.collect::<Vec<_>>(), ["m", "m", "N", "N"]);
}
