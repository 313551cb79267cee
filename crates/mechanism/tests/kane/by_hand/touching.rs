use mechanism::kane::assemble::Program;
use mechanism::kane::mechanism::{DryFriction, MechanismContact};
use mechanism::kane::system::{ContactEquations, FrictionEquations};

use super::Draft;

/// Parameters m, g, k: a contact without friction, with the force k times its depth.
pub fn falling() -> Program {
    let mut draft = Draft::new(&[("m", 2.0), ("g", 9.81), ("k", 5e3)], &["y"]);
    let [m, g, k] = ["m", "g", "k"].map(|name| draft.parameter(name));
    let [y, v] = draft.state(0);
    let graph = draft.graph();
    let zero = graph.constant(0.0);
    let per_mass = graph.power(m, -1);
    let fall = graph.negate(g);
    let push = graph.multiply(k, y);
    let push = graph.negate(push);
    let energy = graph.product(&[(k, 1), (y, 2)]);
    let energy = graph.scale(energy, 0.5);
    let moving = graph.product(&[(m, 1), (v, 2)]);
    let height = graph.product(&[(m, 1), (g, 1), (y, 1)]);
    let own = graph.sum(&[(moving, 0.5), (height, 1.0)]);
    let mode = draft.mode("only", &[v, fall]);
    mode.energy = Some(own);
    mode.contacts.push(ContactEquations {
        contact: 0,
        gap: Some([y, v]),
        normal: Some([push, energy, zero]),
        normal_response: vec![zero, per_mass],
        normal_readout: None,
        sounds: None,
        friction: None,
    });
    let name = "spring".to_owned();
    let contact = MechanismContact {
        name,
        gap: Some(y),
        scale: 0.01,
        force: None,
        friction: None,
        sounds: None,
    };
    draft.mechanism.contacts.push(contact);
    draft.program()
}

/// Parameters m, k, stiction, kinetic: a mass on a bearing, drawn through a spring by the input.
pub fn drawn() -> Program {
    let parameters = [("m", 0.5), ("k", 80.0), ("stiction", 2.0), ("kinetic", 1.5)];
    let mut draft = Draft::new(&parameters, &["x"]);
    let [m, k, stiction, kinetic] =
        ["m", "k", "stiction", "kinetic"].map(|name| draft.parameter(name));
    let [x, v] = draft.state(0);
    let [s, rate, ..] = draft.input();
    let graph = draft.graph();
    let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
    let per_mass = graph.power(m, -1);
    let stretch = graph.subtract(s, x);
    let pull = graph.multiply(k, stretch);
    let acceleration = graph.divide(pull, m);
    let supplied = graph.multiply(pull, rate);
    let moving = graph.product(&[(m, 1), (v, 2)]);
    let stored = graph.product(&[(k, 1), (stretch, 2)]);
    let energy = graph.sum(&[(moving, 0.5), (stored, 0.5)]);
    let mode = draft.mode("only", &[v, acceleration]);
    (mode.readout, mode.supplied, mode.energy) = (Some(pull), Some(supplied), Some(energy));
    mode.contacts.push(ContactEquations {
        contact: 0,
        gap: None,
        normal: None,
        normal_response: Vec::new(),
        normal_readout: None,
        sounds: None,
        friction: Some(FrictionEquations {
            slip: v,
            gradient: vec![zero, one],
            drift: zero,
            response: vec![zero, per_mass],
            readout: zero,
            stiction,
            kinetic,
        }),
    });
    let (name, scales) = ("bearing".to_owned(), (2.0, 0.1));
    let friction = DryFriction { name: name.clone(), slip: v, stiction, kinetic, scales };
    let friction = Some(friction);
    let contact =
        MechanismContact { name, gap: None, scale: 1.0, force: None, friction, sounds: None };
    draft.mechanism.contacts.push(contact);
    draft.program()
}
