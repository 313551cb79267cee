//! Values of expressions, against numbers computed by hand.

use mechanism::kane::graph::{Node, Place};
use mechanism::kane::mechanism::Mechanism;
use mechanism::kane::tape::{Argument, ArgumentLayout, Tape, TapeArguments};

use super::{WEIGHT, good};

const SPRINGS: &str = include_str!("../../../../instruments/src/key_hammer_springs/model.toml");

/// Returns `node` with the default preset's values of key 0; state, then accelerations.
#[track_caller]
pub(super) fn value(mechanism: &Mechanism, node: Node, state: &[f64], input: [f64; 4]) -> f64 {
    let mut layout = ArgumentLayout::default();
    layout.place(Place::Key, Argument::Extra(0));
    for index in 0..64 {
        layout.place(Place::Parameter(index), Argument::Constant(index));
        layout.place(Place::Coordinate(index), Argument::State(index));
        let speed = index + u16::try_from(mechanism.coordinates.len()).expect("few");
        layout.place(
            Place::Speed(speed - u16::try_from(mechanism.coordinates.len()).expect("few")),
            Argument::State(speed),
        );
    }
    for order in 0..4 {
        layout.place(Place::Input(order), Argument::Input(order));
    }
    let graph = &mechanism.graph;
    let values =
        Tape::lower(graph, &layout, &mechanism.instrument.presets[0].values).expect("of the key");
    let constants = values.evaluate(&TapeArguments { extra: &[0.0], ..TapeArguments::default() });
    let tape = Tape::lower(graph, &layout, &[node]).expect("over the state");
    tape.evaluate(&TapeArguments { constants: &constants, state, input, extra: &[] })[0]
}

#[track_caller]
fn weight(expression: &str, state: [f64; 2], input: [f64; 4]) -> f64 {
    let text = WEIGHT.replacen(
        "{ unit = \"m\", value = \"y(P)\" }",
        &format!("{{ value = \"{expression}\" }}"),
        1,
    );
    let mechanism = good(&text).mechanism;
    value(&mechanism, mechanism.outputs[1].values[0], &state, input)
}

#[test]
fn expressions_follow_the_usual_rules() {
    let still = |expression: &str| weight(expression, [0.0; 2], [0.0; 4]);
    assert_eq!(still("1 + 2*3^2"), 19.0);
    assert_eq!(still("-2^2"), -4.0);
    assert_eq!(still("2^3^2"), 512.0);
    assert_eq!(still("2^-1"), 0.5);
    assert_eq!(still("8/2/2"), 2.0);
    assert_eq!(still("1 - 2 - 3"), -4.0);
    assert_eq!(still("2 m * m0"), 0.2);
    assert_eq!(still("2 m*kg"), 2.0);
    assert_eq!(still("3 m + 5 mm"), 3.005);
    assert_eq!(still("if(2 > 1, 10, 20) + if(2 < 1, 1, 2)"), 12.0);
    assert_eq!(still("max(1, 2) - min(1, 2) + abs(-3) + sign(-2)"), 3.0);
    assert_eq!(still("hypot(3 m, 4 m)"), 5.0);
    assert_eq!(still("sqrt(16 m^2)"), 4.0);
    assert_eq!(still("atan2(1 m, 1 m)"), std::f64::consts::FRAC_PI_4);
    assert_eq!(still("cos(180 deg)"), -1.0);
    assert!((still("tan(30 deg)") - 1.0 / 3f64.sqrt()).abs() < 1e-15);
    assert_eq!(still("0 + y"), 0.0);
}

#[test]
fn primes_are_rates_along_the_motion() {
    // y = 0.3, y' = -2; s = 0.1, s' = 0.7, s'' = 5.
    let moving = |expression: &str| weight(expression, [0.3, -2.0], [0.1, 0.7, 5.0, 0.0]);
    assert_eq!(moving("y'"), -2.0);
    assert!((moving("stretch") - 0.2).abs() < 1e-15);
    assert_eq!(moving("stretch'"), -2.7);
    assert_eq!(moving("fall"), -2.7);
    assert_eq!(moving("s''"), 5.0);
    assert!((moving("rate(y*s)") - (-2.0 * 0.1 + 0.3 * 0.7)).abs() < 1e-15);
    assert_eq!(moving("rate(y(P))"), -2.0);
    assert!((moving("force(spring)") - (20.0 * 0.2 - 2.7)).abs() < 1e-12);
}

#[test]
fn a_force_is_zero_in_modes_without_it() {
    let mechanism = good(SPRINGS).mechanism;
    let force = &mechanism.outputs[0];
    let state = [0.1, 0.2, 0.3, 0.01, 0.0, 0.0, 0.0, 0.0];
    assert_eq!(value(&mechanism, force.values[0], &state, [0.0; 4]), 15.0 * 0.01);
    assert!(mechanism.graph.is_zero(force.values[1]));
    assert_eq!(mechanism.modes[0].forces, [0, 1]);
    assert_eq!(mechanism.modes[1].forces, [0]);
}

/// F = k dⁿ (1 + c d') by hand; energy k dⁿ⁺¹/(n + 1).
#[test]
fn a_felt_pushes_only() {
    let felt = "[felts]\nfelt = { compression = \"0.5 m - y\", stiffness = \"8 N/m^2.5\", exponent = 2.5, damping = \"0.3 s/m\" }\n[constraints]";
    let mechanism = good(&WEIGHT.replacen("[constraints]", felt, 1)).mechanism;
    let felt = &mechanism.forces[1];
    let at = |node: Node, y: f64, v: f64| value(&mechanism, node, &[y, v], [0.0; 4]);
    let depth = 0.2f64;
    let expected = 8.0 * depth.powf(2.5) * (1.0 + 0.3 * 1.5);
    assert!((at(felt.tension, 0.3, -1.5) - expected).abs() < 1e-14);
    assert!((at(felt.energy, 0.3, -1.5) - 8.0 * depth.powf(3.5) / 3.5).abs() < 1e-15);
    assert_eq!(at(felt.tension, 0.3, 9.0), 0.0);
    assert_eq!(at(felt.tension, 0.6, 1.0), 0.0);
}

#[test]
fn points_are_placed_by_all_frames_below_them() {
    let frames = "[frames]\nA = { turn = \"0.3 rad\", axis = \"x\" }\nB = { in = \"A\", origin = [\"1 m\", \"2 m\", \"3 m\"], turn = \"0.7 rad\" }\nC = { in = \"B\", turn = \"y/(1 m)\", axis = \"z\" }";
    let text = WEIGHT.replacen("[frames]", frames, 1).replacen(
        "[points]",
        "[points]\nQ = { in = \"C\", at = [\"2 m\", \"0 m\", \"1 m\"] }",
        1,
    );
    let of = |axis: &str| {
        let text = text.replacen("\"y(P)\"", &format!("\"{axis}(Q)\""), 1);
        let mechanism = good(&text).mechanism;
        value(&mechanism, mechanism.outputs[1].values[0], &[0.4, 0.0], [0.0; 4])
    };
    let (s, c) = (0.7f64 + 0.4).sin_cos();
    let [x, y, z] = [1.0 + 2.0 * c, 2.0 + 2.0 * s, 3.0 + 1.0];
    let (s, c) = 0.3f64.sin_cos();
    let expected = [x, y * c - z * s, y * s + z * c];
    for (axis, expected) in ["x", "y", "z"].into_iter().zip(expected) {
        assert!((of(axis) - expected).abs() < 1e-14, "{axis}");
    }
}

#[test]
fn one_way_stands_for_a_list_of_one() {
    let derived = |text: &str| {
        let model = mechanism::kane::derive_model("a file", text, &());
        let program = model.expect("a model").program;
        (program.table, program.functions)
    };
    let table = SPRINGS.replace("to = \"B2\"", "to = { mode = \"B2\" }");
    assert_ne!(table, SPRINGS);
    assert_eq!(derived(&table), derived(SPRINGS));
}
