use mechanism::kane::graph::Place;
use serde_json::{Map, Value, json};

use crate::kane::evaluation::{Derived, Numbers};

const STATES: usize = 5;

const MECHANISMS: [&str; 5] =
    ["key_hammer_rigid", "key_hammer_springs", "cart_pendulum", "bouncing_ball", "reduced_grand"];

pub(super) fn cases() -> Vec<Value> {
    let mut all = Vec::new();
    let mut numbers = Numbers::new(21);
    for folder in MECHANISMS {
        let presets = Derived::built_in(folder, 0).system.mechanism.instrument.presets.len();
        for preset in [0, presets - 1] {
            let mut derived = Derived::built_in(folder, preset);
            unlike_any_preset(&mut derived);
            for mode in 0..derived.system.modes.len() {
                all.push(case(&derived, mode, &mut numbers));
            }
        }
    }
    all
}

/// Damping that no preset has, so that no term is missing.
fn unlike_any_preset(derived: &mut Derived) {
    let parameters = derived.system.mechanism.parameters.iter();
    for (parameter, value) in parameters.zip(&mut derived.values) {
        match parameter.name.as_str() {
            "b" | "b1" | "c2" => *value += 0.17,
            "inertia" => *value += 0.003,
            _ => {}
        }
    }
}

fn case(derived: &Derived, mode: usize, numbers: &mut Numbers) -> Value {
    let mechanism = &derived.system.mechanism;
    let parameters = mechanism.parameters.iter().zip(&derived.values);
    let parameters: Map<_, _> =
        parameters.map(|(it, value)| (it.name.clone(), json!(value))).collect();
    let states: Vec<_> = (0..STATES).map(|_| state(derived, mode, numbers)).collect();
    json!({
        "model": mechanism.name, "mode": mechanism.modes[mode].name, "parameters": parameters,
        "states": states,
    })
}

fn state(derived: &Derived, mode: usize, numbers: &mut Numbers) -> Value {
    let mechanism = &derived.system.mechanism;
    let names: Vec<_> = derived.system.state.iter().map(|place| entry(derived, *place)).collect();
    let guess: Vec<_> = names
        .iter()
        .map(|(name, (low, high))| {
            let part = 0.5 * numbers.next();
            // Range of model C's key between let-off and bed.
            let (low, high) = if name == "y" && mechanism.name == "reduced-grand" {
                (0.0045, 0.0125)
            } else {
                (low.max(-20.0), high.min(20.0))
            };
            f64::midpoint(low, high) + part * (high - low)
        })
        .collect();
    let input = [0.2, 1.0, 10.0, 100.0].map(|size| size * numbers.next());
    let x = derived.consistent(mode, &guess, input);
    let equations = &derived.system.modes[mode];
    let rates = derived.derivative(mode, &x, input);
    let mut found = Map::new();
    for (index, (name, _)) in names.iter().enumerate().skip(derived.system.coordinates) {
        found.insert(format!("{name}'"), json!(rates[index]));
    }
    let outputs = derived.all(&equations.outputs, &x, input);
    // Outputs with a point place drawn frames.
    let named = mechanism.outputs.iter().zip(outputs);
    for (output, value) in named.filter(|(output, _)| !output.name.contains('.')) {
        found.insert(output.name.clone(), json!(value));
    }
    let readout = derived.one(equations.readout.expect("a readout"), &x, input);
    found.insert("readout".to_owned(), json!(readout));
    let state: Map<_, _> =
        names.into_iter().zip(&x).map(|((name, _), value)| (name, json!(value))).collect();
    json!({ "state": state, "input": input, "found": found })
}

fn entry(derived: &Derived, place: Place) -> (String, (f64, f64)) {
    let mechanism = &derived.system.mechanism;
    if let Place::Coordinate(i) = place {
        let it = &mechanism.coordinates[usize::from(i)];
        return (it.name.clone(), it.range);
    }
    let Place::Speed(i) = place else { panic!("{place:?} in a state") };
    let it = &mechanism.speeds[usize::from(i)];
    (it.name.clone(), it.range)
}
