//! The paper's models A and B, derived from their bodies, beside those written by hand.

use hand_written::key_hammer::{PARAMETERS, PRESETS};
use hand_written::{KeyHammerRigid, KeyHammerSprings};
use kane::mechanism::Target;
use models::Described as _;

use crate::builder::MechanismBuilder;
use crate::evaluation::{Derived, Numbers};
use crate::hand_written::Pair;

/// Values of a preset, with damping and losses unlike those of any.
fn values(preset: usize) -> Vec<f64> {
    let mut values: Vec<f64> =
        (0..PARAMETERS.len()).map(|i| (PRESETS[preset].value)(i, 40)).collect();
    for (i, parameter) in PARAMETERS.iter().enumerate() {
        match parameter.name {
            "b1" => values[i] += 0.013,
            "c2" => values[i] += 0.3,
            "restitution" => values[i] = 0.6,
            _ => {}
        }
    }
    values
}

/// Key and hammer on their pivots.
fn key_and_hammer(preset: usize, coordinates: &[&str]) -> MechanismBuilder {
    let values = values(preset);
    let parameters: Vec<_> = PARAMETERS.iter().map(|it| it.name).zip(values).collect();
    let mut m = MechanismBuilder::new(&parameters, coordinates);
    m.gravity(&["0", "-g"]);
    let key = m.frame(0, &["0", "0"], "theta_k");
    m.body(key, "M1", &["cK"], "JK - M1*cK^2");
    let hammer = m.frame(0, &["L3", "L4"], "theta_h");
    m.body(hammer, "M2", &["L2"], "JH - M2*L2^2");
    m.define("gap", "L4*cos(theta_h) - L3*sin(theta_h) - L1*sin(theta_k - theta_h)");
    m
}

/// The string turns the hammer round.
fn string(m: &mut MechanismBuilder, mode: usize) {
    let set = [
        (Target::Coordinate(0), m.e("string_angle")),
        (Target::Speed(0), m.e("-restitution*theta_h'")),
    ];
    m.guard(mode, "string", "string_angle - theta_h", mode).branches[0].set = set.to_vec();
}

pub(crate) fn model_b(preset: usize) -> MechanismBuilder {
    let mut m = key_and_hammer(preset, &["theta_h", "theta_k", "q3", "q4"]);
    m.force("k1", "s - theta_k", "k1*stretch + b1*rate", "k1*stretch^2/2");
    let contact = m.force("k2", "q4", "k2*q4*max(0, 1 + c2*q4')", "k2*q4^2/2");
    let x = m.constraint("loop_x", "L1*cos(theta_k) + q4*sin(theta_k) - L3 - q3*cos(theta_h)");
    let y = m.constraint("loop_y", "L1*sin(theta_k) - q4*cos(theta_k) - L4 - q3*sin(theta_h)");
    m.mode("B1", &[x, y]);
    m.mode("B2", &[x, y]);
    m.it.modes[1].forces.retain(|force| *force != contact);
    m.guard(0, "release", "q4*cos(theta_k - theta_h)", 1);
    string(&mut m, 0);
    m.guard(1, "land", "gap", 0);
    string(&mut m, 1);
    m
}

pub(crate) fn model_a(preset: usize) -> MechanismBuilder {
    let mut m = key_and_hammer(preset, &["theta_h", "theta_k"]);
    let key = m.constraint("key", "theta_k - s");
    let contact =
        m.constraint("contact", "L4*cos(theta_h) - L3*sin(theta_h) - L1*sin(theta_k - theta_h)");
    let on_key = m.mode("A1", &[key, contact]);
    m.solved(on_key, 0, "atan2(L1*sin(s) - L4, L1*cos(s) - L3)");
    let apart = m.mode("A2", &[key]);
    m.guard(on_key, "release", "reaction_contact", apart);
    m.guard(apart, "land", "gap", on_key);
    string(&mut m, apart);
    m
}

#[test]
fn model_b_is_the_one_by_hand() {
    for preset in 0..PRESETS.len() {
        let derived = Derived::from(model_b(preset));
        assert_eq!(derived.system.state.len(), 4);
        let hand = KeyHammerSprings::default().with_values(&derived.values);
        // By hand the hammer's height is over its pivot.
        let [m2, g, l4] = [5, 11, 3].map(|i| derived.values[i]);
        let more_energy = m2 * g * l4;
        let pair = Pair { hand, derived, more_energy };
        let mut numbers = Numbers::new(5);
        for _ in 0..50 {
            let [h, k, u, v] = numbers.list::<4>();
            let x = [0.8 * h, 0.6 * k, 5.0 * u, 5.0 * v];
            let input = numbers.list::<4>();
            for mode in 0..2 {
                pair.compare(mode, &x, input);
                pair.compare_reset(mode, 0, &x, input);
                pair.compare_reset(mode, 1, &x, input);
            }
        }
    }
}

#[test]
fn model_a_is_the_one_by_hand() {
    for preset in 0..PRESETS.len() {
        let derived = Derived::from(model_a(preset));
        assert_eq!(derived.system.state.len(), 2);
        let hand = KeyHammerRigid::default().with_values(&derived.values);
        // By hand the hammer's height is over its pivot.
        let [m2, g, l4] = [5, 11, 3].map(|i| derived.values[i]);
        let more_energy = m2 * g * l4;
        let pair = Pair { hand, derived, more_energy };
        let mut numbers = Numbers::new(6);
        for _ in 0..50 {
            let input = numbers.list::<4>().map(|it| 0.7 * it);
            let x = numbers.list::<2>();
            pair.compare(1, &x, input);
            pair.compare_reset(1, 1, &x, input);
            let on_key = pair.derived.consistent(0, &x, input);
            pair.compare(0, &[on_key[0], on_key[1]], input);
            pair.compare_reset(0, 0, &[on_key[0], on_key[1]], input);
            // It lands where the gap is 0, at any speed.
            pair.compare_reset(1, 0, &[on_key[0], x[1]], input);
        }
    }
}
